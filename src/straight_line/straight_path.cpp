#include "linkwright/straight_line/straight_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "algebra/polynomial_roots.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

using Series = RealSeries<motion_order>;

constexpr std::array<std::string_view, 4> end_names = {"deviation", "turn", "travel", "unfinished"};
constexpr int max_stretches = 400;  // ordinary paths take 5 to 20 each way

Series slope_of(const Series& series) {
  Series slope;
  for (std::size_t k = 0; k < motion_order; ++k) slope.c[k] = static_cast<double>(k + 1) * series.c[k + 1];
  return slope;
}
double value(const Series& series, double t) { return polynomial_value(series.c, t); }

Series shifted(Series series, double by) {
  series.c[0] -= by;
  return series;
}
void reverse(Series& series) {
  for (std::size_t k = 1; k <= motion_order; k += 2) series.c[k] = -series.c[k];
}
void reverse(ComplexSeries<motion_order>& series) {
  for (std::size_t k = 1; k <= motion_order; k += 2) series.c[k] = -series.c[k];
}

// Turns of the three links from where the linkage lay at first.
struct Turns {
  double input = 0, coupler = 0, output = 0;
};

TracingFourBar turned(const TracingFourBar& from, const Turns& turns) {
  const FourBar& bars = from.bars;
  const Point coupler = direction(turns.coupler);
  const Point input = bars.input_fixed + direction(turns.input) * (bars.input_moving - bars.input_fixed);
  return {{bars.input_fixed, input, bars.output_fixed,
           bars.output_fixed + direction(turns.output) * (bars.output_moving - bars.output_fixed)},
          input + coupler * (from.point - bars.input_moving)};
}

// The nearest turns that close the loop, by Newton's method with the shortest corrections; nothing where it does not
// settle.
std::optional<Turns> closed(const TracingFourBar& from, Turns turns) {
  const Point coupler_link = from.bars.output_moving - from.bars.input_moving;
  const double size = from.bars.lengths().perimeter();
  double left = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 8; ++turn) {
    const FourBar now = turned(from, turns).bars;
    const Point input = now.input_moving - now.input_fixed, coupler = direction(turns.coupler) * coupler_link,
                output = now.output_moving - now.output_fixed;
    const Point gap = (now.input_moving + coupler - now.output_moving) / size;
    if (std::abs(gap) <= 2 * tolerance::loop_rounding || (std::abs(gap) <= tolerance::closed && std::abs(gap) >= left))
      return turns;
    if (!(std::abs(gap) < left)) return std::nullopt;
    left = std::abs(gap);
    const Vector3 x = Vector3{input.real(), coupler.real(), -output.real()} / size,
                  y = Vector3{input.imag(), coupler.imag(), -output.imag()} / size, way = cross(x, y);
    // i Σ zⱼ fⱼ = −gap, as in loop_series().
    const Vector3 f = (gap.real() * cross(way, x) - gap.imag() * cross(y, way)) / dot(way, way);
    turns = {turns.input + f.x, turns.coupler + f.y, turns.output + f.z};
  }
  return std::nullopt;
}

// How far the series goes before its last terms show.
double exact_length(const LoopSeries& loop, const ComplexSeries<motion_order>& path, double size) {
  constexpr double shown = 1e-12, longest = 0.5;
  double length = longest;
  for (const std::size_t k : {motion_order - 1, motion_order}) {
    const double last = std::max({std::abs(loop.input.c[k]), std::abs(loop.coupler.c[k]), std::abs(loop.output.c[k]),
                                  std::abs(path.c[k]) / size});
    length = std::min(length, std::pow(shown / std::max(last, 1e-300), 1 / static_cast<double>(k)));
  }
  return length;
}

// The sign change nearest to 0 of a polynomial between 0 and t.
std::optional<double> first_change(std::span<const double> coefficients, double t) {
  const auto places = sign_changes_within(coefficients, std::min(t, 0.0), std::max(t, 0.0));
  if (places.empty()) return std::nullopt;
  return t > 0 ? places.front() : places.back();
}

double acute(double angle) { return std::min(angle, pi - angle); }

