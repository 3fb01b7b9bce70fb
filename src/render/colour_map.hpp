// From numbers to colours.
#pragma once

#include <surpass/render.hpp>

#include "render/vector.hpp"

namespace surpass::picture {

/// Linear light for a value of the field: by its place between the field's ends, which values
/// beyond them share; grey for NaN. Equal steps of the value look about equally large.
[[nodiscard]] Colour colour_of(double value, const ColourField& field);

}  // namespace surpass::picture
