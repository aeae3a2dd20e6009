#include "linkwright/planar/body_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

double distance_of(const BodyPoints& points) { return std::abs(points.second - points.first); }

double mean_distance(std::span<const BodyPoints> given) {
  double sum = 0;
  for (const BodyPoints& points : given) sum += distance_of(points);
  return sum / static_cast<double>(given.size());
}

}  // namespace

std::vector<Pose> poses_of_points(std::span<const BodyPoints> given) {
  const double kept = mean_distance(given);
  std::vector<Pose> poses;
  for (const BodyPoints& points : given) {
    const Point along = points.second - points.first, unit = along / std::abs(along);
    poses.push_back({points.first + (std::abs(along) - kept) / 2 * unit, std::arg(along)});
  }
  return poses;
}

std::optional<Notice> points_notice(std::span<const BodyPoints> given) {
  if (given.empty()) return std::nullopt;
  const auto [least, greatest] =
      std::minmax_element(given.begin(), given.end(),
                          [](const BodyPoints& a, const BodyPoints& b) { return distance_of(a) < distance_of(b); });
  const double low = distance_of(*least), high = distance_of(*greatest), kept = mean_distance(given);
  if (high - low <= tolerance::equal_distances * high) return std::nullopt;
  const double miss = std::max(high - kept, kept - low) / 2;
  return Notice{"points_distance",
                fmt::format("The two points are {:.6g} to {:.6g} apart in the poses given, which no rigid body does: "
                            "they are taken to be {:.6g} apart, and each is missed by up to {:.3g}.",
                            low, high, kept, miss),
                {{"least", low}, {"greatest", high}, {"distance", kept}, {"miss", miss}}};
}

void check_points(std::span<const BodyPoints> given, std::vector<Error>& found) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string place = fmt::format("task.poses[{}].points", i);
    for (const auto& [point, k] : {std::pair{given[i].first, 0}, std::pair{given[i].second, 1}}) {
      check_number(point.real(), "x", fmt::format("{}[{}][0]", place, k), found);
      check_number(point.imag(), "y", fmt::format("{}[{}][1]", place, k), found);
    }
    if (given[i].first == given[i].second)
      found.push_back({"same_points", place,
                       "both points lie at one place, which gives the body no direction; give two different ones"});
  }
}

}  // namespace linkwright
