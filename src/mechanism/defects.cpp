#include "linkwright/mechanism/defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "mechanism/triangle.hpp"

#define LINKWRIGHT_ISA isa_single
#include "mechanism/pair_verdict.hpp"

namespace linkwright {
namespace {

static_assert(isa_single::ccw_bit == DriverSequence::ccw_bit && isa_single::cw_bit == DriverSequence::cw_bit);

constexpr std::array<std::string_view, 4> sense_names = {"", "ccw", "cw", "either"};

struct GroundedLink {
  Point center, circle;
  std::vector<Point> arm;  // from centre to circle point at each pose
};

GroundedLink grounded_link(Point center, Point circle, std::span<const PrescribedPose> poses) {
  GroundedLink link{center, circle, {}};
  for (const PrescribedPose& pose : poses)
    link.arm.push_back(displaced(circle, poses.front().pose, pose.pose) - center);
  return link;
}

// A field of the driver, or of the driven links, of which there is one.
double& only(double& value) { return value; }
double& only(double (&values)[1]) { return values[0]; }

template <class Side>
void place(Side& side, const GroundedLink& link) {
  only(side.center_x) = link.center.real();
  only(side.center_y) = link.center.imag();
  only(side.circle_x) = link.circle.real();
  only(side.circle_y) = link.circle.imag();
  only(side.length) = std::abs(link.circle - link.center);
  for (std::size_t j = 0; j < link.arm.size(); ++j) {
    only(side.arm_x[j]) = link.arm[j].real();
    only(side.arm_y[j]) = link.arm[j].imag();
  }
}

// From the vectors themselves: near a dead point a cosine has lost half the digits of its angle.
double angle_at_ends(const GroundedLink& input, const GroundedLink& output) {
  const auto angle_at = [&](std::size_t j) {
    const Point coupler = (output.center + output.arm[j]) - (input.center + input.arm[j]);
    return acute(std::atan2(std::abs(cross(coupler, output.arm[j])), dot(coupler, output.arm[j])));
  };
  return std::min(angle_at(0), angle_at(input.arm.size() - 1));
}

// Where the input lies along the frame, opposite to it.
double angle_on_the_way(const LinkLengths& l, bool passes_0, bool passes_pi) {
  const auto angle_at = [&](double diagonal) {
    return acute(angle_opposite(diagonal, l.coupler, l.output, diagonal_slack(l)));
  };
  return std::min(passes_0 ? angle_at(std::abs(l.ground - l.input)) : pi / 2,
                  passes_pi ? angle_at(l.ground + l.input) : pi / 2);
}

template <int Poses>
isa_single::PairVerdict<1> verdict(const GroundedLink& input, const GroundedLink& output, const DriverSequence& order) {
  isa_single::Driver<Poses> driver{};
  isa_single::DrivenLinks<Poses, 1> driven{};
  place(driver, input);
  place(driven, output);
  driver.admissible_directions = order.senses();
  driver.at_least_half_turn = order.half_turn_senses();
  return isa_single::pair_verdict<1>(driver, driven, 0, isa_single::distances<1>(driver, driven, 0),
                                     tolerance::change_point);
}

}  // namespace

std::string_view name(DriveSense sense) { return sense_names[static_cast<std::size_t>(sense)]; }

DriveSense drive_sense(bool ccw, bool cw) {
  if (ccw) return cw ? DriveSense::either : DriveSense::ccw;
  return cw ? DriveSense::cw : DriveSense::none;
}

DefectReport find_defects(const FourBar& four_bar, std::span<const PrescribedPose> poses, bool respect_direction) {
  require(!poses.empty() && poses.size() <= 5, "one to five poses are judged");
  const GroundedLink input = grounded_link(four_bar.input_fixed, four_bar.input_moving, poses);
  const GroundedLink output = grounded_link(four_bar.output_fixed, four_bar.output_moving, poses);
  const DriverSequence order = driver_sequence(input.center, four_bar.input_moving, poses, respect_direction);
  const auto v = isa_single::with_position_count(static_cast<int>(poses.size()), [&](auto count) {
    return verdict<decltype(count)::value>(input, output, order);
  });
  DefectReport report;
  report.type = static_cast<LinkageType>(v.type);
  report.defects = Defects{static_cast<std::uint8_t>(v.defects)};
  if (v.clean) {
    report.sense = drive_sense(v.travels_ccw, v.travels_cw);
    report.min_transmission_angle =
        std::min(angle_at_ends(input, output), angle_on_the_way(four_bar.lengths(), v.passes_0, v.passes_pi));
    report.sweep = v.travels_ccw ? order.sweep_ccw : order.sweep_cw();
  }
  if (v.turns) report.min_transmission_angle_full_turn = angle_on_the_way(four_bar.lengths(), true, true);
  return report;
}

}  // namespace linkwright
