#include "approximate/fit_result.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <variant>

#include "approximate/drive_verdict.hpp"

namespace linkwright {
namespace {

// One of the up to six linkages that trace the curve – three four-bars, from either grounded link – with its states.
struct Realisation {
  CouplerLinkage linkage;
  std::vector<LoopState> states;
  CurveDriver input, output;

  [[nodiscard]] Realisation swapped() const {
    Realisation other{linkwright::swapped(linkage), {}, output, input};
    for (const LoopState& at : states) other.states.push_back(linkwright::swapped(linkage, at));
    return other;
  }
  // Its input turns as the coupler does, its output as this one's.
  [[nodiscard]] Realisation cognate() const {
    const auto coupler = static_cast<CurveDriver>(3 - static_cast<int>(input) - static_cast<int>(output));
    Realisation other{linkwright::cognate(linkage), {}, coupler, output};
    for (const LoopState& at : states) other.states.push_back(linkwright::cognate(linkage, at));
    return other;
  }
};

// Those on the first pivot, then those between the others; two to a four-bar, one after the other.
std::vector<Realisation> realisations_of(const CouplerLinkage& linkage, std::span<const LoopState> states) {
  constexpr double no_arm = 1e-9;
  const Realisation first{linkage, {states.begin(), states.end()}, CurveDriver::e, CurveDriver::g};
  const Realisation second = first.swapped();
  std::vector<Realisation> all = {first, second};
  const double size = linkage.lengths().longest();
  if (std::min(std::abs(linkage.p), std::abs(second.linkage.p)) <= no_arm * size) return all;
  for (const Realisation& from : {first, second}) {
    all.push_back(from.cognate());
    all.push_back(all.back().swapped());
  }
  return all;
}

double least_sine(const Realisation& of) {
  double least = 1;
  for (const LoopState& at : of.states)
    least = std::min(least, std::abs(cross(at.u, LoopGradient(of.linkage, at).g)) / of.linkage.b);
  return least;
}

bool moving_pivots_within(const std::optional<PivotWindow>& window, const FourBar& bars) {
  if (!window) return true;
  const auto in = [&](Point p) { return contains(*window, Vector3{p.real(), p.imag(), 0}); };
  return in(bars.input_moving) && in(bars.output_moving);
}

bool fixed_pivots_within(const std::optional<PivotWindow>& window, const CouplerLinkage& linkage, double length) {
  if (!window) return true;
  const auto in = [&](Point p) { return distance_to(*window, Vector3{p.real(), p.imag(), 0}) <= limit_slack * length; };
  return in(linkage.a0) && in(linkage.b0);
}

bool has_given_pivots(const CurveFitOptions& options, const CouplerLinkage& linkage, double length) {
  const auto is_at = [&](const std::optional<Point>& given, Point p) {
    return !given || std::abs(*given - p) <= limit_slack * length;
  };
  return is_at(options.input_pivot, linkage.a0) && is_at(options.output_pivot, linkage.b0);
}

bool keeps(const FitLimits& limits, const CurveFitOptions& options, const Realisation& of, double diagonal) {
  const LinkLengths lengths = of.linkage.lengths();
  const PivotWindows& windows = options.windows;
  return has_given_pivots(options, of.linkage, diagonal) &&
         lengths.longest() <= (1 + limit_slack) * limits.max_length &&
         lengths.shortest() >= (1 - limit_slack) * limits.min_length &&
         lengths.longest() <= (1 + limit_slack) * limits.max_link_ratio * lengths.shortest() &&
         grashof_excess(lengths) >= limits.grashof_margin - limit_slack * diagonal &&
         least_sine(of) >= limits.min_sine - limit_slack &&
         least_turn_sine(lengths) >= limits.min_turn_sine - limit_slack &&
         fixed_pivots_within(windows.ground, of.linkage, diagonal) &&
         moving_pivots_within(windows.moving, placed(of.linkage, of.states.front()).bars);
}

// The one to be driven: free of defects and within the limits; then the better it transmits, then the shorter.
std::size_t best_realisation(const std::vector<Realisation>& all, const CircuitDrive& drive, bool closed,
                             const std::vector<bool>& within) {
  const auto rank = [&](std::size_t k) {
    const Realisation& of = all[k];
    const bool can = verdict(drive, of.input, of.output).no_defects(closed);
    return std::tuple(can && within[k], can, bool{within[k]}, drive.of(of.input).min_sine,
                      -of.linkage.lengths().longest());
  };
  std::size_t best = 0;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (rank(k) > rank(best)) best = k;
  return best;
}

std::vector<FitState> told_states(const Realisation& of, std::span<const double> turns, const CurveTarget& target) {
  std::vector<FitState> told;
  const double first = std::arg(of.states[0].e);
  for (std::size_t j = 0; j < of.states.size(); ++j) {
    const TracingFourBar at = placed(of.linkage, of.states[j]);
    told.push_back({at.bars, first + turns[j], at.point, std::abs(at.point - target.points[j])});
  }
  return told;
}

CurveError told_error(const std::vector<FitState>& states, const CurveTarget& target, const CircuitDrive& drive) {
  CurveError error;
  double weights = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const double weight = target.weights.empty() ? 1 : target.weights[j], distance = states[j].distance;
    weights += weight;
    error.sum_of_squares += weight * distance * distance;
    if (weight == 0 || distance <= error.max) continue;
    error.max = distance;
    error.max_at = j;
  }
  error.rms = std::sqrt(error.sum_of_squares / weights);
  error.rms_over_diagonal = error.rms / target.diagonal();
  error.excursion = drive.excursion;
  error.path_length_ratio = drive.path_length_ratio;
  return error;
}

double noise_of(const CouplerLinkage& linkage, std::span<const LoopState> states, const CurveTarget& target) {
  std::vector<double> squared;
  for (std::size_t j = 0; j < states.size(); ++j)
    squared.push_back(std::norm(traced_point(linkage, states[j]) - target.points[j]));
  return order_noise(squared, target.diagonal());
}

}  // namespace

