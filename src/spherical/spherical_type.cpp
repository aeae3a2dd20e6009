#include "linkwright/spherical/spherical_type.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "spherical/spherical_triangle.hpp"

namespace linkwright {
namespace {

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
