#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/position.hpp"
#include "loads/statics.hpp"

namespace linkwright {

/// The travel of a four-bar from position 1 to the last one, in the assembly of position 1.
class LoadTravel {
 public:
  /// Nothing where it does not get through the poses in order without a dead point.
  [[nodiscard]] static std::optional<LoadTravel> of(const FourBar& bars, std::span<const PrescribedPose> poses);

  [[nodiscard]] const FourBar& first() const { return first_; }
  /// Turn of the driver, ≥ 0, at which the travel ends, radians.
  [[nodiscard]] double end() const { return positions_.back(); }
  /// Of the positions, ascending from 0.
  [[nodiscard]] const std::vector<double>& positions() const { return positions_; }
  /// +1: the driver turns counter-clockwise.
  [[nodiscard]] double sense() const { return sense_; }

  /// At a turn in [0, end()]; nothing where the links lie in one line.
  [[nodiscard]] std::optional<LoadedPlace> at(double turn) const;
  /// Turns, ascending: of the positions, and `between` ≥ 1 equal steps from each to the next.
  [[nodiscard]] std::vector<double> stations(int between) const;
  /// Those, and more of them where the twist or the way of the handle turns fast: near a dead point of a link or of the
  /// handle forces have peaks narrower than any equal step.
  [[nodiscard]] std::vector<double> close_stations(int between, const std::optional<LinkPoint>& handle) const;

 private:
  LoadTravel() = default;
  struct Anchor {
    double turn = 0, coupler = 0, output = 0;  ///< angles without jumps
  };
  void anchor();

  FourBar first_;
  LinkLengths lengths_;
  Configuration start_;
  Assembly assembly_ = Assembly::positive;
  double sense_ = 1, twist_sense_ = 1;
  std::vector<double> positions_;
  std::vector<Anchor> anchors_;
};

/// The way of a point of the coupler over a travel.
class HandlePath {
 public:
  HandlePath(const LoadTravel& travel, const LinkPoint& handle);
  /// From position 1 to a turn, over the whole.
  [[nodiscard]] double share(double turn) const;
  [[nodiscard]] double length() const { return ways_.empty() ? 0 : ways_.back(); }
  [[nodiscard]] double way(double turn) const;

 private:
  [[nodiscard]] double speed(double turn) const;
  [[nodiscard]] double between(double from, double to) const;

  const LoadTravel& travel_;
  LinkPoint handle_;
  std::vector<double> turns_, ways_;
};

}  // namespace linkwright
