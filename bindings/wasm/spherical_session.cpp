#include "spherical_session.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/improved_linkage.hpp"
#include "reply_json.hpp"
#include "spherical_reply.hpp"
#include "spherical_travel.hpp"

namespace linkwright::wasm {
namespace {

constexpr int samples_of_the_map = 400;  // as solve() takes, so that the map's cells are its own

void append(std::vector<double>& numbers, Vector3 v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

std::uint8_t branch_at(const std::vector<CurveBranch>& branches, double coordinate) {
  std::uint8_t at = 0;
  for (std::size_t b = 0; b < branches.size(); ++b)
    if (coordinate >= branches[b].from) at = static_cast<std::uint8_t>(b);
  return at;
}

}  // namespace

SphericalSession::SphericalSession(const SphericalMotionTask& task) : task_(task), given_(task_family(task_)) {}

bool SphericalSession::serves(const Problem& problem) const {
  const auto* spherical = std::get_if<SphericalMotionTask>(&problem.task);
  return spherical && *spherical == task_;
}

const Notice& SphericalSession::no_map() const { return no_spherical_map(given_); }

const Notice& SphericalSession::nothing_on_map() const { return no_spherical_pair(); }

Requirements SphericalSession::with_defaults(Requirements wanted) const {
  return with_default_angles(std::move(wanted));
}

TaskReply SphericalSession::about() const { return about_spherical(given_); }

Drawn SphericalSession::drawn() const {
  DrawnCurves curves;
  if (!given_.family) return {curves, {}};
  const auto& branches = given_.family->axis(Side::input).branches;
  for (const SphericalDyad& dyad : given_.family->polygon(Side::input)) {
    curves.tau.push_back(dyad.coordinate);
    append(curves.center, dyad.fixed_axis);
    append(curves.circle, dyad.moving_axis);
    curves.branch.push_back(branch_at(branches, dyad.coordinate));
  }
  return {curves, {}};
}

ShownAxes SphericalSession::axes(const ExploreRequest& /*request*/, Spacing spacing, const ShownAxes* /*shown*/) const {
  ShownAxes axes;
  if (!given_.family) return axes;
  axes.input.axis = given_.family->axis(Side::input);
  const bool discrete = axes.input.axis.is_discrete();
  axes.input.order = discrete ? DisplayOrder(axes.input.axis.branches)
                              : DisplayOrder(axes.input.axis.branches,
                                             given_.family->samples(Side::input, samples_of_the_map, spacing));
  axes.output = axes.input;
  return axes;
}

std::vector<double> SphericalSession::coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                  Side side) const {
  if (axis.axis.is_discrete()) return given_.family->samples(side, request.samples, Spacing::coordinate);
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  return axis.order.samples(request.samples, from, to);
}

LinkageReply SphericalSession::linkage(MapPoint place, FailureBits fails, bool respect_direction) const {
  constexpr bool verify = false;
  return spherical_reply(given_, make_spherical_four_bar(given_, place, respect_direction, verify), task_.orientations,
                         place, fails);
}

Verification SphericalSession::verify(MapPoint place, bool respect_direction) const {
  constexpr bool by_driving = true;
  const auto found = make_spherical_four_bar(given_, place, respect_direction, by_driving);
  return found ? Verification{found->verified_by_driving, found->residual} : Verification{};
}

std::vector<double> SphericalSession::trace(MapPoint /*place*/, Point /*traced*/, bool /*respect_direction*/) const {
  return {};
}

std::optional<MapPoint> SphericalSession::improved(MapPoint place, const Wish& wish) const {
  return given_.family ? improved_linkage(*given_.family, wish.requirements, wish.objective, place, wish.added)
                       : std::nullopt;
}

int SphericalSession::samples_for_best() const { return samples_of_the_map; }

std::optional<Answer> SphericalSession::answer_at(MapPoint place, bool respect_direction) const {
  constexpr bool verify = true;
  auto found = make_spherical_four_bar(given_, place, respect_direction, verify);
  if (!found) return std::nullopt;
  SphericalMotionAnswer answer;
  answer.task = task_;
  answer.given = given_;
  answer.pattern = given_.pattern;
  answer.condition = given_.conditions.condition();
  answer.linkages = {*std::move(found)};
  return Answer(std::move(answer));
}

void write_best_linkages(JsonWriter& json, const SphericalAnswer& answer) {
  for (const SphericalSolution& found : answer.linkages) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.key("tau");
    write_numbers(json, std::array{found.input.coordinate, found.output.coordinate});
    json.member("type", name(found.report.type));
    json.member("min_transmission_angle_deg", degrees(found.report.min_transmission_angle));
    json.member("min_link_angle_deg", degrees(least_link_angle(found.angles)));
    json.member("driver_sweep_deg", degrees(found.report.sweep));
    for (const char* key : {"link_ratio", "longest", "max_structural_error_deg"}) {
      json.key(key);
      json.null();
    }
    json.key("pivots");
    json.begin_list(JsonWriter::Layout::one_line);
    for (const Vector3 axis : {found.four_bar.input_fixed, found.four_bar.input_moving, found.four_bar.output_fixed,
                               found.four_bar.output_moving})
      write_numbers(json, std::array{axis.x, axis.y, axis.z});
    json.end_list();
    json.end_object();
  }
}

}  // namespace linkwright::wasm
