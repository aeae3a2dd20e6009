#include "spherical_function_session.hpp"

#include <algorithm>
#include <array>

#include "function_reply.hpp"
#include "linkwright/region/improved_linkage.hpp"
#include "reply_json.hpp"
#include "spherical_reply.hpp"

namespace linkwright::wasm {
namespace {

constexpr int cells_of_the_map = 400;  // as solve() takes, so that the map's cells are its own

void append_axis(std::vector<double>& numbers, Vector3 v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

DrawnCurves drawn_links(const SphericalFunctionFamily& family, Side side) {
  DrawnCurves curves;
  const auto& branches = family.axis(Side::input).branches;
  for (const SphericalDyad& dyad : family.polygon(side)) {
    curves.tau.push_back(dyad.coordinate);
    append_axis(curves.center, dyad.fixed_axis);
    append_axis(curves.circle, dyad.moving_axis);
    const auto after = std::find_if(branches.begin(), branches.end(),
                                    [&](const CurveBranch& branch) { return dyad.coordinate < branch.to; });
    curves.branch.push_back(
        static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(after - branches.begin(), std::ssize(branches) - 1)));
  }
  return curves;
}

ShownAxis shown_axis(const SphericalFunctionFamily& family, Side side, Spacing spacing) {
  ShownAxis shown;
  shown.axis = family.axis(side);
  shown.order = shown.axis.is_discrete()
                    ? DisplayOrder(shown.axis.branches)
                    : DisplayOrder(shown.axis.branches, family.samples(side, cells_of_the_map, spacing));
  shown.ticks = axis_ticks(family, side);
  return shown;
}

}  // namespace

SphericalFunctionSession::SphericalFunctionSession(const SphericalFunctionTask& task)
    : task_(task), given_(task_family(task_)), family_(given_.functions) {}

bool SphericalFunctionSession::serves(const Problem& problem) const {
  const auto* function = std::get_if<SphericalFunctionTask>(&problem.task);
  return function && *function == task_;
}

const Notice& SphericalFunctionSession::no_map() const { return no_spherical_map(given_); }

const Notice& SphericalFunctionSession::nothing_on_map() const { return no_spherical_pair(); }

Requirements SphericalFunctionSession::with_defaults(Requirements wanted) const {
  return with_default_angles(std::move(wanted));
}

TaskReply SphericalFunctionSession::about() const {
  TaskReply reply = about_spherical(given_);
  reply.write_function = [this](JsonWriter& json) { write_wanted_function(json, task_); };
  return reply;
}

Drawn SphericalFunctionSession::drawn() const {
  if (!family_) return {};
  return {drawn_links(*family_, Side::input), drawn_links(*family_, Side::output)};
}

ShownAxes SphericalFunctionSession::axes(const ExploreRequest& /*request*/, Spacing spacing,
                                         const ShownAxes* /*shown*/) const {
  if (!family_) return {};
  return {shown_axis(*family_, Side::input, spacing), shown_axis(*family_, Side::output, spacing), false};
}

std::vector<double> SphericalFunctionSession::coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                          Side side) const {
  if (axis.axis.is_discrete()) return family_->samples(side, request.samples, Spacing::coordinate);
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  return axis.order.samples(request.samples, from, to);
}

bool SphericalFunctionSession::measure(EvaluatedMap& map, std::string_view property) const {
  if (property != "max_structural_error_deg" || !family_ || !family_->has_function() || task_.free) return false;
  map.show([&](std::span<float> values) { structural_errors_deg(*family_, map.map(), values); });
  return true;
}

std::optional<SphericalSolution> SphericalFunctionSession::made(MapPoint place, bool respect_direction,
                                                                bool verify) const {
  auto found = make_spherical_four_bar(given_, place, respect_direction, verify);
  if (found && family_) found->function = family_->error_of(found->four_bar, place);
  return found;
}

LinkageReply SphericalFunctionSession::linkage(MapPoint place, FailureBits fails, bool respect_direction) const {
  constexpr bool verify = false;
  const auto found = made(place, respect_direction, verify);
  if (!found) return spherical_reply(given_, found, {}, place, fails);
  const SphericalFunctionTask there = family_->task_at(place);
  return spherical_reply(given_, found, family_->orientations(place, found->four_bar), place, fails, &there);
}

Verification SphericalFunctionSession::verify(MapPoint place, bool respect_direction) const {
  constexpr bool by_driving = true;
  const auto found = make_spherical_four_bar(given_, place, respect_direction, by_driving);
  return found ? Verification{found->verified_by_driving, found->residual} : Verification{};
}

std::vector<double> SphericalFunctionSession::trace(MapPoint /*place*/, Point /*traced*/,
                                                    bool /*respect_direction*/) const {
  return {};
}

std::optional<MapPoint> SphericalFunctionSession::improved(MapPoint place, const Wish& wish) const {
  if (!family_) return std::nullopt;
  if (wish.objective == Objective::structural_error)
    return improved_generator(*family_, wish.requirements, place, wish.added);
  return improved_linkage(*family_, wish.requirements, wish.objective, place, wish.added);
}

int SphericalFunctionSession::samples_for_best() const { return cells_of_the_map; }

std::optional<Answer> SphericalFunctionSession::answer_at(MapPoint place, bool respect_direction) const {
  constexpr bool verify = true;
  auto found = made(place, respect_direction, verify);
  if (!found) return std::nullopt;
  SphericalFunctionAnswer answer;
  answer.task = task_;
  answer.given = given_;
  answer.pattern = given_.pattern;
  answer.condition = given_.conditions.condition();
  answer.linkages = {*std::move(found)};
  return Answer(std::move(answer));
}

}  // namespace linkwright::wasm
