#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::testing {

/// A published target, data/approximate/<name>.json.
struct CurveCase {
  CurveTarget target;
  double best = 0;  ///< least sum of squares known, of linkages without defects and within the default limits
};
[[nodiscard]] CurveCase curve_case(const std::string& name);

/// Poses published or drawn, data/approximate/<name>.json, some of them exact.
[[nodiscard]] PoseTarget pose_case(const std::string& name);

/// A linkage of one of the types, of any where none is named, that is not near a change point, and its point.
[[nodiscard]] TracingFourBar drawn_linkage(RandomFourBars& draw, std::initializer_list<LinkageType> types = {});
/// The first of a seed: a crank-rocker, or any.
[[nodiscard]] TracingFourBar drawn_linkage(std::uint64_t seed, bool crank);

/// Points of its curve at equal steps of the input: all the way round, or over a part without dead points.
[[nodiscard]] CurveTarget traced_target(const TracingFourBar& linkage, bool closed, int count, double sweep = 2);

}  // namespace linkwright::testing
