#include "linkwright/files/position_error.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr double is_met = 1e-6;  // of the longest link, radians: linkages that are solved for are nearer by far

template <class StatesOf, class PoseOf, class ErrorOf>
std::vector<PositionError> errors_in(const StatesOf& states_of, std::size_t positions, const PoseOf& pose_of,
                                     const ErrorOf& error_of) {
  std::vector<PositionError> errors;
  if (positions < 2) return errors;
  const auto states = states_of();
  for (int pose = 1; pose < static_cast<int>(positions); ++pose) {
    const auto found =
        std::find_if(states.begin(), states.end(), [&](const auto& state) { return pose_of(state) == pose; });
    errors.push_back({pose + 1, found == states.end() ? std::nullopt : std::optional<BodyError>(error_of(*found))});
  }
  return errors;
}

std::vector<PositionError> errors_of(const StoredLinkage& linkage) {
  return errors_in([&] { return tabulated_cycle(linkage); }, linkage.poses.size(),
                   [](const CycleState& state) { return state.pose; },
                   [](const CycleState& state) { return state.error; });
}

std::vector<PositionError> errors_of(const StoredSixBar& linkage) {
  return errors_in([&] { return tabulated_motion(linkage.six_bar, linkage.poses).states; }, linkage.poses.size(),
                   [](const SixBarMotionState& state) { return state.place.pose; },
                   [](const SixBarMotionState& state) { return state.place.error; });
}

std::vector<PositionError> errors_of(const StoredSphericalFourBar& linkage) {
  return errors_in([&] { return analyze(linkage).motion; }, linkage.orientations.size(),
                   [](const SphericalState& state) { return state.position.value_or(0) - 1; },
                   [](const SphericalState& state) {
                     return BodyError{0, state.orientation_error};
                   });
}

double longest_link(const StoredLinkage& linkage) { return linkage.four_bar.lengths().longest(); }
double longest_link(const StoredSixBar& linkage) { return shape_of(linkage.six_bar).longest; }
double longest_link(const StoredSphericalFourBar& /*linkage*/) { return 1; }

std::string error_words(const BodyError& error, const std::string& unit) {
  const std::string angle = fmt::format("{}°", significant_text(degrees(error.angle), 3));
  if (error.distance == 0) return angle;
  return fmt::format("{}{}{} and {}", significant_text(error.distance, 3), unit.empty() ? "" : " ", unit, angle);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

}  // namespace

std::vector<PositionError> position_errors(const AnyStoredLinkage& linkage) {
  return std::visit([](const auto& stored) { return errors_of(stored); }, linkage);
}

std::string position_error_words(const AnyStoredLinkage& linkage) {
  const double size = std::visit([](const auto& stored) { return longest_link(stored); }, linkage);
  const std::string unit = std::visit([](const auto& stored) { return stored.length_unit; }, linkage);
  std::vector<std::string> missed, not_reached;
  for (const auto& [position, error] : position_errors(linkage)) {
    if (!error)
      not_reached.push_back(fmt::format("position {}", position));
    else if (!(error->distance <= is_met * size && error->angle <= is_met))
      missed.push_back(fmt::format("position {} by {}", position, error_words(*error, unit)));
  }
  std::vector<std::string> told;
  if (!missed.empty()) told.push_back("misses " + joined(missed));
  if (!not_reached.empty()) told.push_back("does not come to " + joined(not_reached));
  return told.empty() ? "" : "as it moves the linkage " + joined(told);
}

}  // namespace linkwright
