#include "linkwright/mechanism/spherical_defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "mechanism/spherical_triangle.hpp"

#define LINKWRIGHT_ISA isa_single_spherical
#include "mechanism/spherical_verdict.hpp"

namespace linkwright {
namespace {

static_assert(isa_single_spherical::ccw_bit == DriverSequence::ccw_bit &&
              isa_single_spherical::cw_bit == DriverSequence::cw_bit);

// A grounded link at each orientation.
struct TurnedLink {
  SphericalDyad dyad;
  std::vector<Vector3> moving;
};

TurnedLink turned_link(Vector3 fixed, Vector3 moving, std::span<const PrescribedOrientation> orientations) {
  TurnedLink link{{fixed, moving, 0}, {}};
  for (const PrescribedOrientation& there : orientations)
    link.moving.push_back(turned(moving, orientations.front().orientation, there.orientation));
  return link;
}

double& only(double& value) { return value; }
double& only(double (&values)[1]) { return values[0]; }

template <class Place>
void put(Place& place, Vector3 axis) {
  for (std::size_t i = 0; i < 3; ++i) only(place[i]) = axis[i];
}

template <class Side>
void put(Side& side, const TurnedLink& link) {
  put(side.fixed, link.dyad.fixed_axis);
  for (std::size_t j = 0; j < link.moving.size(); ++j) {
    put(side.moving[j], link.moving[j]);
    put(side.normal[j], cross(link.dyad.fixed_axis, link.moving[j]));
  }
  only(side.half_sine) = 0.5 * norm(link.dyad.fixed_axis - link.dyad.moving_axis);
  only(side.half_cosine) = 0.5 * norm(link.dyad.fixed_axis + link.dyad.moving_axis);
}

template <int Poses>
isa_single_spherical::SphericalVerdict<1> verdict(const TurnedLink& input, const TurnedLink& output,
                                                  const DriverSequence& order) {
  isa_single_spherical::SphericalDriver<Poses> driver{};
  isa_single_spherical::SphericalDrivenLinks<Poses, 1> driven{};
  put(driver, input);
  put(driven, output);
  driver.admissible_directions = order.senses();
  driver.at_least_half_turn = order.half_turn_senses();
  return isa_single_spherical::spherical_verdict<1>(driver, driven, 0, tolerance::change_point);
}

// Of coupler and output link at the output's moving axis, by the planes that they lie in.
double angle_between_links(Vector3 input_moving, Vector3 output_moving, Vector3 output_fixed) {
  return transmission_angle({{}, input_moving, output_moving, output_fixed});
}

double angle_on_the_way(const LinkAngles& l, bool passes_0, bool passes_pi) {
  const auto angle_at = [&](double diagonal) { return acute_angle(angle_opposite_arc(diagonal, l.coupler, l.output)); };
  const double far = l.ground + l.input;
  return std::min(passes_0 ? angle_at(std::abs(l.ground - l.input)) : pi / 2,
                  passes_pi ? angle_at(shorter_arc(far)) : pi / 2);
}

constexpr std::array<std::string_view, 5> triple_rocker_names = {"none", "00", "0pi", "pi0", "pipi"};

double smallest_magnitude(const SphericalExcesses& t) {
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3), std::abs(t.t4)});
}

double together(const LinkAngles& angles) {
  double sum = 0;
  for (const double arc : angles.all()) sum += acute_angle(arc);
  return sum;
}

}  // namespace

DriverSequence driver_sequence(const SphericalDyad& dyad, std::span<const PrescribedOrientation> orientations,
                               bool respect_direction) {
  const Vector3 axis = dyad.fixed_axis;
  const auto in_plane = [&](Vector3 v) { return v - dot(v, axis) * axis; };
  const Vector3 first = in_plane(dyad.moving_axis), across = cross(axis, first);
  DriverSequenceBuilder order;
  for (const PrescribedOrientation& there : orientations) {
    const Vector3 moving = turned(dyad.moving_axis, orientations.front().orientation, there.orientation);
    order.meet(&there == &orientations.front() ? 0
                                               : wrap_positive(std::atan2(dot(moving, across), dot(moving, first))));
    if (respect_direction && !there.derivatives.empty())
      order.pass(determinant(axis, moving, cross(there.derivatives.front(), moving)));
  }
  return order.sequence();
}

