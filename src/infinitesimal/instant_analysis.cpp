#include "linkwright/infinitesimal/instant_analysis.hpp"

#include "linkwright/core/tolerance.hpp"
#include "linkwright/infinitesimal/line_contact.hpp"
#include "linkwright/mechanism/position.hpp"
#include "special_configuration.hpp"

namespace linkwright {
namespace {

PathNow path_now(const MotionSeries& motion, Point point) {
  const Point velocity = motion.path_of(point).c[1];
  PathNow path{point, center_of_curvature(motion, point), 0, {}};
  if (std::abs(velocity) > 0) {
    path.tangent = velocity / std::abs(velocity);
    path.contact_points = contact_with_line(motion, point, path.tangent).points;
  }
  if (path.contact_points == 0) path.center = std::nullopt;
  if (path.contact_points > 2) path.center = Homogeneous::at_infinity(Point{0, 1} * velocity);
  return path;
}

InstantAnalysis analysis_of(const MotionSeries& motion, std::optional<Point> point) {
  InstantAnalysis analysis;
  analysis.instant = instant_of(motion);
  if (!analysis.instant) return analysis;
  if (const auto* turning = std::get_if<TurningInstant>(&*analysis.instant)) {
    analysis.ball_point = ball_point(*turning);
    if (turning->fourth) analysis.burmester_points = burmester_points_at(*turning);
  }
  if (point) analysis.point = path_now(motion, *point);
  return analysis;
}

// By time as the input turns with φ̇ = 1, φ̈ = acceleration; nothing at its dead point.
std::optional<MotionSeries> by_time(const MotionSeries& motion, const LoopSeries& loop, double acceleration) {
  if (!(std::abs(loop.input.c[1]) > tolerance::dead_point_sine)) return std::nullopt;
  RealSeries<motion_order> turn = RealSeries<motion_order>::variable(0);
  turn.c[2] = acceleration / 2;
  const auto parameter = composed(inverse(loop.input), turn);
  return MotionSeries{composed(motion.path, parameter), composed(motion.turn, parameter), motion.order};
}

void add_rates(InstantAnalysis& analysis, const MotionSeries& by_time) {
  analysis.rates = BodyRates{by_time.turn.derivative(1), by_time.turn.derivative(2)};
  if (std::holds_alternative<TranslatingInstant>(*analysis.instant)) analysis.rates->velocity = 0;
  analysis.bresse_circle = bresse_circle(*analysis.instant, by_time);
  analysis.acceleration_pole = acceleration_pole(by_time);
}

}  // namespace

InstantAnalysis analyze_instant(const FourBar& four_bar, const InstantQuestion& question) {
  const auto loop = loop_series(four_bar);
  if (!loop) {
    InstantAnalysis none;
    none.degenerate = {
        "no_instant_in_line",
        "all links lie in one line, from where the linkage can go on in more ways than one: turn its input "
        "a little",
        {}};
    return none;
  }
  const MotionSeries motion = coupler_motion(four_bar, *loop);
  InstantAnalysis analysis = analysis_of(motion, question.point);
  analysis.notes = special_configurations(four_bar);
  if (const auto timed = by_time(motion, *loop, question.input_acceleration))
    add_rates(analysis, *timed);
  else
    analysis.notes.push_back({"input_stands_still",
                              "the input stands at a dead point, so that nothing can be said by its turn: there are no "
                              "Bresse circle and no acceleration pole",
                              {}});
  return analysis;
}

std::optional<TracingFourBar> with_input_at(const TracingFourBar& linkage, double input_angle) {
  const FourBar& bars = linkage.bars;
  const auto there = assemble(bars.lengths(), input_angle, assembly_of(bars));
  if (!there) return std::nullopt;
  return linkage.moved_to(placed(bars, *there));
}

InstantAnalysis analyze_instant(const PrescribedPose& pose, std::optional<Point> point) {
  const MotionSeries motion = prescribed_motion(pose);
  InstantAnalysis analysis = analysis_of(motion, point);
  if (analysis.instant)
    add_rates(analysis, motion);
  else
    analysis.degenerate = {
        "body_at_rest",
        "the first derivative is zero, so that the body has neither a pole nor a direction of motion",
        {}};
  return analysis;
}

}  // namespace linkwright
