#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkage_reply.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "task_reply.hpp"

namespace linkwright::wasm {

/// What the page is shown of a six-bar task: the map over both added links of its chain.
class SixBarMap {
 public:
  explicit SixBarMap(SixBarTask task);

  /// Nothing to show without a chain.
  [[nodiscard]] bool has_chain() const { return family_ != nullptr; }
  [[nodiscard]] const SixBarTask& task() const { return task_; }
  /// A family without four-bars: pattern, conditions, size; and why there is no map.
  [[nodiscard]] TaskFamily given() const;
  [[nodiscard]] ShownAxes axes() const;
  [[nodiscard]] DrawnCurves drawn(Side side) const;

  void classify(RegionMap& map, std::span<const double> first, std::span<const double> second) const;
  [[nodiscard]] RequirementFilter filter(const RegionMap& map, const Requirements& wanted) const;

  /// improved_six_bar() of the chain.
  [[nodiscard]] std::optional<std::array<double, 2>> improved(std::array<double, 2> place, const Requirements& wanted,
                                                              Objective objective) const;

  /// Nothing where there is no six-bar.
  [[nodiscard]] std::optional<SixBarSolution> at(double first, double second) const;
  /// Its coordinates on the map.
  [[nodiscard]] std::array<double, 2> place_of(const SixBarSolution& found) const;

 private:
  SixBarTask task_;
  std::unique_ptr<const SixBarFamily> family_;
};

/// SixBarLinkage of the protocol, and its drive: rows of state_columns followed by x and y of each hinge.
struct SixBarReply {
  std::string linkage;
  std::vector<double> states;
};
inline constexpr std::size_t six_bar_state_width = state_width + 2 * SixBar::joint_count;
/// `fails`: requirement bits.
[[nodiscard]] SixBarReply six_bar_reply(const std::vector<PrescribedPose>& poses,
                                        const std::optional<SixBarSolution>& found, std::array<double, 2> coordinates,
                                        std::uint8_t fails);

/// The path of a point of the body (as it lies in position 1) over the drive's states, x and y by turns.
[[nodiscard]] std::vector<double> six_bar_trace(const std::vector<PrescribedPose>& poses,
                                                const std::optional<SixBarSolution>& found, Point traced);

}  // namespace linkwright::wasm