double transmission_angle_of(const FourBar& bars) {
  const Point coupler = bars.input_moving - bars.output_moving, output = bars.output_fixed - bars.output_moving;
  return acute(std::atan2(std::abs(cross(coupler, output)), dot(coupler, output)));
}

}  // namespace

std::string_view name(PathEnd end) { return end_names[static_cast<std::size_t>(end)]; }

// One way from where the linkage lies: sense 1 towards rising s, −1 towards falling.
struct StraightPath::Walk {
  const TracingFourBar& linkage;
  Point direction;
  const PathLimits& limits;
  int sense;
  std::vector<Stretch> stretches;
  PathEnd end = PathEnd::unfinished;

  std::optional<Stretch> stretch_at(const Turns& turns) const {
    const TracingFourBar now = turned(linkage, turns);
    auto loop = loop_series(now.bars);
    if (!loop) return std::nullopt;
    auto path = coupler_motion(now.bars, *loop).path_of(now.point);
    if (dot(direction, path.c[1]) < 0) {
      for (Series* turn : {&loop->input, &loop->coupler, &loop->output}) reverse(*turn);
      reverse(path);
    }
    Stretch stretch;
    for (std::size_t k = 0; k <= motion_order; ++k) {
      const Point c = k == 0 ? now.point - linkage.point : path.c[k];
      stretch.s.c[k] = dot(direction, c);
      stretch.e.c[k] = cross(direction, c);
    }
    const double length = exact_length(*loop, path, linkage.longest());
    (sense > 0 ? stretch.to : stretch.from) = sense * length;
    loop->input.c[0] = turns.input;
    loop->coupler.c[0] = turns.coupler;
    loop->output.c[0] = turns.output;
    stretch.loop = *loop;
    return stretch;
  }

  // Cut where the walk ends, if it does.
  bool cut(Stretch& stretch) {
    double& far = sense > 0 ? stretch.to : stretch.from;
    bool ends = false;
    // `series` is positive where the walk goes on; between two stretches lies a rounding, and a limit may lie in it.
    const auto cut_at = [&](const Series& series, PathEnd why) {
      const auto place = series.c[0] < 0 ? std::optional(0.0) : first_change(series.c, far);
      if (!place) return;
      far = *place;
      end = why;
      ends = true;
    };
    cut_at(slope_of(stretch.s), PathEnd::turn);
    if (std::isfinite(limits.max_deviation)) {
      cut_at(shifted(-1.0 * stretch.e, -limits.max_deviation), PathEnd::deviation);
      cut_at(shifted(stretch.e, -limits.max_deviation), PathEnd::deviation);
    }
    const double travel = sense > 0 ? limits.to : limits.from;
    if (std::isfinite(travel)) cut_at(-1.0 * sense * shifted(stretch.s, travel), PathEnd::travel);
    return ends;
  }

  void go() {
    Turns turns;
    for (int count = 0; count < max_stretches; ++count) {
      auto stretch = stretch_at(turns);
      if (!stretch) return;
      const bool ends = cut(*stretch);
      stretches.push_back(*stretch);
      if (ends) return;
      const double far = sense > 0 ? stretch->to : stretch->from;
      const auto next = closed(linkage, {value(stretch->loop.input, far), value(stretch->loop.coupler, far),
                                         value(stretch->loop.output, far)});
      if (!next) return;
      turns = *next;
    }
  }
};

std::optional<StraightPath> StraightPath::of(const TracingFourBar& linkage, Point direction, const PathLimits& limits) {
  require(limits.max_deviation > 0 && limits.from < 0 && limits.to > 0, "limits leave room on both sides of the point");
  Walk ahead{linkage, direction, limits, 1, {}, PathEnd::unfinished},
      back{linkage, direction, limits, -1, {}, PathEnd::unfinished};
  const auto first = ahead.stretch_at({});
  if (!first) return std::nullopt;
  const double speed = std::hypot(first->s.c[1], first->e.c[1]);
  if (!(speed > tolerance::resting_point * linkage.longest())) return std::nullopt;
  if (!(first->s.c[1] > tolerance::vanishing_deviation * speed)) return std::nullopt;
  ahead.go();
  back.go();
  StraightPath path;
  path.start_ = linkage;
  path.stretches_.assign(back.stretches.rbegin(), back.stretches.rend());
  path.first_ahead_ = path.stretches_.size();
  path.stretches_.insert(path.stretches_.end(), ahead.stretches.begin(), ahead.stretches.end());
  path.begin_ = back.end;
  path.end_ = ahead.end;
  return path;
}

