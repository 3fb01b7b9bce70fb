// Small text in a picture, drawn in strokes: no font file is needed, and the bits are the same
// everywhere.
#pragma once

#include <surpass/render.hpp>

#include <string_view>

namespace surpass::picture {

/// Width in pixels of text with capitals of this height. Lower-case letters, digits and . - + / are
/// known; all others are blank.
[[nodiscard]] float text_width(std::string_view text, float height);

/// Writes dark text with its base line at y and its left end at x.
void write_text(Image& image, std::string_view text, float x, float y, float height);

}  // namespace surpass::picture
