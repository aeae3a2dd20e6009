#include "special_configuration.hpp"

#include <fmt/format.h>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

bool are_parallel(Point u, Point v) {
  return std::abs(cross(u, v)) <= tolerance::collinear_links * std::abs(u) * std::abs(v);
}

void add_of_side_link(const FourBar& bars, std::string_view link, std::string_view other, std::vector<Notice>& notes) {
  const Point side = bars.input_moving - bars.input_fixed;
  const auto note = [&](std::string code, std::string_view words) {
    notes.push_back({std::move(code),
                     fmt::format(fmt::runtime(words), fmt::arg("link", link), fmt::arg("other", other)),
                     {{"link", link}, {"other", other}}});
  };
  if (are_parallel(side, bars.output_fixed - bars.input_fixed))
    note("side_link_on_frame_line",
         "the {link} lies on the frame line, so that the pole is the fixed pivot of the {other}, whose moving pivot "
         "lies on the pole tangent; the circling-point curve is the pole tangent and a circle");
  if (are_parallel(side, bars.output_moving - bars.input_moving))
    note("side_link_in_line_with_coupler",
         "the {link} lies in line with the coupler, so that the pole is the moving pivot of the {other}, whose fixed "
         "pivot lies on the pole tangent; the centering-point curve is the pole tangent and a circle, and Ball's point "
         "falls on the pole, unless the whole inflection circle is stationary");
}

}  // namespace

std::vector<Notice> special_configurations(const FourBar& bars) {
  const Point input = bars.input_moving - bars.input_fixed, output = bars.output_moving - bars.output_fixed,
              frame = bars.output_fixed - bars.input_fixed, coupler = bars.output_moving - bars.input_moving;
  const bool has_parallel_sides = are_parallel(input, output), is_coupler_parallel = are_parallel(coupler, frame);
  if (has_parallel_sides && are_parallel(input, frame)) return {};
  if (has_parallel_sides && is_coupler_parallel)
    return {
        {"parallelogram",
         "the linkage is a parallelogram, whose coupler moves along a circle without turning: all its points have the "
         "same curvature, and there is no inflection line",
         {}}};
  if (has_parallel_sides && are_parallel(input, coupler * Point{0, 1}))
    return {{"parallel_side_links_across_coupler",
             "the side links are parallel and at right angles to the coupler, which does not turn now: the pole is at "
             "infinity, the inflection circle is a line, and every point of it has four-point contact with its tangent",
             {}}};
  if (has_parallel_sides)
    return {
        {"parallel_side_links",
         "the side links are parallel, so that the coupler does not turn now: the pole is at infinity, the inflection "
         "circle is a line, and the cubic of stationary curvature is an equilateral hyperbola",
         {}}};
  std::vector<Notice> notes;
  add_of_side_link(bars, "input", "output", notes);
  add_of_side_link(bars.swapped(), "output", "input", notes);
  if (is_coupler_parallel)
    notes.push_back(
        {"coupler_parallel_to_frame",
         "the coupler is parallel to the frame, so that the pole normal is a part of both curves of stationary "
         "curvature, and Ball's point is the inflection pole",
         {}});
  return notes;
}

}  // namespace linkwright