FitLimits limits_of(const CurveFitOptions& options, bool closed, double diagonal) {
  FitLimits limits;
  limits.max_length = options.max_length * diagonal;
  limits.min_length = options.min_length * diagonal;
  limits.max_link_ratio = options.max_link_ratio;
  if (closed && options.grashof_margin) limits.grashof_margin = *options.grashof_margin * diagonal;
  limits.min_sine = std::sin(options.min_transmission_angle);
  if (closed) limits.min_turn_sine = limits.min_sine;
  return limits;
}

FitLimits scaled_limits(const CurveFitOptions& options, const ScaledTarget& target) {
  FitLimits limits = limits_of(options, target.closed, target.diagonal);
  const Box* box = options.windows.ground ? std::get_if<Box>(&*options.windows.ground) : nullptr;
  if (!box) return limits;
  const Point low = target.scaled({box->x_low, box->y_low}), high = target.scaled({box->x_high, box->y_high});
  limits.ground = Box{low.real(), high.real(), low.imag(), high.imag()};
  return limits;
}

CouplerLinkage in_user_frame(const CouplerLinkage& l, const ScaledTarget& target) {
  const double unit = target.radius;
  return {target.in_user_frame(l.a0), target.in_user_frame(l.b0), unit * l.a, unit * l.h, unit * l.b, unit * l.p};
}

CurveFit curve_fit_of(const CouplerLinkage& linkage, std::span<const LoopState> states, const CurveTarget& target,
                      const CurveFitOptions& options, FirstRealisation choice) {
  const double diagonal = target.diagonal();
  const CircuitDrive drive =
      drive_along_circuit(linkage, states, target.points, target.closed, noise_of(linkage, states, target));
  const std::vector<Realisation> all = realisations_of(linkage, states);
  const FitLimits limits = limits_of(options, target.closed, diagonal);
  std::vector<bool> within;
  for (const Realisation& of : all) within.push_back(keeps(limits, options, of, diagonal));
  const bool given = choice == FirstRealisation::as_given;
  const std::size_t first = given ? 0 : best_realisation(all, drive, target.closed, within);
  const Realisation& best = all[first];

  CurveFit fit;
  const auto list = [&](const Realisation& of) {
    fit.input_turns[fit.realisation_count] = input_turns(of.states, drive.of(of.input).turns);
    fit.realisations[fit.realisation_count++] = placed(of.linkage, of.states.front());
  };
  list(best);
  for (std::size_t k = 0; k < all.size(); k += 2)
    if (k / 2 != first / 2) list(all[k]);
  fit.states = told_states(best, fit.input_turns[0], target);
  fit.error = told_error(fit.states, target, drive);
  fit.drive = verdict(drive, best.input, best.output);
  fit.min_transmission_angle = std::asin(std::min(drive.of(best.input).min_sine, 1.0));
  fit.within_limits = within[first];
  constexpr double at_limit = 1e-3;
  fit.at_length_limit = best.linkage.lengths().longest() >= (1 - at_limit) * limits.max_length;
  return fit;
}

}  // namespace linkwright
