#include "approximate/scan_target.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "approximate/dyad_scan_kernel.hpp"

namespace linkwright {
namespace {

// Of the polygon at its point j, radians in [0, 1.5]: a corner counts as a bend, a doubled point as none.
double turning_at(const CurveTarget& target, std::size_t j) {
  constexpr double most = 1.5;
  const std::size_t n = target.points.size();
  if (!target.closed && (j == 0 || j + 1 == n)) return 0;
  const Point before = target.points[j] - target.points[(j + n - 1) % n];
  const Point after = target.points[(j + 1) % n] - target.points[j];
  if (before == Point{} || after == Point{}) return 0;
  return std::min(std::abs(std::atan2(cross(before, after), dot(before, after))), most);
}

// What is passed up to each point; at the end the whole.
std::vector<double> passed_length_and_turning(const CurveTarget& target) {
  const std::size_t n = target.points.size(), segments = target.closed ? n : n - 1;
  std::vector<double> length(segments), turning(segments);
  for (std::size_t j = 0; j < segments; ++j) {
    const std::size_t next = (j + 1) % n;
    length[j] = std::abs(target.points[next] - target.points[j]);
    turning[j] = 0.5 * (turning_at(target, j) + turning_at(target, next));
  }
  const double all_length = std::accumulate(length.begin(), length.end(), 0.0);
  const double all_turning = std::max(std::accumulate(turning.begin(), turning.end(), 0.0), 1e-9);
  std::vector<double> passed(segments + 1, 0);
  for (std::size_t j = 0; j < segments; ++j)
    passed[j + 1] = passed[j] + 0.5 * length[j] / all_length + 0.5 * turning[j] / all_turning;
  return passed;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& from, const std::vector<std::size_t>& which) {
  std::vector<Value> values;
  for (const std::size_t j : which) values.push_back(from[j]);
  return values;
}

}  // namespace

std::vector<std::size_t> chosen_points(const CurveTarget& target, std::size_t count) {
  const std::size_t n = target.points.size();
  std::vector<std::size_t> chosen(std::min(n, count));
  if (n <= count) {
    std::iota(chosen.begin(), chosen.end(), 0);
    return chosen;
  }
  const std::vector<double> passed = passed_length_and_turning(target);
  const double step = passed.back() / static_cast<double>(target.closed ? count : count - 1);
  std::size_t j = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = step * static_cast<double>(k);
    const std::size_t last = n - (count - k);  // leaves one for each that follows
    while (j < last && passed[j] < wanted - 0.5 * (passed[j + 1] - passed[j])) ++j;
    chosen[k] = j++;
  }
  return chosen;
}

ScaledTarget scaled_target(const CurveTarget& target) {
  ScaledTarget scaled;
  const auto n = static_cast<double>(target.points.size());
  scaled.closed = target.closed;
  scaled.centroid = std::accumulate(target.points.begin(), target.points.end(), Point{}) / n;
  double square = 0;
  for (const Point point : target.points) square += std::norm(point - scaled.centroid);
  scaled.radius = std::sqrt(square / n);
  scaled.diagonal = target.diagonal() / scaled.radius;
  scaled.weights = target.weights.empty() ? std::vector<double>(target.points.size(), 1.0) : target.weights;
  scaled.mean_weight = std::accumulate(scaled.weights.begin(), scaled.weights.end(), 0.0) / n;
  for (double& weight : scaled.weights) weight /= scaled.mean_weight;
  for (const Point point : target.points) scaled.points.push_back(scaled.scaled(point));
  scaled.chosen = chosen_points(target, DyadBlock::most_points);
  return scaled;
}

std::vector<Point> ScaledTarget::chosen_points() const { return picked(points, chosen); }
std::vector<double> ScaledTarget::chosen_weights() const { return picked(weights, chosen); }

}  // namespace linkwright
