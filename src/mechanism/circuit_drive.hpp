#pragma once

#include <optional>
#include <vector>

#include "configuration_curve.hpp"
#include "linkwright/mechanism/drive_through.hpp"

namespace linkwright {

/// A position of the task on the way of a drive: the configuration that it wants, where it wants the moving hinges, and
/// how they are to move there (any length), in the linkage's own frame.
struct DriveTarget {
  TorusVector configuration;
  HingePlaces hinges;
  std::optional<HingePlaces> rates;
  bool met = false;
};

/// Walks once round the circuit of the first target by arc-length continuation, notes where each target is met and
/// where the input's dead points lie, and reads the defects off (drive_through()).
[[nodiscard]] DriveThroughReport drive_along(const ConfigurationCurve& curve, std::vector<DriveTarget> targets,
                                             const DriveThroughOptions& options);

}  // namespace linkwright
