#include "planar/six_bar_glance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linkwright/planar/four_bar_map.hpp"

namespace linkwright {
namespace {

constexpr std::size_t directions = 8, task_positions = 4;
constexpr double no_turn = 1e-6;  // of one body to the other: the pole is too far away

std::array<Point, directions> even_directions() {
  std::array<Point, directions> units;
  for (std::size_t i = 0; i < directions; ++i)
    units[i] = std::polar(1.0, (static_cast<double>(i) + 0.5) * std::numbers::pi / directions);
  return units;
}

Point product(Point a, Point b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Positions 2 … 4 of body k seen from body x, as z ↦ turn z + shift.
struct RelativeMotion {
  RelativeMotion(const BodyPositions& x, const BodyPositions& k) {
    for (std::size_t j = 1; j < task_positions; ++j) {
      turn[j - 1] = product(std::conj(x.at[j].turn), k.at[j].turn);
      shift[j - 1] = x.back(k.at[j].reference, j) - product(turn[j - 1], k.at[0].reference);
    }
  }
  std::array<Point, task_positions - 1> turn, shift;
};

/// The condition that the image of pole + s u by a relative position is as far from pole + c as it was itself:
/// c · (s a + t) = s k + h.
struct LineCondition {
  LineCondition(Point turn, Point shift, Point u)
      : a(product(turn - 1.0, u)), t(shift), k(dot(shift, product(turn, u))), h(std::norm(shift) / 2) {}
  Point a, t;
  double k, h;
};

/// Links whose circle points lie on a line through the pole, in direction u.
void add_links_on_line(Point pole, Point u, const LineCondition& own, const LineCondition& second,
                       const LineCondition& third, std::vector<LinkHinges>& links) {
  const double d2 = cross(own.a, second.a), e2 = cross(own.a, second.t), d3 = cross(own.a, third.a),
               e3 = cross(own.a, third.t);
  const double square = d2 * third.k - d3 * second.k, last = e2 * third.h - e3 * second.h;
  const double linear = d2 * third.h + e2 * third.k - d3 * second.h - e3 * second.k;
  const double discriminant = linear * linear - 4 * square * last;
  if (!(discriminant >= 0)) return;
  const double q = -(linear + std::copysign(std::sqrt(discriminant), linear)) / 2;
  for (const double s : {q / square, last / q}) {
    const double by_second = d2 * s + e2, by_third = d3 * s + e3;
    const double along = std::abs(by_second) > std::abs(by_third) ? (second.k * s + second.h) / by_second
                                                                  : (third.k * s + third.h) / by_third;
    links.push_back({pole + along * Point{-own.a.imag(), own.a.real()}, pole + s * u});
  }
}

bool contains_both(const Box& box, const LinkHinges& link) { return box.contains(link[0]) && box.contains(link[1]); }

double farthest_hinge(const SixBar& a, const SixBar& b) {
  double farthest = 0;
  for (std::size_t j = 0; j < SixBar::joint_count; ++j)
    farthest = std::max(farthest, std::abs(a.joints[j].point - b.joints[j].point));
  return farthest;
}

}  // namespace

std::vector<LinkHinges> links_through_pole(const BodyPositions& x, const BodyPositions& k) {
  static const std::array<Point, directions> units = even_directions();
  const RelativeMotion motion(x, k);
  std::size_t m = 0;
  for (const std::size_t j : {1u, 2u})
    if (std::abs(motion.turn[j] - 1.0) > std::abs(motion.turn[m] - 1.0)) m = j;
  std::vector<LinkHinges> links;
  if (std::abs(motion.turn[m] - 1.0) < no_turn) return links;
  const Point pole = motion.shift[m] / (1.0 - motion.turn[m]);
  const auto shift = [&](std::size_t j) { return motion.shift[j] + product(motion.turn[j] - 1.0, pole); };
  const std::size_t second = (m + 1) % motion.turn.size(), third = (m + 2) % motion.turn.size();
  const Point second_shift = shift(second), third_shift = shift(third);
  links.reserve(2 * directions);
  for (const Point u : units)
    add_links_on_line(pole, u, {motion.turn[m], 0, u}, {motion.turn[second], second_shift, u},
                      {motion.turn[third], third_shift, u}, links);
  return links;
}

SixBarGlance::SixBarGlance(std::array<BodyPair, 2> added, const Box& box, const Requirements& wanted)
    : added_(added), box_(box), wanted_(wanted), least_sine_(std::sin(wanted.min_transmission_angle) * (1 - 1e-6)) {
  falls_apart_ = std::any_of(added.begin(), added.end(), [](BodyPair link) { return link == BodyPair{0, 2}; });
}

SixBarGlance::Links SixBarGlance::in_box(Links links) const {
  std::erase_if(links, [&](const LinkHinges& link) { return !contains_both(box_, link); });
  return links;
}

bool SixBarGlance::is_promising(const LinkHinges& link, BodyPair between, const BodyPositions& centers,
                                const std::array<BodyPositions, 4>& bodies) const {
  if (!falls_apart_ || !wanted_.no_defects) return true;
  const BodyPositions& guided = bodies[static_cast<std::size_t>(between.b)];
  const Point own = between.b == 2 ? bodies[1].at[0].reference : bodies[3].at[0].reference;  // b, d
  const double least = least_sine_ * std::abs(link[1] - own) * std::abs(link[1] - link[0]);
  double sign = 0;
  for (std::size_t j = 0; j < task_positions; ++j) {
    const Point z = guided.moved(link[1], j);
    const double area = cross(z - guided.moved(own, j), centers.moved(link[0], j) - z);
    if (j == 0) sign = area < 0 ? -1 : 1;
    if (!(area * sign > least)) return false;
  }
  return true;
}

SixBarGlance::Seen SixBarGlance::look_at(const std::array<BodyPositions, 4>& bodies) const {
  Seen seen;
  const auto body = [&](int i) -> const BodyPositions& { return bodies[static_cast<std::size_t>(i)]; };
  const auto [first, second] = added_;
  const bool same = first.a == second.a && first.b == second.b;
  const bool depends = second.a == 4 || second.b == 4;
  const Links firsts = in_box(links_through_pole(body(first.a), body(first.b)));
  if (firsts.empty()) return seen;
  const auto promising = [&](Links links, BodyPair between, const BodyPositions& centers) {
    std::erase_if(links, [&](const LinkHinges& link) { return !is_promising(link, between, centers, bodies); });
    return links;
  };
  const auto pair_up = [&](const Links& some, const Links& others) {
    for (const LinkHinges& link : some)
      for (const LinkHinges& other : others)
        if (link != other) seen.promising.push_back({link, other});
  };
  if (!depends) {
    const Links seconds = in_box(links_through_pole(body(second.a), body(second.b)));
    seen.six_bars = static_cast<std::int64_t>(firsts.size() * (seconds.size() - (same ? 1 : 0)));
    pair_up(promising(firsts, first, body(first.a)), promising(seconds, second, body(second.a)));
    return seen;
  }
  for (const LinkHinges& link : firsts) {
    const BodyPositions link_4 = positions_of_link(link, body(first.a), body(first.b));
    const BodyPositions &centers = second.a == 4 ? link_4 : body(second.a),
                        &circles = second.b == 4 ? link_4 : body(second.b);
    const Links seconds = in_box(links_through_pole(centers, circles));
    seen.six_bars += static_cast<std::int64_t>(seconds.size());
    if (is_promising(link, first, body(first.a), bodies))
      pair_up({link}, second.b == 4 ? seconds : promising(seconds, second, centers));
  }
  return seen;
}

double score_of(Objective objective, const SixBarRating& rating) {
  return rank_of(objective, planar_measures).score(rating.cell());
}

bool is_better(const SixBarProspect& a, const SixBarProspect& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.tau < b.tau;
}

std::vector<SixBarProspect> distinct(const std::vector<SixBarProspect>& sorted, std::size_t most, double least) {
  std::vector<SixBarProspect> kept;
  for (const SixBarProspect& prospect : sorted) {
    if (kept.size() >= most) break;
    const bool alike = std::any_of(kept.begin(), kept.end(), [&](const SixBarProspect& held) {
      return farthest_hinge(held.member.six_bar, prospect.member.six_bar) < least;
    });
    if (!alike) kept.push_back(prospect);
  }
  return kept;
}

std::vector<SixBarSolution> driven_exactly(const std::vector<SixBarProspect>& prospects, const SixBarTask& task,
                                           const SixBarRow& row, const Requirements& wanted,
                                           const SixBarChoice& choice) {
  std::vector<SixBarSolution> solutions;
  for (const SixBarProspect& prospect : prospects) {
    SixBarSolution exact = solution_of(task.poses, prospect.chain, row, prospect.member);
    if (!meets(with_defaults(wanted, prospect.chain), exact.member.six_bar, exact.rating)) continue;
    exact.local_optimum = prospect.local_optimum;
    solutions.push_back(std::move(exact));
  }
  if (is_of_analysis(choice.objective)) return solutions;
  std::sort(solutions.begin(), solutions.end(), [&](const SixBarSolution& a, const SixBarSolution& b) {
    const double one = score_of(choice.objective, a.rating), other = score_of(choice.objective, b.rating);
    return one != other ? one > other : a.member.coordinates < b.member.coordinates;
  });
  return solutions;
}

}  // namespace linkwright
