#include "linkwright/mechanism/pose_error.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/pose_visits.hpp"

namespace linkwright {
namespace {

/// The coupler of a four-bar on one branch, as its input turns.
class CouplerTravel {
 public:
  CouplerTravel(const FourBar& bars, const Pose& given, const RelaxedPose& wanted, Assembly assembly, double sense)
      : bars_(bars),
        coupler_(bars.output_moving - bars.input_moving),
        offset_(given.origin - bars.input_moving),
        wanted_(wanted.pose.origin),
        wanted_turn_(direction(wanted.pose.angle - given.angle)),
        size_(wanted.size),
        assembly_(static_cast<double>(assembly)),
        sense_(sense) {
    const LinkLengths lengths = bars.lengths();
    coupler_squared_ = lengths.coupler * lengths.coupler;
    output_squared_ = lengths.output * lengths.output;
  }

  struct Deviation {
    double distance = std::numeric_limits<double>::infinity(), angle = pi;
    double squared = std::numeric_limits<double>::infinity();  ///< of the combined miss
    double slope = 0;  ///< sign of its change by the turn; finite at dead points too
  };

  [[nodiscard]] Deviation at(double turn) const {
    const Point arm = direction(sense_ * turn) * (bars_.input_moving - bars_.input_fixed);
    const Point a = bars_.input_fixed + arm, diagonal = bars_.output_fixed - a;
    const double d = std::norm(diagonal);
    if (!(d > 0)) return {};  // the output link could lie anywhere
    // B from both ends of the diagonal, by its foot and its height over it.
    const double foot = (coupler_squared_ - output_squared_ + d) / (2 * d);
    const double height = std::sqrt(std::max(coupler_squared_ / d - foot * foot, 0.0));
    const Point link = diagonal * Point{foot, assembly_ * height}, output_arm = link - diagonal;
    const Point turned = link * std::conj(coupler_) / coupler_squared_, lever = turned * offset_;
    const Point gap = a + lever - wanted_, twist = turned * std::conj(wanted_turn_);
    const double angle = std::atan2(twist.imag(), twist.real());
    // Velocities times the joint's vector product, which vanishes at dead points: B moves square to the output link.
    const Point velocity = sense_ * Point{0, 1} * arm;
    const double joint = cross(link, output_arm), rate = -dot(velocity, output_arm);
    const double slope = dot(gap, joint * velocity + rate * Point{0, 1} * lever) + size_ * size_ * angle * rate;
    return {std::abs(gap), std::abs(angle), std::norm(gap) + size_ * size_ * angle * angle, assembly_ * slope};
  }

 private:
  FourBar bars_;
  Point coupler_, offset_, wanted_, wanted_turn_;
  double size_, assembly_, sense_;
  double coupler_squared_ = 0, output_squared_ = 0;
};

/// The range of turns in which the relaxed pose has its place.
AngleRange range_of(const PoseVisits& visits, std::size_t place) {
  const std::size_t count = visits.turn.size();
  const auto served = [&](std::size_t pose) { return visits.on_branch[pose]; };
  if ((place > 0 && !served(place - 1)) || (place < count && !served(place))) return visits.travel;
  // A crank may go on until it meets the first pose again.
  const double before = visits.full_turn ? visits.turn.back() - two_pi : visits.travel.from;
  const double after = visits.full_turn ? two_pi : visits.travel.to;
  const AngleRange range{place > 0 ? visits.turn[place - 1] : before, place < count ? visits.turn[place] : after};
  return range.from <= range.to ? range : visits.travel;
}

/// Sampled so that the samples lie close where the range ends at a dead point: there the coupler runs away with the
/// root of the turn.
constexpr int sides = 24;

class Nearest {
 public:
  Nearest(const CouplerTravel& travel, AngleRange range) : travel_(travel), range_(range) {}

  [[nodiscard]] PoseError find() const {
    int best = 0;
    double least = travel_.at(turn_at(0)).squared;
    for (int i = 1; i <= sides; ++i)
      if (const double squared = travel_.at(turn_at(i)).squared; squared < least) best = i, least = squared;
    const double refined = between(std::max(best - 1, 0), std::min(best + 1, sides));
    const double turn = travel_.at(refined).squared <= least ? refined : turn_at(best);
    const CouplerTravel::Deviation error = travel_.at(turn);
    return {error.distance, error.angle, turn};
  }

 private:
  [[nodiscard]] double turn_at(double place) const {
    const double share = (1 - std::cos(pi * place / sides)) / 2;
    return range_.from + share * (range_.to - range_.from);
  }

  /// Where the slope changes its sign: by secants, the end that stays being halved (the Illinois rule).
  [[nodiscard]] double between(double low, double high) const {
    double falling = travel_.at(turn_at(low)).slope, rising = travel_.at(turn_at(high)).slope;
    if (falling >= 0) return turn_at(low);
    if (rising <= 0) return turn_at(high);
    constexpr int max_steps = 60;
    int last = 0;
    double place = low, before = high;
    for (int step = 0; step < max_steps && std::abs(place - before) > tolerance::least_miss_place; ++step) {
      before = place;
      place = (low * rising - high * falling) / (rising - falling);
      const double slope = travel_.at(turn_at(place)).slope;
      if (slope == 0) return turn_at(place);
      const bool is_low = slope < 0;
      (is_low ? low : high) = place;
      (is_low ? falling : rising) = slope;
      const int side = is_low ? 1 : -1;
      if (side == last) (is_low ? rising : falling) /= 2;
      last = side;
    }
    return turn_at(place);
  }

  const CouplerTravel& travel_;
  AngleRange range_;
};

}  // namespace

std::optional<PoseError> pose_error(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                    const RelaxedPose& relaxed) {
  require(relaxed.index <= poses.size() && relaxed.size > 0, "the freed pose stands among the others");
  const PoseVisits visits = pose_visits(four_bar, poses);
  if (visits.turn.empty()) return std::nullopt;
  const CouplerTravel travel(four_bar, poses.front().pose, relaxed, visits.assembly.front(),
                             visits.counter_clockwise ? 1 : -1);
  return Nearest(travel, range_of(visits, relaxed.index)).find();
}

}  // namespace linkwright
