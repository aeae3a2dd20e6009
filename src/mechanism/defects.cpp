#include "linkwright/mechanism/defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "mechanism/pair_judge.hpp"
#include "mechanism/triangle.hpp"

#define LINKWRIGHT_ISA isa_single
#include "mechanism/pair_verdict.hpp"

namespace linkwright {
namespace {

static_assert(isa_single::ccw_bit == DriverSequence::ccw_bit && isa_single::cw_bit == DriverSequence::cw_bit);

constexpr std::array<std::string_view, 4> sense_names = {"", "ccw", "cw", "either"};

LinkInPositions grounded_link(Point center, Point circle, std::span<const PrescribedPose> poses) {
  LinkInPositions link{center, circle, {}};
  for (std::size_t j = 0; j < poses.size(); ++j)
    link.arm[j] = displaced(circle, poses.front().pose, poses[j].pose) - center;
  return link;
}

// A field of the driver, or of the driven links, of which there is one.
double& only(double& value) { return value; }
double& only(double (&values)[1]) { return values[0]; }

template <class Side>
void place(Side& side, const LinkInPositions& link, int positions) {
  only(side.center_x) = link.center.real();
  only(side.center_y) = link.center.imag();
  only(side.circle_x) = link.circle.real();
  only(side.circle_y) = link.circle.imag();
  only(side.length) = std::sqrt(std::norm(link.circle - link.center));
  for (std::size_t j = 0; j < static_cast<std::size_t>(positions); ++j) {
    only(side.arm_x[j]) = link.arm[j].real();
    only(side.arm_y[j]) = link.arm[j].imag();
  }
}

// From the vectors themselves: near a dead point a cosine has lost half the digits of its angle.
double angle_at_ends(const LinkInPositions& input, const LinkInPositions& output, std::size_t last) {
  const auto angle_at = [&](std::size_t j) {
    const Point coupler = (output.center + output.arm[j]) - (input.center + input.arm[j]);
    return acute(std::atan2(std::abs(cross(coupler, output.arm[j])), dot(coupler, output.arm[j])));
  };
  return std::min(angle_at(0), angle_at(last));
}

// Where the input lies along the frame, opposite to it.
double angle_on_the_way(const LinkLengths& l, bool passes_0, bool passes_pi) {
  const auto angle_at = [&](double diagonal) {
    return acute(angle_opposite(diagonal, l.coupler, l.output, diagonal_slack(l)));
  };
  return std::min(passes_0 ? angle_at(std::abs(l.ground - l.input)) : pi / 2,
                  passes_pi ? angle_at(l.ground + l.input) : pi / 2);
}

isa_single::PairVerdict<1> verdict(const LinkInPositions& input, const LinkInPositions& output, std::size_t positions,
                                   std::uint8_t senses, std::uint8_t half_turn_senses) {
  return isa_single::with_position_count(static_cast<int>(positions), [&](auto count) {
    constexpr int poses = decltype(count)::value;
    isa_single::Driver<poses> driver{};
    isa_single::DrivenLinks<poses, 1> driven{};
    place(driver, input, poses);
    place(driven, output, poses);
    driver.admissible_directions = senses;
    driver.at_least_half_turn = half_turn_senses;
    return isa_single::pair_verdict<1>(driver, driven, 0, isa_single::distances<1>(driver, driven, 0),
                                       tolerance::change_point);
  });
}

// hb − |cos μ|·hb and hb, in digits of the difference.
double versine(double worst, double hb) { return std::max(hb - worst, 0.0) / hb; }

}  // namespace

std::string_view name(DriveSense sense) { return sense_names[static_cast<std::size_t>(sense)]; }

DriveSense drive_sense(bool ccw, bool cw) {
  if (ccw) return cw ? DriveSense::either : DriveSense::ccw;
  return cw ? DriveSense::cw : DriveSense::none;
}

DefectReport find_defects(const FourBar& four_bar, std::span<const PrescribedPose> poses, bool respect_direction) {
  require(!poses.empty() && poses.size() <= 5, "one to five poses are judged");
  const LinkInPositions input = grounded_link(four_bar.input_fixed, four_bar.input_moving, poses);
  const LinkInPositions output = grounded_link(four_bar.output_fixed, four_bar.output_moving, poses);
  const DriverSequence order = driver_sequence(input.center, four_bar.input_moving, poses, respect_direction);
  const auto v = verdict(input, output, poses.size(), order.senses(), order.half_turn_senses());
  DefectReport report;
  report.type = static_cast<LinkageType>(v.type);
  report.defects = Defects{static_cast<std::uint8_t>(v.defects)};
  if (v.clean) {
    report.sense = drive_sense(v.travels_ccw, v.travels_cw);
    report.min_transmission_angle = std::min(angle_at_ends(input, output, poses.size() - 1),
                                             angle_on_the_way(four_bar.lengths(), v.passes_0, v.passes_pi));
    report.sweep = v.travels_ccw ? order.sweep_ccw : order.sweep_cw();
  }
  if (v.turns) report.min_transmission_angle_full_turn = angle_on_the_way(four_bar.lengths(), true, true);
  return report;
}

PairJudgement judge_pair(const LinkInPositions& input, const LinkInPositions& output, std::size_t positions,
                         std::uint8_t senses, std::uint8_t half_turn_senses) {
  const auto v = verdict(input, output, positions, senses, half_turn_senses);
  PairJudgement judged;
  judged.type = static_cast<LinkageType>(v.type);
  if (judged.type == LinkageType::degenerate) return judged;
  judged.defects = Defects{static_cast<std::uint8_t>(v.defects)};
  if (v.clean) judged.versine = versine(v.worst, v.hb);
  if (v.turns) judged.full_versine = versine(v.worst_turn, v.hb);
  judged.ratio = v.longest / v.shortest;
  judged.longest = v.longest;
  return judged;
}

}  // namespace linkwright