double StraightPath::s_at(Place place) const { return value(stretches_[place.stretch].s, place.t); }
double StraightPath::e_at(Place place) const { return value(stretches_[place.stretch].e, place.t); }
double StraightPath::from() const { return s_at({0, stretches_.front().from}); }
double StraightPath::to() const { return s_at({stretches_.size() - 1, stretches_.back().to}); }

StraightPath::Place StraightPath::place_at(double s) const {
  std::size_t low = 0, high = stretches_.size();
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (s_at({middle, stretches_[middle].from}) <= s ? low : high) = middle;
  }
  const Stretch& stretch = stretches_[low];
  if (!(s > s_at({low, stretch.from}))) return {low, stretch.from};
  if (!(s < s_at({low, stretch.to}))) return {low, stretch.to};
  return {low, sign_change_between(shifted(stretch.s, s).c, stretch.from, stretch.to)};
}

// Where e − slope · s has an extreme for from ≤ s ≤ to, and both ends.
std::vector<StraightPath::Place> StraightPath::extremes(double from, double to, double slope) const {
  const Place first = place_at(from), last = place_at(to);
  std::vector<Place> found = {first};
  for (std::size_t i = first.stretch; i <= last.stretch; ++i) {
    const double low = i == first.stretch ? first.t : stretches_[i].from,
                 high = i == last.stretch ? last.t : stretches_[i].to;
    for (const double t :
         sign_changes_within((slope_of(stretches_[i].e) - slope * slope_of(stretches_[i].s)).c, low, high))
      found.push_back({i, t});
    if (i < last.stretch) found.push_back({i, high});
  }
  found.push_back(last);
  return found;
}

UsableLine StraightPath::within(double low, double high) const {
  UsableLine line{from(), to(), begin_, end_};
  const auto first_off = [&](const Stretch& stretch, double far) {
    // Between two stretches lies a rounding, and a limit may lie in it.
    if (stretch.e.c[0] < low || stretch.e.c[0] > high) return std::optional(0.0);
    std::optional<double> nearest;
    for (const double limit : {low, high})
      if (const auto place = first_change(shifted(stretch.e, limit).c, far))
        if (!nearest || std::abs(*place) < std::abs(*nearest)) nearest = place;
    return nearest;
  };
  for (std::size_t i = first_ahead_; i < stretches_.size(); ++i)
    if (const auto place = first_off(stretches_[i], stretches_[i].to)) {
      line.to = s_at({i, *place});
      line.end = PathEnd::deviation;
      break;
    }
  for (std::size_t i = first_ahead_; i-- > 0;)
    if (const auto place = first_off(stretches_[i], stretches_[i].from)) {
      line.from = s_at({i, *place});
      line.begin = PathEnd::deviation;
      break;
    }
  return line;
}

UsableLine StraightPath::usable(double deviation) const { return within(-deviation, deviation); }

// Strips of one width by the level of their lower edge, −width < level < 0: e rises or falls along each piece of the
// path, so that an edge is found in the one in which e leaves the strip.
struct StraightPath::Strips {
  struct Piece {
    std::size_t stretch = 0;
    double near = 0, far = 0, e_far = 0;
  };
  struct Exit {
    double s = 0, rate = 0;  ///< and by the level
  };
  const StraightPath& path;
  double width;
  std::vector<Piece> ahead, back;
  std::vector<double> levels;  ///< where an edge touches an extreme of e, and both ends

  Strips(const StraightPath& path, double width) : path(path), width(width), levels{-width, 0} {
    for (std::size_t i = path.first_ahead_; i < path.stretches_.size() && add_pieces(ahead, i); ++i) continue;
    for (std::size_t i = path.first_ahead_; i-- > 0 && add_pieces(back, i);) continue;
    std::sort(levels.begin(), levels.end());
  }

