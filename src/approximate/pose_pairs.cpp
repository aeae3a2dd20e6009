#include "approximate/pose_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

// Of each dyad those, itself among them, that lead to the same linkages.
std::vector<std::vector<std::size_t>> neighbours(std::span<const DyadAtPoses> dyads) {
  constexpr double apart = 0.1;  // of places on the disc of radius 1 that stands for the plane
  std::vector<Point> on_disc;
  for (const DyadAtPoses& at : dyads) on_disc.push_back(at.dyad().body / (1 + std::abs(at.dyad().body)));
  std::vector<std::vector<std::size_t>> near(dyads.size());
  for (std::size_t i = 0; i < dyads.size(); ++i)
    for (std::size_t j = 0; j < dyads.size(); ++j)
      if (std::norm(on_disc[i] - on_disc[j]) < apart * apart) near[i].push_back(j);
  return near;
}

// Lengths a little beyond a limit may be led back to it.
bool may_keep(const FitLimits& limits, const BodyLinkage& linkage) {
  constexpr double beyond = 1.5;
  const LinkLengths lengths = linkage.lengths();
  return lengths.shortest() > 0 && lengths.longest() <= beyond * limits.max_length &&
         lengths.shortest() >= limits.min_length / beyond &&
         lengths.longest() <= limits.max_link_ratio * lengths.shortest();
}

}  // namespace

DyadAtPoses::DyadAtPoses(const BodyDyad& dyad, std::span<const BodyPose> poses, double turning_length) : dyad_(dyad) {
  at_.reserve(poses.size());
  for (const BodyPose& pose : poses) {
    const Point arm = product(dyad.body, pose.axis), link = pose.origin + arm - dyad.center;
    const double length = std::abs(link);
    const Point unit = length > 0 ? link / length : Point{1, 0};
    const BodyMove gradient{unit, cross(arm, unit) / turning_length};
    at_.push_back({length - dyad.radius, gradient, square(gradient)});
  }
}

double DyadAtPoses::square_error(const DyadAtPoses& a, const DyadAtPoses& b, std::span<const double> weights) {
  double sum = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const AtPose &one = a.at_[j], &other = b.at_[j];
    const double mixed = dot(one.gradient, other.gradient);
    const double det = one.square * other.square - mixed * mixed;
    const double moved = other.square * one.error * one.error - 2 * mixed * one.error * other.error +
                         one.square * other.error * other.error;
    sum += weights[j] * moved / (det + 1e-12 * one.square * other.square);
  }
  return sum;
}

BodyLinkage linkage_of(const BodyDyad& input, const BodyDyad& output) {
  return {input.center, output.center, input.radius, output.radius, input.body, output.body};
}

std::vector<PosePair> best_pairs(std::span<const DyadAtPoses> dyads, std::span<const double> weights,
                                 const FitLimits& limits, std::size_t count) {
  struct Rated {
    double score;
    std::size_t one, other;
  };
  const std::size_t n = dyads.size();
  std::vector<Rated> rated;
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!may_keep(limits, linkage_of(dyads[j].dyad(), dyads[i].dyad()))) continue;
      const double score = DyadAtPoses::square_error(dyads[j], dyads[i], weights);
      if (std::isfinite(score)) rated.push_back({score, j, i});
    }
  std::stable_sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) { return a.score < b.score; });
  const auto near = neighbours(dyads);
  std::vector<char> taken(n * n, 0);  // pairs near a chosen one
  std::vector<PosePair> chosen;
  for (const Rated& pair : rated) {
    if (chosen.size() == count) break;
    if (taken[pair.one * n + pair.other] != 0) continue;
    chosen.push_back({linkage_of(dyads[pair.one].dyad(), dyads[pair.other].dyad()), pair.score});
    for (const std::size_t i : near[pair.one])
      for (const std::size_t j : near[pair.other]) taken[i * n + j] = taken[j * n + i] = 1;
  }
  return chosen;
}

}  // namespace linkwright
