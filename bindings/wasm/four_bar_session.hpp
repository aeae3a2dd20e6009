#pragma once

#include "linkwright/planar/function_family.hpp"
#include "linkwright/planar/task_family.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// Tasks of planar four-bars.
class FourBarSession : public TaskSession {
 public:
  explicit FourBarSession(TaskFamily given) : given_(std::move(given)) {}

  [[nodiscard]] const LinkageFamily* family() const override { return given_.family.get(); }
  [[nodiscard]] const Notice& no_map() const override;
  [[nodiscard]] const Notice& nothing_on_map() const override;
  [[nodiscard]] Requirements with_defaults(Requirements wanted) const override;
  [[nodiscard]] TaskReply about() const override;
  [[nodiscard]] Drawn drawn() const override;
  [[nodiscard]] ShownAxes axes(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown) const override;
  [[nodiscard]] std::vector<double> coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                Side side) const override;
  [[nodiscard]] int map_samples(int asked) const override { return asked; }
  [[nodiscard]] std::vector<MissedBox> missed_boxes(const Requirements& wanted) const override;
  [[nodiscard]] LinkageReply linkage(MapPoint place, FailureBits fails, bool respect_direction) const override;
  [[nodiscard]] Verification verify(MapPoint place, bool respect_direction) const override;
  [[nodiscard]] std::vector<double> trace(MapPoint place, Point traced, bool respect_direction) const override;
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const override;
  [[nodiscard]] int samples_for_best() const override;

 protected:
  [[nodiscard]] const TaskFamily& given() const { return given_; }
  /// What the task's body is to pass, which marks places of its curve; none of functions.
  [[nodiscard]] virtual const std::vector<PrescribedPose>& poses() const = 0;
  /// An answer of the task with one linkage.
  template <class KindAnswer>
  [[nodiscard]] std::optional<Answer> answer_with(KindAnswer answer, std::optional<FourBarSolution> found) const {
    if (!found) return std::nullopt;
    answer.given = given_;
    answer.pattern = given_.pattern;
    answer.condition = given_.conditions.condition();
    answer.characteristic_length = given_.frame().scale;
    answer.warnings = given_.warnings;
    answer.linkages = {*std::move(found)};
    return Answer(std::move(answer));
  }

 private:
  [[nodiscard]] ShownAxis ordered(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown,
                                  Side side) const;

  TaskFamily given_;
};

class MotionSession final : public FourBarSession {
 public:
  MotionSession(const MotionTask& task, const Problem& problem);

  [[nodiscard]] bool serves(const Problem& problem) const override;
  bool measure(EvaluatedMap& map, std::string_view property) const override;
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const override;

 private:
  [[nodiscard]] const std::vector<PrescribedPose>& poses() const override { return task_.poses; }

  MotionTask task_;
};

class FunctionSession final : public FourBarSession {
 public:
  explicit FunctionSession(const FunctionTask& task);

  [[nodiscard]] bool serves(const Problem& problem) const override;
  [[nodiscard]] TaskReply about() const override;
  [[nodiscard]] int map_samples(int asked) const override;
  bool measure(EvaluatedMap& map, std::string_view property) const override;
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const override;
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const override;

 private:
  [[nodiscard]] const std::vector<PrescribedPose>& poses() const override;

  FunctionTask task_;
  std::shared_ptr<const FunctionFamily> family_;  ///< none where degenerate
};

}  // namespace linkwright::wasm
