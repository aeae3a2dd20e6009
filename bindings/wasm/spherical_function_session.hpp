#pragma once

#include <memory>

#include "linkwright/spherical/spherical_function_family.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// Functions that spherical four-bars generate.
class SphericalFunctionSession final : public TaskSession {
 public:
  explicit SphericalFunctionSession(const SphericalFunctionTask& task);

  [[nodiscard]] bool serves(const Problem& problem) const override;
  [[nodiscard]] const LinkageFamily* family() const override { return family_.get(); }
  [[nodiscard]] const Notice& no_map() const override;
  [[nodiscard]] const Notice& nothing_on_map() const override;
  [[nodiscard]] Requirements with_defaults(Requirements wanted) const override;
  [[nodiscard]] TaskReply about() const override;
  /// Input links and output links along the curve: centres are fixed axes, circle points moving axes, (x, y, z).
  [[nodiscard]] Drawn drawn() const override;
  [[nodiscard]] ShownAxes axes(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown) const override;
  [[nodiscard]] std::vector<double> coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                Side side) const override;
  [[nodiscard]] int map_samples(int asked) const override { return asked; }
  bool measure(EvaluatedMap& map, std::string_view property) const override;
  [[nodiscard]] LinkageReply linkage(MapPoint place, FailureBits fails, bool respect_direction) const override;
  [[nodiscard]] Verification verify(MapPoint place, bool respect_direction) const override;
  /// None: points of the sphere are no points of the plane.
  [[nodiscard]] std::vector<double> trace(MapPoint place, Point traced, bool respect_direction) const override;
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const override;
  [[nodiscard]] int samples_for_best() const override;
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const override;

 private:
  [[nodiscard]] std::optional<SphericalSolution> made(MapPoint place, bool respect_direction, bool verify) const;

  SphericalFunctionTask task_;
  SphericalTaskFamily given_;
  std::shared_ptr<const SphericalFunctionFamily> family_;  ///< none where degenerate
};

}  // namespace linkwright::wasm
