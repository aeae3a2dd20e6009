#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arm_motion.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/planar/path_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// What a path task gives where one link is settled before the other. The arm: the link whose place on a map is chosen,
/// or that reaches from a given pivot, and the coupler from there to the point.
struct ArmTask {
  WorkingFrame frame;
  std::vector<PathPoint> points;  ///< user's frame
  std::vector<PathPlace> path;    ///< working frame, its origin being the first place
  std::optional<double> sense;    ///< of the crank, where its angles tell it: 1 counter-clockwise, −1
  Side side = Side::input;        ///< of the arm
  std::vector<std::array<std::size_t, 2>> repeated;  ///< points at one place

  /// Where no angle is known, and how many they are.
  [[nodiscard]] std::vector<Point> plain_places() const;
  [[nodiscard]] std::size_t plain_count() const;
};

/// The frame's unit is the root of the mean square of the points' distances from their centroid. `task` without
/// mistakes, of any form but PathForm::cranks.
[[nodiscard]] ArmTask arm_task(const PathTask& task);

/// An arm, where its elbow can stand, and what is settled of the other link.
struct ArmAtPlace {
  PlacedArm arm;
  ArmElbows elbows;
  std::optional<Point> other;           ///< ground pivot
  std::optional<Point> other_moving{};  ///< its moving pivot in position 1
  std::optional<std::uint8_t> bits{};   ///< of the pattern, where only one is meant
};

/// How several linkages of one arm are told apart.
enum class LayersOf {
  nothing,       ///< there is only one
  input_axis,    ///< by a layer of the input's coordinate (MapAxis::layers)
  output_branch  ///< by a branch of the output's axis
};

/// The arms that a path task leaves open, by the places of a map.
class ArmChoice {
 public:
  ArmChoice(MapAxis input, MapAxis output, LayersOf layers, bool knows_other)
      : input_(std::move(input)), output_(std::move(output)), layers_(layers), knows_other_(knows_other) {}
  ArmChoice(const ArmChoice&) = delete;
  ArmChoice& operator=(const ArmChoice&) = delete;
  virtual ~ArmChoice() = default;

  /// Without layers.
  [[nodiscard]] const MapAxis& axis(Side side) const { return side == Side::input ? input_ : output_; }
  [[nodiscard]] LayersOf layers() const { return layers_; }
  /// ArmAtPlace::other is always there.
  [[nodiscard]] bool knows_other() const { return knows_other_; }

  /// Nothing where no arm reaches all points. Coordinates without layers.
  [[nodiscard]] virtual std::optional<ArmAtPlace> at(MapPoint place) const = 0;
  /// As LinkageFamily::axis_value().
  [[nodiscard]] virtual double axis_value(Side /*side*/, double coordinate) const { return coordinate; }

 private:
  MapAxis input_, output_;
  LayersOf layers_;
  bool knows_other_;
};

/// The choice, or why there is none, and what is to be said of the task.
struct ArmChoiceSetup {
  std::shared_ptr<const ArmChoice> choice;
  std::optional<Notice> degeneracy;
  std::vector<Notice> warnings;
  bool has_none = false;  ///< because no linkage does the task
};

/// `arms`: that of the task.
[[nodiscard]] ArmChoiceSetup arm_choice(const PathTask& task, const ArmTask& arms);

}  // namespace linkwright
