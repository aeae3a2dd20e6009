#include "six_bar_walk.hpp"

#define LINKWRIGHT_ISA isa_walk
#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "six_bar_strand.hpp"

namespace linkwright {
namespace {

using Lane = isa_walk::Vector<double>;

Lane in_lane(Point p) { return {p.real(), p.imag()}; }

}  // namespace

double dot(const TurnVector& a, const TurnVector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(const TurnVector& a) { return std::sqrt(dot(a, a)); }

TurnVector shortest_way(const SixBarTurns& from, const SixBarTurns& to) {
  TurnVector way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = std::arg(std::conj(from[i + 1]) * to[i + 1]);
  return way;
}

SixBarTurns stepped(const SixBarTurns& turns, const TurnVector& way) {
  SixBarTurns result = turns;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Lane r = isa_walk::stepped<1>(in_lane(turns[i + 1]), way[i]);
    result[i + 1] = {r.x, r.y};
  }
  return result;
}

SixBarStrand strand_at(const SixBarLoops& loops, const SixBarTurns& turns) {
  SixBarStrand strand{turns, {}, {}, 0, LoopValues(loops, turns)};
  const LoopValues& values = strand.values;
  isa_walk::LoopTerms<1> terms;
  for (std::size_t i = 0; i < 5; ++i) {
    terms.u[i] = in_lane(values.u[i]);
    terms.v[i] = in_lane(values.v[i]);
  }
  terms.f = in_lane(values.f);
  terms.g = in_lane(values.g);
  const isa_walk::StrandBall<1> ball = isa_walk::strand_ball<1>(terms);
  std::copy_n(ball.tangent, strand.tangent.size(), strand.tangent.begin());
  std::copy_n(ball.correction, strand.correction.size(), strand.correction.begin());
  strand.reach = ball.reach;
  return strand;
}

TurnVector times(double s, TurnVector v) {
  for (double& x : v) x *= s;
  return v;
}

TurnVector plus(TurnVector a, const TurnVector& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

double turn_between(const SixBarTurns& from, const SixBarTurns& to) {
  return std::arg(std::conj(from[SixBar::driver]) * to[SixBar::driver]);
}

std::optional<double> distance_to(const SixBarTurns& point, const SixBarStrand& here, const TurnVector& ahead,
                                  double length) {
  double chords = 0;  // shorter than the angles, and cheap
  for (std::size_t i = 1; i < point.size(); ++i) chords += std::norm(point[i] - here.turns[i]);
  if (!(chords <= here.reach * here.reach)) return std::nullopt;
  const TurnVector way = shortest_way(here.turns, point);
  if (!(norm(way) <= here.reach)) return std::nullopt;
  const double along = dot(ahead, way);
  const double wedge = norm(plus(way, times(-along, ahead))) / 2;
  if (along < -wedge || along > length + wedge) return std::nullopt;
  return along;
}

std::optional<SixBarStrand> corrected(const SixBarLoops& loops, const SixBarTurns& turns, double accuracy) {
  constexpr int max_corrections = 12;
  SixBarStrand strand = strand_at(loops, turns);
  for (int i = 0; i < max_corrections; ++i) {
    if (!(strand.reach > 0)) return std::nullopt;
    const double size = norm(strand.correction);
    // Near singular places rounding of the loops, 1e-15, is magnified as the reach is diminished.
    if (size <= std::max(accuracy, tolerance::loop_rounding_per_reach / strand.reach)) return strand;
    if (!(size < 1)) return std::nullopt;
    strand = strand_at(loops, stepped(strand.turns, strand.correction));
  }
  return std::nullopt;
}

bool SixBarProgress::met_all() const {
  return std::all_of(meetings.begin(), meetings.end(), [](const auto& meeting) { return meeting.has_value(); });
}

bool SixBarProgress::met_all_in_order() const {
  return met_all() && std::adjacent_find(meetings.begin(), meetings.end(), [](const auto& x, const auto& y) {
                        return !(x->arc < y->arc);
                      }) == meetings.end();
}

void SixBarProgress::meet(const SixBarLoops& loops, std::span<const SixBarTurns> wanted, const SixBarStrand& here,
                          const TurnVector& ahead, double step, double pose_tolerance) {
  for (std::size_t j = 1; j < wanted.size(); ++j) {
    if (meetings[j]) continue;
    const auto along = distance_to(wanted[j], here, ahead, step);
    if (!along) continue;
    const auto point = corrected(loops, stepped(here.turns, times(*along, ahead)), tolerance::on_curve);
    if (!point) continue;
    if (!(norm(shortest_way(point->turns, wanted[j])) <= std::min(pose_tolerance, here.reach / 4))) continue;
    meetings[j] = PositionMet{length + *along, turn + turn_between(here.turns, wanted[j])};
  }
}

bool met_all_between_them(const SixBarProgress& one, const SixBarProgress& other) {
  for (std::size_t j = 0; j < one.meetings.size(); ++j)
    if (!one.meetings[j] && !other.meetings[j]) return false;
  return true;
}

int likelier_sense(std::span<const SixBarTurns> wanted) {
  double ccw = 0, cw = 0;
  for (std::size_t j = 1; j < wanted.size(); ++j) {
    const double turn = wrap_positive(turn_between(wanted[j - 1], wanted[j]));
    ccw += turn;
    cw += two_pi - turn;
  }
  return ccw <= cw ? 1 : -1;
}

}  // namespace linkwright