  // Whether e is still within the widest strip then.
  bool add_pieces(std::vector<Piece>& way, std::size_t i) {
    const Stretch& stretch = path.stretches_[i];
    std::vector<double> places = sign_changes_within(slope_of(stretch.e).c, stretch.from, stretch.to);
    places.insert(places.begin(), stretch.from);
    places.push_back(stretch.to);
    if (i < path.first_ahead_) std::reverse(places.begin(), places.end());
    for (std::size_t k = 1; k < places.size(); ++k) {
      const double e = path.e_at({i, places[k]});
      way.push_back({i, places[k - 1], places[k], e});
      for (const double level : {e, e - width})
        if (level > -width && level < 0) levels.push_back(level);
      if (std::abs(e) > width) return false;
    }
    return true;
  }

  Exit exit(const std::vector<Piece>& way, double level, double end) const {
    for (const Piece& piece : way) {
      if (piece.e_far >= level && piece.e_far <= level + width) continue;
      const Stretch& stretch = path.stretches_[piece.stretch];
      const Series off = shifted(stretch.e, piece.e_far < level ? level : level + width);
      // Between two stretches lies a rounding, and the edge may lie in it.
      const bool at_once = (value(off, piece.near) < 0) == (value(off, piece.far) < 0);
      const double t = at_once ? piece.near : sign_change_between(off.c, piece.near, piece.far);
      return {value(stretch.s, t), value(slope_of(stretch.s), t) / value(slope_of(stretch.e), t)};
    }
    return {end, 0};
  }
  struct Length {
    double length = 0, rate = 0;
  };
  Length length_at(double level) const {
    const Exit far = exit(ahead, level, path.to()), near = exit(back, level, path.from());
    return {far.s - near.s, far.rate - near.rate};
  }

