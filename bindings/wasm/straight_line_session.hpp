#pragma once

#include <memory>

#include "linkwright/straight_line/straight_line_solution.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// Linkages with a point that runs straight: the map of a case, its layers one after the other along the input's axis;
/// a search over all cases has none.
class StraightLineSession final : public TaskSession {
 public:
  StraightLineSession(const StraightLineTask& task, const SynthesisOptions& options);

  [[nodiscard]] bool serves(const Problem& problem) const override;
  [[nodiscard]] const LinkageFamily* family() const override { return family_.get(); }
  [[nodiscard]] const Notice& no_map() const override { return nothing_; }
  [[nodiscard]] const Notice& nothing_on_map() const override { return nothing_; }
  [[nodiscard]] Requirements with_defaults(Requirements wanted) const override;
  [[nodiscard]] TaskReply about() const override;
  /// Of a few linkages their grounded links, one to each layer; otherwise none, as none depends on its own coordinate
  /// alone.
  [[nodiscard]] Drawn drawn() const override;
  [[nodiscard]] ShownAxes axes(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown) const override;
  [[nodiscard]] std::vector<double> coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                Side side) const override;
  [[nodiscard]] int map_samples(int asked) const override;
  [[nodiscard]] LinkageReply linkage(MapPoint place, FailureBits fails, bool respect_direction) const override;
  [[nodiscard]] bool meets_exactly(MapPoint place, const Requirements& wanted) const override;
  [[nodiscard]] Verification verify(MapPoint place, bool respect_direction) const override;
  [[nodiscard]] std::vector<double> trace(MapPoint place, Point traced, bool respect_direction) const override;
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const override;
  [[nodiscard]] int samples_for_best() const override;
  /// A climb from the best cell of a small map, confirmed.
  [[nodiscard]] bool window_sets_axes() const override { return true; }
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const override;

 private:
  [[nodiscard]] std::optional<StraightLineSolution> at(MapPoint place) const;

  StraightLineTask task_;
  LineMeasuring measuring_;
  std::optional<MapWindow> window_;
  std::shared_ptr<const StraightLineFamily> family_;  ///< none of a search
  Notice nothing_;
};

}  // namespace linkwright::wasm
