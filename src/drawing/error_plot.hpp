#pragma once

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/function/generated_function.hpp"
#include "linkwright/function/wanted_function.hpp"

namespace linkwright {

/// The structural error over the input: generated less wanted output, degrees, with the precision points on the zero
/// line and the largest error marked; inputs that the drive does not reach are hatched. `box`: of the curve; numbers
/// stand left of it and below it (44 and 34 px), the heading above (18 px). `wanted` with its free parameter fixed.
void draw_error_plot(SvgCanvas& svg, const PixelBox& box, const FunctionError& error, const WantedFunction& wanted);

/// The same of pairs alone, between which nothing is wanted: the output over the input, the pairs marked.
void draw_output_plot(SvgCanvas& svg, const PixelBox& box, const GeneratedFunction& generated,
                      const WantedFunction& wanted);

}  // namespace linkwright
