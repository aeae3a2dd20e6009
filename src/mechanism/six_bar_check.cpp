#include "linkwright/mechanism/six_bar_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

using Joints = std::array<Point, SixBar::joint_count>;
using Values = std::array<double, 2 * SixBar::joint_count>;

// Infinite where one of them is no number.
double largest_of(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// The hinges' coordinates under the constraints that bodies set: a distance, and where a third hinge lies to two
/// others.
class HingeSystem {
 public:
  explicit HingeSystem(const SixBar& six_bar) : six_bar_(six_bar) {
    for (std::size_t j = 0; j < SixBar::joint_count; ++j) {
      if (six_bar.joints[j].bodies[0] == 0 || six_bar.joints[j].bodies[1] == 0) continue;
      column_[j] = unknowns_;
      unknowns_ += 2;
    }
    for (int body = 1; body < SixBar::bodies; ++body) add_body(body);
    for (const SixBarLength& length : six_bar.lengths()) size_ = std::max(size_, length.length);
  }

  [[nodiscard]] double size() const { return size_; }

  /// Hinges near `guess` with the driver turned by `turn`; nothing where Newton's method fails.
  [[nodiscard]] std::optional<Joints> solved(Joints joints, double turn) const {
    constexpr int max_corrections = 12;
    const double enough = tolerance::last_newton_correction * size_;
    for (int i = 0; i < max_corrections; ++i) {
      const auto [jacobian, error] = equations(joints, turn);
      const auto change = solve(jacobian, error).x;
      const double largest = largest_of(change);
      if (!std::isfinite(largest)) return std::nullopt;
      for (std::size_t j = 0; j < joints.size(); ++j)
        if (column_[j]) joints[j] -= Point{change[*column_[j]], change[*column_[j] + 1]};
      if (largest <= enough) return joints;
    }
    return std::nullopt;
  }

  /// Velocities of the hinges for a unit rate of the driver, and the sign of the determinant, which changes at dead
  /// points.
  struct Rates {
    Joints velocity{};
    bool positive = false;
  };
  /// Nothing at a dead point.
  [[nodiscard]] std::optional<Rates> rates(const Joints& joints, double turn) const {
    Values driven{};
    const Point rate = Point{0, 1} * direction(turn) * (six_bar_.at(SixBar::b) - six_bar_.at(SixBar::a));
    driven[0] = rate.real();
    driven[1] = rate.imag();
    const auto [found, determinant] = solve(equations(joints, turn).jacobian, driven);
    if (!std::isfinite(largest_of(found))) return std::nullopt;
    Rates result;
    result.positive = determinant > 0;
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (column_[j]) result.velocity[j] = {found[*column_[j]], found[*column_[j] + 1]};
    return result;
  }

  /// Largest relative change of a distance between two hinges of a body.
  [[nodiscard]] double length_error(const Joints& joints) const {
    double worst = 0;
    for (const SixBarLength& length : six_bar_.lengths())
      worst =
          std::max(worst, std::abs(std::abs(joints[length.joints[1]] - joints[length.joints[0]]) / length.length - 1));
    return worst;
  }

 private:
  struct Distance {
    std::size_t from, to;
    double square;
  };
  struct Third {
    std::size_t first, second, third;
    Point shape;
  };

  void add_body(int body) {
    const std::vector<std::size_t> own = six_bar_.joints_of(body);
    const auto at = [&](std::size_t i) { return six_bar_.joints[own[i]].point; };
    // The driver's second hinge is where the driver's angle puts it.
    if (body != SixBar::driver) distances_.push_back({own[0], own[1], std::norm(at(1) - at(0))});
    if (own.size() == 3) thirds_.push_back({own[0], own[1], own[2], (at(2) - at(0)) / (at(1) - at(0))});
  }

  struct Equations {
    SmallMatrix jacobian;
    Values error{};
  };
  /// Row `row` by hinge `joint`: the linear form Re(conj(gradient) · change).
  void put(SmallMatrix& jacobian, std::size_t row, std::size_t joint, Point gradient) const {
    if (!column_[joint]) return;
    jacobian(row, *column_[joint]) += gradient.real();
    jacobian(row, *column_[joint] + 1) += gradient.imag();
  }
  /// Rows `row`, `row + 1`: the complex factor times the change of the hinge.
  void put_complex(SmallMatrix& jacobian, std::size_t row, std::size_t joint, Point factor) const {
    put(jacobian, row, joint, std::conj(factor));
    put(jacobian, row + 1, joint, Point{0, 1} * std::conj(factor));
  }

  [[nodiscard]] Equations equations(const Joints& joints, double turn) const {
    Equations e{SmallMatrix(unknowns_, unknowns_)};
    const Point a = six_bar_.at(SixBar::a);
    const Point b = a + direction(turn) * (six_bar_.at(SixBar::b) - a);
    std::size_t row = 0;
    const auto put_error = [&](Point error) {
      e.error[row] = error.real();
      e.error[row + 1] = error.imag();
      row += 2;
    };
    put_complex(e.jacobian, row, SixBar::b, 1);
    put_error(joints[SixBar::b] - b);
    for (const Third& third : thirds_) {
      put_complex(e.jacobian, row, third.third, 1);
      put_complex(e.jacobian, row, third.first, third.shape - 1.0);
      put_complex(e.jacobian, row, third.second, -third.shape);
      put_error(joints[third.third] - joints[third.first] - third.shape * (joints[third.second] - joints[third.first]));
    }
    for (const Distance& distance : distances_) {
      const Point way = joints[distance.to] - joints[distance.from];
      put(e.jacobian, row, distance.to, way);
      put(e.jacobian, row, distance.from, -way);
      e.error[row++] = (std::norm(way) - distance.square) / 2;
    }
    return e;
  }

  SixBar six_bar_;
  std::array<std::optional<std::size_t>, SixBar::joint_count> column_;  ///< of a moving hinge, the first of two
  std::vector<Distance> distances_;
  std::vector<Third> thirds_;
  std::size_t unknowns_ = 0;
  double size_ = 0;
};

double largest_move(const Joints& from, const Joints& to) {
  double most = 0;
  for (std::size_t j = 0; j < from.size(); ++j) most = std::max(most, std::abs(to[j] - from[j]));
  return most;
}

/// Hinges of the guided body where a pose wants them.
struct HingeTarget {
  std::array<Point, 2> hinges{};
  bool met = false;
};

class Drive {
 public:
  Drive(const SixBar& six_bar, std::span<const PrescribedPose> poses, int sense, const SixBarCheckOptions& options)
      : six_bar_(six_bar), system_(six_bar), poses_(poses), sense_(sense), options_(options) {
    const std::vector<std::size_t> own = six_bar.joints_of(SixBar::guided);
    guided_ = {own.front(), own.back()};
    for (const PrescribedPose& pose : poses) {
      const auto wanted = [&](std::size_t j) { return displaced(six_bar.joints[j].point, poses[0].pose, pose.pose); };
      targets_.push_back({{wanted(guided_[0]), wanted(guided_[1])}, false});
    }
    targets_.front().met = true;
    for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j] = six_bar.joints[j].point;
  }

  SixBarCheck run() && {
    constexpr double shortest_step = 1e-7;       // radians: hinges go with its root near a dead point, 3e-4
    constexpr std::size_t max_states = 100'000;  // thousands are many; each step is noted
    note(joints_, 0, 0);
    double step = options_.step;
    while (two_pi - std::abs(turn_) > shortest_step &&
           (options_.full_travel || check_.visited.size() + 1 < targets_.size())) {
      step = std::min(step, two_pi - std::abs(turn_));
      if (check_.states.size() >= max_states) {
        check_.stopped = true;
        break;
      }
      if (advance(step)) {
        step = std::min(options_.step, 1.5 * step);
      } else if (step /= 2; step < shortest_step) {
        check_.stopped = true;
        break;
      }
    }
    return std::move(check_);
  }

 private:
  /// One step of the driver; false where a shorter one is wanted.
  bool advance(double step) {
    // Hinges that run more than this in a step, or that much off the straight line, are followed more closely.
    constexpr double longest_move = 0.05, largest_bend = 0.1;
    const auto rates = system_.rates(joints_, turn_);
    if (!rates) return false;
    const Joints guess = ahead(rates->velocity, sense_ * step);
    const auto found = system_.solved(guess, turn_ + sense_ * step);
    if (!found) return false;
    const auto rates_there = system_.rates(*found, turn_ + sense_ * step);
    if (!rates_there || rates_there->positive != rates->positive) return false;
    const double move = largest_move(joints_, *found);
    if (move > longest_move * system_.size() || largest_move(guess, *found) > largest_bend * move) return false;
    meet(*found, step);
    joints_ = *found;
    turn_ += sense_ * step;
    note(joints_, turn_);
    return true;
  }

  [[nodiscard]] Joints ahead(const Joints& rates, double turn) const {
    Joints guess = joints_;
    for (std::size_t j = 0; j < guess.size(); ++j) guess[j] += turn * rates[j];
    return guess;
  }

  /// Poses on the step to `end`.
  void meet(const Joints& end, double step) {
    for (std::size_t p = 0; p < targets_.size(); ++p) {
      if (targets_[p].met || !is_near(end, targets_[p]) || !comes_to(targets_[p], step)) continue;
      targets_[p].met = true;
      check_.visited.push_back(static_cast<int>(p));
    }
  }

  [[nodiscard]] std::array<Point, 2> body(const Joints& joints) const {
    return {joints[guided_[0]], joints[guided_[1]]};
  }

  [[nodiscard]] bool is_near(const Joints& end, const HingeTarget& target) const {
    const auto from = body(joints_), to = body(end);
    double way = 0, off = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      way = std::max(way, std::abs(to[i] - from[i]));
      off = std::max(off, std::abs(target.hinges[i] - from[i]));
    }
    return off <= 2 * way + options_.pose_tolerance * system_.size();
  }

  /// Turns the driver, from here on and at most half a step beyond the step, to where the guided body is nearest to the
  /// target (Gauss–Newton): is it there?
  bool comes_to(const HingeTarget& target, double step) {
    constexpr int max_corrections = 30;
    constexpr double beyond = 0.5;
    Joints at = joints_;
    double turn = 0;
    for (int i = 0; i < max_corrections; ++i) {
      const auto rates = system_.rates(at, turn_ + turn);
      if (!rates) return false;
      const auto here = body(at), rate = body(rates->velocity);
      double along = 0, square = 0, off = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        along += dot(rate[k], target.hinges[k] - here[k]);
        square += std::norm(rate[k]);
        off = std::max(off, std::abs(target.hinges[k] - here[k]));
      }
      const double change = square > 0 ? along / square : 0;
      if (std::abs(change) < tolerance::nearest_turn) {
        if (off > options_.pose_tolerance * system_.size()) return false;
        check_.worst_pose = std::max(check_.worst_pose, off / system_.size());
        note(at, turn_ + turn, static_cast<int>(&target - targets_.data()));
        return true;
      }
      if ((turn + change) * sense_ < -beyond * step || (turn + change) * sense_ > (1 + beyond) * step) return false;
      // Shortly before a dead point the whole correction may lead beyond it.
      constexpr int max_halvings = 10;
      std::optional<Joints> next;
      double part = change;
      for (int k = 0; k < max_halvings && !next; ++k, part /= next ? 1 : 2)
        next = system_.solved(at, turn_ + turn + part);
      if (!next) return false;
      turn += part;
      at = *next;
    }
    return false;
  }

  void note(const Joints& joints, double turn, int pose = -1) {
    check_.worst_length = std::max(check_.worst_length, system_.length_error(joints));
    const Point before = six_bar_.joints[guided_[1]].point - six_bar_.joints[guided_[0]].point;
    const Point now = joints[guided_[1]] - joints[guided_[0]];
    const Pose& first = poses_[0].pose;
    const double angle = std::arg(now / before);
    const Point origin = joints[guided_[0]] + now / before * (first.origin - six_bar_.joints[guided_[0]].point);
    double body_turn = first.angle + angle;
    if (!check_.states.empty()) body_turn = body_turn_ + wrap_signed(body_turn - body_turn_);
    body_turn_ = body_turn;
    const Pose body{origin, body_turn};
    const BodyError error = pose < 0 ? BodyError{} : body_error(body, poses_[static_cast<std::size_t>(pose)].pose);
    check_.states.push_back({turn, joints, body, pose, error});
  }

  SixBar six_bar_;
  HingeSystem system_;
  std::span<const PrescribedPose> poses_;
  int sense_;
  SixBarCheckOptions options_;
  std::array<std::size_t, 2> guided_{};
  std::vector<HingeTarget> targets_;
  Joints joints_{};
  double turn_ = 0, body_turn_ = 0;
  SixBarCheck check_;
};

}  // namespace

SixBarCheck check_by_driving(const SixBar& six_bar, std::span<const PrescribedPose> poses, int sense,
                             const SixBarCheckOptions& options) {
  if (poses.empty()) return {};
  return Drive(six_bar, poses, sense, options).run();
}

}  // namespace linkwright
