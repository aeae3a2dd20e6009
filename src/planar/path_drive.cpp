#include "path_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double usual_step = radians(0.1), shortest_step = radians(1e-7), rounding = 1e-14, probe = 1e-5;
// By which share of its link the moving pivot may be off the straight continuation of its way, as a share of how far
// its two places are apart: then there is no doubt which of them it comes to.
constexpr double undoubted = 0.1;

/// A linkage that is driven: where its moving pivots are, and how the output's went on last.
class Walk {
 public:
  Walk(const FourBar& bars, Point point)
      : bars_(bars), lengths_(bars.lengths()), b_(bars.output_moving), last_b_(bars.output_moving) {
    const Point coupler = bars.output_moving - bars.input_moving;
    along_ = (point - bars.input_moving) / coupler;
  }

  [[nodiscard]] double turned() const { return turned_; }
  [[nodiscard]] Point point() const { return point_at(crank_at(turned_), b_); }

  /// To where the crank has turned so far; false where it cannot get there.
  bool go_to(double turned) {
    while (turned_ != turned) {
      double step = turned - turned_;
      if (std::abs(step) > usual_step) step = std::copysign(usual_step, step);
      while (!take(step)) {
        step /= 2;
        if (std::abs(step) < shortest_step) return false;
      }
      if (std::abs(turned - turned_) < rounding) turned_ = turned;
    }
    return true;
  }

  /// Where the point is when the crank turns a little on, or back; nothing where it cannot.
  [[nodiscard]] std::optional<Point> point_beside(double by) const {
    const auto places = places_at(turned_ + by);
    if (!places) return std::nullopt;
    const bool first = std::abs((*places)[0] - b_) < std::abs((*places)[1] - b_);
    return point_at(crank_at(turned_ + by), (*places)[first ? 0 : 1]);
  }

 private:
  [[nodiscard]] Point crank_at(double turned) const {
    return bars_.input_fixed + direction(turned) * (bars_.input_moving - bars_.input_fixed);
  }
  [[nodiscard]] Point point_at(Point a, Point b) const { return a + along_ * (b - a); }

  // The meets of the circles that coupler and output link draw.
  [[nodiscard]] std::optional<std::array<Point, 2>> places_at(double turned) const {
    const Point a = crank_at(turned), to_fixed = bars_.output_fixed - a;
    const double square = std::norm(to_fixed);
    if (square == 0) return std::nullopt;
    const double h = lengths_.coupler, b = lengths_.output, share = 0.5 * (1 + (h - b) * (h + b) / square);
    const double across = h * h / square - share * share;
    if (across < 0) return std::nullopt;
    const double up = std::sqrt(across);
    return std::array<Point, 2>{a + to_fixed * Point{share, up}, a + to_fixed * Point{share, -up}};
  }

  // Where rounding leaves both in doubt the step is to be shorter.
  bool take(double step) {
    const auto places = places_at(turned_ + step);
    if (!places) return false;
    const Point expected = last_step_ == 0 ? b_ : b_ + (b_ - last_b_) * (step / last_step_);
    const std::array<double, 2> off = {std::abs((*places)[0] - expected), std::abs((*places)[1] - expected)};
    const std::size_t nearer = off[0] <= off[1] ? 0 : 1;
    if (off[nearer] > undoubted * std::abs((*places)[0] - (*places)[1])) return false;
    last_b_ = b_;
    b_ = (*places)[nearer];
    last_step_ = step;
    turned_ += step;
    return true;
  }

  FourBar bars_;
  LinkLengths lengths_;
  Point along_{}, b_, last_b_;
  double turned_ = 0, last_step_ = 0;
};

void look_at(const Walk& walk, const PrescribedPose& there, double sense, PathDrive& found) {
  const Point miss = there.pose.origin - walk.point();
  found.position_error = std::max(found.position_error, std::abs(miss));
  const auto on = walk.point_beside(probe), back = walk.point_beside(-probe);
  if (!on || !back) return;
  const Point rate = (*on - *back) / (2 * probe);
  if (std::norm(rate) == 0) return;
  found.timing_error = std::max(found.timing_error, std::abs(dot(miss, rate)) / std::norm(rate));
  if (there.derivatives.empty() || there.derivatives.front().origin == Point{}) return;
  const double off = std::arg(there.derivatives.front().origin * std::conj(sense * rate));
  found.direction_error = std::max(found.direction_error, std::abs(off));
}

}  // namespace

PathDrive drive_along_path(const FourBar& bars, Point point, std::span<const PrescribedPose> crank_poses,
                           double tolerance) {
  constexpr double same_direction = 1e-4;
  PathDrive found;
  Walk walk(bars, point);
  const double first = crank_poses.front().pose.angle;
  double sense = crank_poses.back().pose.angle < first ? -1 : 1;
  if (crank_poses.size() == 1 && !crank_poses.front().derivatives.empty())
    sense = crank_poses.front().derivatives.front().angle < 0 ? -1 : 1;
  found.passes = true;
  for (const PrescribedPose& there : crank_poses) {
    if (!walk.go_to(there.pose.angle - first)) {
      found.passes = false;
      return found;
    }
    look_at(walk, there, sense, found);
  }
  found.passes = found.position_error <= tolerance && found.direction_error <= same_direction;
  found.turns_fully = walk.go_to(sense * two_pi) && std::abs(walk.point() - point) <= tolerance;
  return found;
}

}  // namespace linkwright