  // Where the length is greatest between two levels, at which it rises and falls; it is flat there.
  double top_between(double low, double high) const {
    for (int turn = 0; turn < 60 && high - low > 1e-8 * width; ++turn) {
      const double middle = 0.5 * (low + high);
      (length_at(middle).rate > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
};

// Between two levels at which an edge touches an extreme of e the length changes smoothly. It jumps there, and on the
// very edge the path begins outside: the best may touch an extreme, and is looked for a hair beside it.
UsableLine StraightPath::usable_strip(double deviation) const {
  const Strips strips(*this, 2 * deviation);
  const double hair = 1e-9 * strips.width;
  double best = -deviation, longest = strips.length_at(best).length;
  const auto consider = [&](double level) {
    const Strips::Length there = strips.length_at(level);
    if (there.length > longest) longest = there.length, best = level;
    return there.rate;
  };
  constexpr int samples = 6;
  for (std::size_t i = 1; i < strips.levels.size(); ++i) {
    const double low = strips.levels[i - 1] + hair, high = strips.levels[i] - hair;
    if (!(low < high)) continue;
    double before = low;
    bool rose = consider(low) > 0;
    for (int k = 1; k <= samples; ++k) {
      const double level = k < samples ? low + k * (high - low) / samples : high;
      const bool rises = consider(level) > 0;
      if (rose && !rises) consider(strips.top_between(before, level));
      before = level;
      rose = rises;
    }
  }
  // Narrower than the rounding between two stretches it may begin outside: the tangent's strip is one as well.
  const UsableLine found = within(best, best + strips.width), tangent = usable(deviation);
  return found.length() < tangent.length() ? tangent : found;
}

// ½ min over k of the range of e − k s, a convex function of k: the next k is where the tangents of both sides meet.
double StraightPath::best_line(double from, double to) const {
  struct Line {
    double k, range, slope;
  };
  const auto at = [&](double k) {
    Place high, low;
    double most = -std::numeric_limits<double>::infinity(), least = -most;
    for (const Place place : extremes(from, to, k)) {
      const double off = e_at(place) - k * s_at(place);
      if (off > most) most = off, high = place;
      if (off < least) least = off, low = place;
    }
    return Line{k, most - least, s_at(low) - s_at(high)};
  };
  const Line level = at(0);
  const double steep = 3 * level.range / (to - from);
  if (!(steep > 0)) return 0;
  Line below = at(-steep), above = at(steep);
  double best = std::min({level.range, below.range, above.range});
  for (int turn = 0; turn < 60 && below.slope < 0 && above.slope > 0; ++turn) {
    const double k =
        (below.range - above.range + above.slope * above.k - below.slope * below.k) / (above.slope - below.slope);
    const Line next = at(k);
    const double bound = below.range + below.slope * (k - below.k);
    best = std::min(best, next.range);
    if (next.range - bound <= 1e-12 * level.range || next.slope == 0) break;
    (next.slope < 0 ? below : above) = next;
  }
  return best / 2;
}

std::optional<StrokeReport> StraightPath::stroke(double from, double to) const {
  const auto figures = stroke_figures(from, to);
  return figures ? std::optional(StrokeReport{*figures, best_line(from, to)}) : std::nullopt;
}

bool StraightPath::reaches(double from, double to) const {
  const double slack = 1e-12 * (this->to() - this->from());
  return from < to && from >= this->from() - slack && to <= this->to() + slack;
}

std::optional<StrokeFigures> StraightPath::stroke_figures(double from, double to) const {
  if (!reaches(from, to)) return std::nullopt;
  StrokeFigures report;
  report.from = from;
  report.to = to;
  const std::vector<Place> turning = extremes(from, to, 0);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Place place : turning) {
    low = std::min(low, e_at(place));
    high = std::max(high, e_at(place));
  }
  report.max_deviation = std::max(std::abs(low), std::abs(high));
  report.parallel_line_deviation = (high - low) / 2;
  report.middle_deviation = (high + low) / 2;

  report.min_transmission_angle = pi / 2;
  double slowest = std::numeric_limits<double>::infinity(), fastest = -slowest;
  bool turns_back = false;
  const Place first = place_at(from), last = place_at(to);
  for (std::size_t i = first.stretch; i <= last.stretch; ++i) {
    const Stretch& stretch = stretches_[i];
    const double begin = i == first.stretch ? first.t : stretch.from, end = i == last.stretch ? last.t : stretch.to;
    // The transmission angle has its extremes where the diagonal from the output's centre has.
    const Point arm = start_.bars.input_moving - start_.bars.input_fixed;
    ComplexSeries<motion_order> diagonal = arm * rotation(stretch.loop.input);
    diagonal.c[0] += start_.bars.input_fixed - start_.bars.output_fixed;
    Series square;
    for (std::size_t k = 0; k <= motion_order; ++k)
      for (std::size_t j = 0; j <= k; ++j) square.c[k] += dot(diagonal.c[j], diagonal.c[k - j]);
    std::vector<double> places = sign_changes_within(slope_of(square).c, begin, end);
    places.insert(places.end(), {begin, end});
    for (const double t : places)
      report.min_transmission_angle =
          std::min(report.min_transmission_angle, transmission_angle_of(linkage_at({i, t}).bars));
    const Series ds = slope_of(stretch.s), dinput = slope_of(stretch.loop.input);
    turns_back = turns_back || !sign_changes_within(dinput.c, begin, end).empty() || value(dinput, begin) == 0 ||
                 value(dinput, end) == 0;
    std::vector<double> speeds = sign_changes_within((slope_of(ds) * dinput - ds * slope_of(dinput)).c, begin, end);
    speeds.insert(speeds.end(), {begin, end});
    for (const double t : speeds) {
      const double speed = std::abs(value(ds, t) / value(dinput, t));
      slowest = std::min(slowest, speed);
      fastest = std::max(fastest, speed);
    }
  }
  if (!turns_back)
    report.drive = {
        value(stretches_[last.stretch].loop.input, last.t) - value(stretches_[first.stretch].loop.input, first.t),
        slowest, fastest};
  return report;
}

TracingFourBar StraightPath::linkage_at(Place place) const {
  const LoopSeries& loop = stretches_[place.stretch].loop;
  return turned(start_, {value(loop.input, place.t), value(loop.coupler, place.t), value(loop.output, place.t)});
}

std::vector<StraightPath::State> StraightPath::states(double first, double last, int count) const {
  require(count >= 2, "a path has two ends");
  std::vector<State> states;
  for (int i = 0; i < count; ++i) {
    const double s = first + (last - first) * i / (count - 1);
    const Place place = place_at(s);
    const Stretch& stretch = stretches_[place.stretch];
    states.push_back({s, e_at(place), linkage_at(place),
                      value(slope_of(stretch.s), place.t) / value(slope_of(stretch.loop.input), place.t)});
  }
  return states;
}

}  // namespace linkwright
