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
  /// Null without a chain.
  [[nodiscard]] const std::shared_ptr<const ChainFamily>& family() const { return family_; }

  /// Nothing where there is no six-bar.
  [[nodiscard]] std::optional<SixBarSolution> at(MapPoint point) const;

 private:
  SixBarTask task_;
  std::shared_ptr<const ChainFamily> family_;
};

/// SixBarLinkage of the protocol, and its drive: rows of state_columns followed by x and y of each hinge.
struct SixBarReply {
  std::string linkage;
  std::vector<double> states;
};
inline constexpr std::size_t six_bar_state_width = state_width + 2 * SixBar::joint_count;
/// `fails`: requirement bits.
[[nodiscard]] SixBarReply six_bar_reply(const std::vector<PrescribedPose>& poses,
                                        const std::optional<SixBarSolution>& found, MapPoint point, std::uint8_t fails);

/// The path of a point of the body (as it lies in position 1) over the drive's states, x and y by turns.
[[nodiscard]] std::vector<double> six_bar_trace(const std::vector<PrescribedPose>& poses,
                                                const std::optional<SixBarSolution>& found, Point traced);

}  // namespace linkwright::wasm
