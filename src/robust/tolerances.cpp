#include "linkwright/robust/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 3> distribution_names = {"normal", "truncated_normal", "uniform"};
constexpr std::array<std::string_view, planar_parameters> planar_parameter_names = {
    "input",           "coupler",         "output",      "input_center_x", "input_center_y",
    "output_center_x", "output_center_y", "point_along", "point_across",   "driver"};
constexpr std::array<std::string_view, spherical_parameters> spherical_parameter_names = {"input", "coupler", "output",
                                                                                          "ground", "driver"};

constexpr std::size_t moving_links = 3;  // the first parameters

template <class Values>
Values squares(Values half, double deviation) {
  for (double& value : half) value = value * value * deviation * deviation;
  return half;
}

bool is_length(double value) { return value >= 0 && std::isfinite(value); }

void check_lengths(const LengthTolerances& length, std::vector<Error>& found) {
  const auto check = [&](double value, const char* place) {
    const std::string where = std::string("tolerances.length") + place;
    if (!is_length(value))
      found.push_back({"length_tolerance_range", where,
                       "a tolerance is half of its field: a length, 0 where the dimension is exact"});
    else
      check_number(value, "a tolerance", where, found);
  };
  const auto& [input, coupler, output, ground_pivots, point] = length;
  const std::array each = {input, coupler, output, ground_pivots, point};
  if (length == LengthTolerances::all(input) || std::none_of(each.begin(), each.end(), is_length))
    return check(input, "");
  check(input, ".input");
  check(coupler, ".coupler");
  check(output, ".output");
  check(ground_pivots, ".ground_pivots");
  check(point, ".point");
}

void check_angle(double value, const char* place, std::vector<Error>& found) {
  if (!(value >= 0 && value <= pi / 2))
    found.push_back({"angle_tolerance_range", place,
                     "a tolerance is half of its field: an angle between 0, where it is exact, and 90 degrees"});
}

void check_limit(const ToleranceLimit& limit, std::vector<Error>& found) {
  const auto mistake = [&](const char* code, const char* place, const char* message) {
    found.push_back({code, place, message});
  };
  const bool positive = limit.value > 0 && std::isfinite(limit.value);
  if (limit.kind == ToleranceLimit::Kind::angle && !(limit.value > 0 && limit.value <= pi))
    mistake("tolerance_limit_angle", "tolerances.limit.angle_deg",
            "the largest error of an angle lies above 0 and is at most 180 degrees");
  if (limit.kind == ToleranceLimit::Kind::position && !positive)
    mistake("tolerance_limit_position", "tolerances.limit.position",
            "the largest error of the position must be a positive length");
  if (limit.kind == ToleranceLimit::Kind::deviation && !positive)
    mistake("tolerance_limit_deviation", "tolerances.limit.deviation",
            "the largest distance from the line must be a positive length");
}

bool is_exact(const Tolerances& tolerances) {
  return tolerances.length == LengthTolerances{} && tolerances.clearance == 0 && tolerances.driver == 0 &&
         tolerances.link_angle == 0;
}

}  // namespace

std::vector<Error> mistakes_in(const Tolerances& tolerances) {
  std::vector<Error> found;
  const auto mistake = [&](const char* code, const char* place, const char* message) {
    found.push_back({code, place, message});
  };
  check_lengths(tolerances.length, found);
  if (!is_length(tolerances.clearance))
    mistake("clearance_range", "tolerances.clearance", "the clearance is a radius: a length, 0 where pins fit exactly");
  else
    check_number(tolerances.clearance, "the clearance", "tolerances.clearance", found);
  check_angle(tolerances.driver, "tolerances.driver_deg", found);
  check_angle(tolerances.link_angle, "tolerances.link_angle_deg", found);
  if (is_exact(tolerances))
    mistake("tolerances_none", "tolerances",
            "no tolerance is given: give that of lengths or link angles, of the driver, or a clearance");
  if (tolerances.turning_length && !is_length(*tolerances.turning_length))
    mistake("turning_length_range", "tolerances.turning_length",
            "the turning length must be a length; 0 leaves angles out, null weighs them by the size of the task");
  if (tolerances.limit) check_limit(*tolerances.limit, found);
  if (tolerances.cost_exponent && !(*tolerances.cost_exponent > 0 && std::isfinite(*tolerances.cost_exponent)))
    mistake("cost_exponent_range", "tolerances.cost.exponent",
            "the exponent of the cost must be a positive number; 1 to 2 is usual");
  if (tolerances.samples < least_samples || tolerances.samples > most_samples)
    mistake("tolerance_samples_range", "tolerances.samples", "the number of samples lies between 1000 and 10000000");
  if (tolerances.seed > largest_seed)
    mistake("tolerance_seed_range", "tolerances.seed", "the seed is a whole number between 0 and 9007199254740991");
  return found;
}

std::string_view name(ToleranceDistribution distribution) {
  return distribution_names[static_cast<std::size_t>(distribution)];
}

std::optional<ToleranceDistribution> tolerance_distribution_named(std::string_view name) {
  const auto found = std::find(distribution_names.begin(), distribution_names.end(), name);
  if (found == distribution_names.end()) return std::nullopt;
  return static_cast<ToleranceDistribution>(found - distribution_names.begin());
}

std::string_view name(PlanarParameter parameter) { return planar_parameter_names[static_cast<std::size_t>(parameter)]; }

std::string_view name(SphericalParameter parameter) {
  return spherical_parameter_names[static_cast<std::size_t>(parameter)];
}

double standard_deviation(ToleranceDistribution distribution) {
  switch (distribution) {
    case ToleranceDistribution::truncated_normal:
      // √(1 − 6 φ(3) / (2 Φ(3) − 1)) of the normal's.
      return 0.9865783925581086 / 3;
    case ToleranceDistribution::uniform:
      return 1 / std::sqrt(3.0);
    default:
      return 1.0 / 3;
  }
}

PlanarValues planar_half_tolerances(const Tolerances& tolerances) {
  const LengthTolerances& t = tolerances.length;
  return {t.input,         t.coupler,       t.output, t.ground_pivots, t.ground_pivots,
          t.ground_pivots, t.ground_pivots, t.point,  t.point,         tolerances.driver};
}

SphericalValues spherical_half_tolerances(const Tolerances& tolerances) {
  const double arc = tolerances.link_angle;
  return {arc, arc, arc, arc, tolerances.driver};
}

PlanarValues planar_reach(const Tolerances& tolerances) {
  PlanarValues reach = planar_half_tolerances(tolerances);
  for (std::size_t link = 0; link < moving_links; ++link) reach[link] += 2 * tolerances.clearance;
  return reach;
}

PlanarValues planar_variances(const Tolerances& tolerances) {
  PlanarValues variances = squares(planar_half_tolerances(tolerances), standard_deviation(tolerances.distribution));
  for (std::size_t link = 0; link < moving_links; ++link)
    variances[link] += tolerances.clearance * tolerances.clearance / 2;
  return variances;
}

SphericalValues spherical_variances(const Tolerances& tolerances) {
  return squares(spherical_half_tolerances(tolerances), standard_deviation(tolerances.distribution));
}

}  // namespace linkwright
