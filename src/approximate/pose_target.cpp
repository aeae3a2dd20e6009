#include "approximate/pose_target.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

Point centroid_of(const PoseTarget& target) {
  Point sum{};
  for (const Pose& pose : target.poses) sum += pose.origin;
  return target.poses.empty() ? sum : sum / static_cast<double>(target.poses.size());
}

}  // namespace

double PoseTarget::scale() const {
  const Point centroid = centroid_of(*this);
  double square = 0;
  for (const Pose& pose : poses) square += std::norm(pose.origin - centroid);
  return std::max(turning_length, std::sqrt(square / static_cast<double>(std::max<std::size_t>(poses.size(), 1))));
}

bool PoseTarget::is_exact(std::size_t pose) const { return std::binary_search(exact.begin(), exact.end(), pose); }

void require_pose_target(const PoseTarget& target, std::size_t distinct) {
  std::vector<Pose> known;
  for (const Pose& pose : target.poses) {
    require(is_finite(pose.origin) && std::isfinite(pose.angle), "poses are finite");
    if (known.size() < distinct && std::find(known.begin(), known.end(), pose) == known.end()) known.push_back(pose);
  }
  require(known.size() == distinct, "enough poses are distinct");
  require(target.turning_length > 0 && std::isfinite(target.turning_length), "the turning length is above 0");
  require(target.weights.empty() || target.weights.size() == target.poses.size(), "a weight belongs to each pose");
  const auto usable = [](double weight) { return weight >= 0 && std::isfinite(weight); };
  require(std::all_of(target.weights.begin(), target.weights.end(), usable), "weights are not negative");
  constexpr std::size_t most_exact = 5;
  require(target.exact.size() <= most_exact && std::is_sorted(target.exact.begin(), target.exact.end()) &&
              (target.exact.empty() || target.exact.back() < target.poses.size()),
          "exact poses are some of the poses, in order");
  double sum = static_cast<double>(target.exact.size());
  for (std::size_t j = 0; j < target.poses.size(); ++j) sum += target.weight(j);
  require(sum > 0, "a weight is above 0");
}

std::vector<double> ScaledPoses::weights_with(double factor) const {
  std::vector<double> all = weights;
  for (const std::size_t j : exact) all[j] = factor;
  return all;
}

PoseFrame::PoseFrame(const PoseTarget& target)
    : centroid(centroid_of(target)), unit(target.scale()), turning_length(target.turning_length / unit) {}

ScaledPoses PoseFrame::scaled(const PoseTarget& target, const std::vector<std::size_t>& chosen) const {
  ScaledPoses some;
  double sum = 0, count = 0;
  for (std::size_t j = 0; j < target.poses.size(); ++j) {
    if (target.is_exact(j)) continue;
    sum += target.weight(j);
    ++count;
  }
  const double mean = sum > 0 ? sum / count : 1;
  for (const std::size_t j : chosen) {
    const bool exact = target.is_exact(j);
    if (exact) some.exact.push_back(some.poses.size());
    some.poses.push_back(scaled(target.poses[j]));
    some.weights.push_back(exact ? 0 : target.weight(j) / mean);
  }
  return some;
}

std::vector<std::size_t> chosen_poses(const PoseTarget& target, std::size_t count) {
  std::vector<std::size_t> near, chosen = target.exact;
  for (std::size_t j = 0; j < target.poses.size(); ++j)
    if (!target.is_exact(j) && target.weight(j) > 0) near.push_back(j);
  const std::size_t left = std::min(count - std::min(count, chosen.size()), near.size());
  for (std::size_t k = 0; k < left; ++k) chosen.push_back(near[left == 1 ? 0 : k * (near.size() - 1) / (left - 1)]);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace linkwright
