#pragma once

#include "linkwright/planar/chain_family.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// Tasks of six-bars: the map over both added links of a given chain.
class SixBarSession final : public TaskSession {
 public:
  explicit SixBarSession(const SixBarTask& task);

  [[nodiscard]] bool serves(const Problem& problem) const override;
  [[nodiscard]] const LinkageFamily* family() const override { return family_.get(); }
  [[nodiscard]] const Notice& no_map() const override;
  [[nodiscard]] const Notice& nothing_on_map() const override;
  [[nodiscard]] Requirements with_defaults(Requirements wanted) const override;
  [[nodiscard]] TaskReply about() const override;
  [[nodiscard]] Drawn drawn() const override;
  [[nodiscard]] ShownAxes axes(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown) const override;
  [[nodiscard]] std::vector<double> coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                Side side) const override;
  [[nodiscard]] int map_samples(int asked) const override;
  [[nodiscard]] int halo_samples(int asked, std::size_t places) const override;
  [[nodiscard]] LinkageReply linkage(MapPoint place, FailureBits fails, bool respect_direction) const override;
  [[nodiscard]] Verification verify(MapPoint place, bool respect_direction) const override;
  [[nodiscard]] std::vector<double> trace(MapPoint place, Point traced, bool respect_direction) const override;
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const override;
  [[nodiscard]] int samples_for_best() const override;
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const override;

 private:
  /// Nothing where there is no six-bar.
  [[nodiscard]] std::optional<SixBarSolution> at(MapPoint place) const;

  SixBarTask task_;
  std::shared_ptr<const ChainFamily> family_;  ///< none without a chain
};

}  // namespace linkwright::wasm