DefectReport find_defects(const SphericalFourBar& four_bar, std::span<const PrescribedOrientation> orientations,
                          bool respect_direction) {
  require(!orientations.empty() && orientations.size() <= 5, "one to five orientations are judged");
  const TurnedLink input = turned_link(four_bar.input_fixed, four_bar.input_moving, orientations);
  const TurnedLink output = turned_link(four_bar.output_fixed, four_bar.output_moving, orientations);
  const DriverSequence order = driver_sequence(input.dyad, orientations, respect_direction);
  const auto v = isa_single_spherical::with_position_count(static_cast<int>(orientations.size()), [&](auto count) {
    return verdict<decltype(count)::value>(input, output, order);
  });
  const LinkAngles angles = four_bar.angles();
  DefectReport report;
  report.type = static_cast<LinkageType>(v.type);
  report.defects = Defects{static_cast<std::uint8_t>(v.defects)};
  if (v.clean) {
    report.sense = drive_sense(v.travels_ccw, v.travels_cw);
    const auto angle_at = [&](std::size_t j) {
      return angle_between_links(input.moving[j], output.moving[j], four_bar.output_fixed);
    };
    report.min_transmission_angle =
        std::min({angle_at(0), angle_at(orientations.size() - 1), angle_on_the_way(angles, v.passes_0, v.passes_pi)});
    report.sweep = v.travels_ccw ? order.sweep_ccw : order.sweep_cw();
  }
  if (v.turns) report.min_transmission_angle_full_turn = angle_on_the_way(angles, true, true);
  return report;
}

SphericalExcesses spherical_excesses(const LinkAngles& l) {
  const double frame = l.ground - l.input, rest = l.coupler - l.output;
  return {frame + rest, frame - rest, l.coupler + l.output - (l.ground + l.input), two_pi - l.sum()};
}

double change_point_margin(const LinkAngles& angles) {
  return smallest_magnitude(spherical_excesses(angles)) / together(angles);
}

LinkageType linkage_type(const LinkAngles& angles) {
  const SphericalExcesses t = spherical_excesses(angles);
  const double zero = tolerance::change_point * together(angles);
  if (!(angles.shortest() > zero)) return LinkageType::degenerate;
  if (!(smallest_magnitude(t) > zero)) return LinkageType::change_point;
  const bool passes_0 = t.t1 * t.t2 > 0, passes_pi = t.t3 * t.t4 > 0, output_crank = t.t1 * t.t3 < 0;
  if (passes_0 != passes_pi) return LinkageType::triple_rocker;
  if (passes_0) return output_crank ? LinkageType::double_crank : LinkageType::crank_rocker;
  return output_crank ? LinkageType::rocker_crank : LinkageType::double_rocker;
}

// Seen from the continuation, the output's angle 0 is where its own triangle has π.
TripleRockerKind triple_rocker_kind(const LinkAngles& angles) {
  if (linkage_type(angles) != LinkageType::triple_rocker) return TripleRockerKind::none;
  const SphericalExcesses t = spherical_excesses(angles);
  const bool input_about_pi = t.t3 * t.t4 > 0, output_about_pi = t.t1 * t.t3 < 0;
  if (input_about_pi) return output_about_pi ? TripleRockerKind::pi_pi : TripleRockerKind::pi_zero;
  return output_about_pi ? TripleRockerKind::zero_pi : TripleRockerKind::zero_zero;
}

std::string_view name(TripleRockerKind kind) { return triple_rocker_names[static_cast<std::size_t>(kind)]; }

}  // namespace linkwright
