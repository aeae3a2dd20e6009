#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "files/attitude/space_reader.hpp"
#include "files/json/json.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "spherical_kind.hpp"

namespace linkwright {
namespace {

/// Scaled to unit length, unless rounding is all that it is off: what was written reads back bit-identical.
Vector3 unit_axis(Vector3 axis) {
  constexpr double rounding = 1e-15;
  return std::fabs(dot(axis, axis) - 1) <= rounding ? axis : normalized(axis);
}

std::optional<Vector3> read_axis(const JsonObject& object, std::string_view key) {
  const auto found = object.require(key, {"axis", "the axis [x, y, z]"});
  const auto axis = found ? read_bounded_vector(*found) : std::nullopt;
  if (!axis || norm(*axis) > 0) return axis ? std::optional(unit_axis(*axis)) : std::nullopt;
  found->mistake("no_axis", "this axis has no direction; give one of any length");
  return std::nullopt;
}

/// A linkage whose axes are known: no link without an angle.
std::optional<SphericalFourBar> checked(const SphericalFourBar& bars, const JsonValue& value) {
  if (linkage_type(bars.angles()) != LinkageType::degenerate) return bars;
  value.mistake("degenerate_spherical_four_bar",
                "two axes joined by a link lie in one line; every link of a spherical four-bar has an angle between 0° "
                "and 180°");
  return std::nullopt;
}

std::optional<SphericalFourBar> read_axes(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"input_fixed", "input_moving", "output_moving", "output_fixed"});
  if (!value.is_object()) return std::nullopt;
  const auto input_fixed = read_axis(object, "input_fixed"), input_moving = read_axis(object, "input_moving");
  const auto output_moving = read_axis(object, "output_moving"), output_fixed = read_axis(object, "output_fixed");
  if (!input_fixed || !input_moving || !output_moving || !output_fixed) return std::nullopt;
  return checked({*input_fixed, *input_moving, *output_moving, *output_fixed}, value);
}

/// The linkage of these angles in its own frame, both grounded links along the arc between the fixed axes.
SphericalFourBar in_own_frame(const LinkAngles& angles) {
  const auto along = [](double angle) { return Vector3{std::sin(angle), 0, std::cos(angle)}; };
  return {along(0), along(angles.input), along(angles.ground + angles.output), along(angles.ground)};
}

/// Input angle in the middle of its first range, at right angles to the ground link where it turns fully.
std::optional<SphericalFourBar> laid_out(const LinkAngles& angles, const AngleRange& range) {
  const double input_angle = range.is_full_turn() ? pi / 2 : (range.from + range.to) / 2;
  const auto configuration = assemble(angles, input_angle, Assembly::positive);
  return configuration ? std::optional(placed(in_own_frame(angles), *configuration)) : std::nullopt;
}

/// Four arcs close iff no one is longer than the others, nor any three longer than the fourth and a full turn.
void refuse_to_assemble(const JsonValue& value, const LinkAngles& angles) {
  const auto all = angles.all();
  const double longest = *std::max_element(all.begin(), all.end()),
               shortest = *std::min_element(all.begin(), all.end());
  const double others = angles.sum() - longest, three = angles.sum() - shortest;
  if (longest > others) {
    value.mistake("cannot_be_assembled_on_the_sphere",
                  fmt::format("the longest link ({:g}°) is longer than the other three together ({:g}°), so they do "
                              "not close; shorten it or lengthen another",
                              degrees(longest), degrees(others)),
                  {{"longest", degrees(longest)}, {"others", degrees(others)}});
    return;
  }
  value.mistake("too_long_for_the_sphere",
                fmt::format("the three longest links together ({:g}°) are longer than the shortest and a full turn "
                            "({:g}°), so they do not close; shorten one of them",
                            degrees(three), degrees(shortest + 2 * pi)),
                {{"three", degrees(three)}, {"most", degrees(shortest + 2 * pi)}});
}

std::optional<double> read_link_angle(const JsonObject& object, std::string_view key) {
  const auto found = object.require(key, {"link_angle", "an angle in degrees"});
  const auto angle = found ? found->as_number() : std::nullopt;
  if (!angle || (*angle > 0 && *angle < 180)) return angle ? std::optional(radians(*angle)) : std::nullopt;
  found->mistake("link_angle_range", fmt::format("a link has an angle between 0° and 180°, not {:g}°", *angle),
                 {{"given", *angle}});
  return std::nullopt;
}

std::optional<SphericalFourBar> read_angles(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"ground", "input", "coupler", "output"});
  if (!value.is_object()) return std::nullopt;
  const auto ground = read_link_angle(object, "ground"), input = read_link_angle(object, "input");
  const auto coupler = read_link_angle(object, "coupler"), output = read_link_angle(object, "output");
  if (!ground || !input || !coupler || !output) return std::nullopt;
  const LinkAngles angles{*ground, *input, *coupler, *output};
  const auto ranges = input_ranges(angles);
  const auto bars = ranges.empty() ? std::nullopt : laid_out(angles, ranges.front());
  if (bars) return checked(*bars, value);
  refuse_to_assemble(value, angles);
  return std::nullopt;
}

std::optional<SphericalFourBar> read_dyads(const JsonObject& element, const JsonValue& value, Mistakes& mistakes) {
  std::vector<Vector3> axes;
  for (const std::string_view side : {"input", "output"}) {
    const auto found = element.require(
        side, {"spherical_link", "a grounded link {\"fixed_axis\": [x, y, z], \"moving_axis\": [x, y, z]}"});
    if (!found) continue;
    const JsonObject dyad(*found, mistakes, {});
    if (!found->is_object()) continue;
    for (const std::string_view key : {"fixed_axis", "moving_axis"})
      if (const auto axis = read_axis(dyad, key)) axes.push_back(*axis);
  }
  if (axes.size() != 4) return std::nullopt;
  return checked({axes[0], axes[1], axes[3], axes[2]}, value);
}

}  // namespace

bool says_spherical_four_bar(const JsonValue& value) {
  if (!value.is_object()) return false;
  const auto mechanism = value.json().find("mechanism");
  return mechanism != value.json().end() && *mechanism == "spherical_four_bar";
}

std::optional<SphericalFourBar> read_spherical_four_bar(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject element(value, mistakes, {});
  if (const auto axes = element.find("axes")) return read_axes(*axes, mistakes);
  if (element.find("input") || element.find("output")) return read_dyads(element, value, mistakes);
  if (const auto angles = element.find("angles_deg")) return read_angles(*angles, mistakes);
  value.mistake("no_spherical_linkage",
                "no linkage is given here; add \"axes\", \"angles_deg\", or the linkage of a result file");
  return std::nullopt;
}

}  // namespace linkwright
