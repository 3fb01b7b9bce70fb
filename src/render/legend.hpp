// The scale of a field's colours, a strip to the right of the picture.
#pragma once

#include <surpass/render.hpp>

namespace surpass::picture {

/// Pixels that the strip takes of a picture of this size: 0 where the picture is too small for one,
/// or the field wants none.
[[nodiscard]] int legend_width(const RenderOptions& options);

/// The strip, as high as the picture: a bar of the colours from `low` at its foot to `high`, with
/// numbers beside it and the field's title above.
[[nodiscard]] Image draw_legend(const ColourField& field, int width, int height);

}  // namespace surpass::picture
