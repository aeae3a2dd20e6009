#include "linkwright/straight_line/straight_line_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "symmetric_lambda.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

struct CaseName {
  std::string_view operator()(const FourPointPivots& /*given*/) const { return "four_point_pivots"; }
  std::string_view operator()(const FourPointCubic& /*given*/) const { return "four_point_cubic"; }
  std::string_view operator()(const BallPointOnSideLink& /*given*/) const { return "ball_point_on_side_link"; }
  std::string_view operator()(const IsoscelesTrapezoid& /*given*/) const { return "isosceles_trapezoid"; }
  std::string_view operator()(const PoleAtGivenPivot& /*given*/) const { return "pole_at_fixed_pivot"; }
  std::string_view operator()(const PoleAtFixedPivot& /*given*/) const { return "pole_at_fixed_pivot"; }
  std::string_view operator()(const PoleAtFixedPivotBallPointOnFrame& /*given*/) const {
    return "pole_at_fixed_pivot_ball_point_on_frame";
  }
  std::string_view operator()(const FivePoint& /*given*/) const { return "five_point"; }
  std::string_view operator()(const FivePointInflectionPole& /*given*/) const { return "five_point_inflection_pole"; }
  std::string_view operator()(const FivePointSideLinkOnFrame& /*given*/) const {
    return "five_point_side_link_on_frame";
  }
  std::string_view operator()(const SixPoint& /*given*/) const { return "six_point"; }
  std::string_view operator()(const ParallelSideLinks& /*given*/) const { return "parallel_side_links"; }
  std::string_view operator()(const MixedContacts& /*given*/) const { return "mixed"; }
  std::string_view operator()(const SymmetricLambdas& /*given*/) const { return "symmetric_lambda"; }
  std::string_view operator()(const Search& /*given*/) const { return "search"; }
};

// What is given beside the line, number by number.
class GivenCheck {
  static constexpr double least_share = 1e-9, most_share = 0.1;

 public:
  explicit GivenCheck(const DirectedLine& line, std::vector<Error>& found) : line_(line), found_(found) {}

  void operator()(const FourPointPivots& given) { check_pivots(given.input, given.output); }
  void operator()(const FourPointCubic& given) {
    check_pole_distance(given.pole_distance);
    check_point_ray(given.point_ray);
    if (given.cubic_n) {
      check(*given.cubic_n, "the number N", "task.cubic_n");
      if (*given.cubic_n == 0)
        mistake("cubic_n_zero", "task.cubic_n", "N is the diameter of a circle and not 0; null makes it infinite");
    }
  }
  void operator()(const BallPointOnSideLink& given) {
    check_point(given.input_pivot, "task.input_pivot");
    if (is_finite(given.input_pivot) && given.input_pivot == line_.point)
      mistake("pivot_at_point", "task.input_pivot", "the ground pivot is where the coupler point is; move one of them");
  }
  void operator()(const IsoscelesTrapezoid& given) {
    check(given.half_frame, "half of the ground link", "task.half_frame");
    if (std::isfinite(given.half_frame) && !(given.half_frame > 0))
      mistake("half_frame_positive", "task.half_frame", "half of the ground link is a positive length");
  }
  void operator()(const PoleAtGivenPivot& given) {
    check_pivots(given.input, given.output);
    check_arm(given.output_arm);
    if (is_finite(given.output) &&
        std::abs(line_.to_line(given.output).imag()) <= tolerance::no_difference * std::abs(given.output - line_.point))
      mistake("pole_on_line", "task.ground_pivots.output",
              "the pole lies on the line, where the point would rest; move the pivot off the line");
  }
  void operator()(const PoleAtFixedPivot& given) {
    check_pole_distance(given.pole_distance);
    check_arm(given.output_arm);
  }
  void operator()(const PoleAtFixedPivotBallPointOnFrame& given) { check_pole_distance(given.pole_distance); }
  void operator()(const FivePoint& given) {
    check_pole_distance(given.pole_distance);
    check_point_ray(given.point_ray);
  }
  void operator()(const FivePointInflectionPole& given) { check_pole_distance(given.pole_distance); }
  void operator()(const FivePointSideLinkOnFrame& given) { check_pole_distance(given.pole_distance); }
  void operator()(const SixPoint& given) { check_pole_distance(given.pole_distance); }
  void operator()(const ParallelSideLinks& given) {
    check(given.input_offset, "an offset", "task.input_offset");
    check(given.output_offset, "an offset", "task.output_offset");
    if (given.input_offset == given.output_offset)
      mistake("offsets_equal", "task.output_offset", "both offsets are the same: the coupler would have no length");
  }
  void operator()(const MixedContacts& given) {
    check_point(given.input_pivot, "task.input_pivot");
    check_angle(given.coupler_angle, "the angle of the coupler", "task.coupler_angle_deg", found_);
    int points = 0;
    for (std::size_t j = 0; j < given.contacts.size(); ++j) check_contact(given, j, points);
    if (points != 4)
      found_.push_back({"contact_points",
                        "task.contacts",
                        fmt::format("the multiplicities of the contacts add up to {}; they must add up to 4", points),
                        {{"count", points}}});
  }
  void operator()(const Search& given) {
    check(given.stroke, "the stroke", "task.stroke");
    check(given.deviation, "the deviation", "task.deviation");
    if (std::isfinite(given.stroke) && !(given.stroke > 0))
      mistake("stroke_positive", "task.stroke", "the stroke is a positive length");
    if (!(given.deviation > least_share * given.stroke && given.deviation < most_share * given.stroke) &&
        std::isfinite(given.stroke) && given.stroke > 0)
      mistake("deviation_share", "task.deviation",
              "the deviation lies between a billionth and a tenth of the stroke; a wider strip is no straight line");
  }
  void operator()(const SymmetricLambdas& given) {
    check(given.stroke, "the stroke", "task.stroke");
    if (std::isfinite(given.stroke) && !(given.stroke > 0))
      mistake("stroke_positive", "task.stroke", "the stroke is a positive length");
    if (given.crank_range && !(*given.crank_range > 0 && *given.crank_range < longest_lambda_range))
      found_.push_back({"crank_range",
                        "task.crank_range_deg",
                        fmt::format("the crank turns between 0 and {:.2f} degrees over the stroke: at more its point "
                                    "turns back; null leaves the range open",
                                    degrees(longest_lambda_range)),
                        {{"most", degrees(longest_lambda_range)}}});
  }

 private:
  void mistake(const char* code, const char* place, const char* message) { found_.push_back({code, place, message}); }
  void check(double value, std::string_view what, const char* place) { check_number(value, what, place, found_); }
  void check_point(Point point, const std::string& place) {
    check_number(point.real(), "a coordinate", place + "[0]", found_);
    check_number(point.imag(), "a coordinate", place + "[1]", found_);
  }
  void check_contact(const MixedContacts& given, std::size_t j, int& points) {
    const PlacedContact& contact = given.contacts[j];
    const std::string place = fmt::format("task.contacts[{}]", j);
    check_number(contact.s, "a place of the line", place + ".s", found_);
    if (contact.multiplicity < 1 || contact.multiplicity > 4)
      found_.push_back({"contact_multiplicity", place + ".multiplicity",
                        "a contact has 1 (crosses), 2 (touches), 3 (inflects) or 4 points in common with the line"});
    if (contact.side != 1 && contact.side != -1)
      found_.push_back({"contact_side", place + ".side",
                        "the side of the dyad is 1 or −1: the crank's pin left or right of the way to the point"});
    points += contact.multiplicity;
    if (j == 0 || given.contacts[j - 1].s < contact.s) return;
    found_.push_back({"contact_order", place + ".s",
                      "contacts come by rising s; two at the same place are one of higher multiplicity"});
  }
  void check_pivots(Point input, Point output) {
    check_point(input, "task.ground_pivots.input");
    check_point(output, "task.ground_pivots.output");
    if (is_finite(input) && is_finite(output) &&
        std::abs(input - output) <= tolerance::no_difference * std::max(std::abs(input), std::abs(output)))
      mistake("ground_pivots_coincide", "task.ground_pivots.output",
              "both ground pivots are the same point; move one of them");
  }
  void check_pole_distance(double distance) {
    check(distance, "the distance of the pole", "task.pole_distance");
    if (distance == 0)
      mistake("pole_at_point", "task.pole_distance",
              "the point would be the pole, where it rests; give its distance, positive or negative");
  }
  void check_arm(double arm) {
    check(arm, "the length of the output link", "task.output_arm");
    if (arm == 0) mistake("arm_zero", "task.output_arm", "the output link has no length; give it one, of either sign");
  }
  // On the pole tangent D is infinite, on the pole normal the inflection pole is the only place.
  void check_point_ray(double ray) {
    check_angle(ray, "the angle of a ray", "task.point_ray_deg", found_);
    const double least = std::abs(std::remainder(ray, pi / 2));
    if (std::isfinite(ray) && !(least > tolerance::repeated_input_angle))
      mistake(
          "point_ray_special", "task.point_ray_deg",
          "the ray to the point is the pole tangent (0), which has no such point, or the pole normal (90): for that "
          "one choose the case \"five_point_inflection_pole\" or \"ball_point_on_side_link\"");
  }

  const DirectedLine& line_;
  std::vector<Error>& found_;
};

struct CaseSize {
  const DirectedLine& line;

  double operator()(const FourPointPivots& given) const { return std::abs(given.output - given.input); }
  double operator()(const BallPointOnSideLink& given) const { return std::abs(given.input_pivot - line.point); }
  double operator()(const IsoscelesTrapezoid& given) const { return 2 * given.half_frame; }
  double operator()(const PoleAtGivenPivot& given) const { return std::abs(given.output - given.input); }
  double operator()(const ParallelSideLinks& given) const { return std::abs(given.output_offset - given.input_offset); }
  double operator()(const MixedContacts& given) const {
    double farthest = 0;
    for (const PlacedContact& contact : given.contacts)
      farthest = std::max(farthest, std::abs(line.to_fixed(contact.s) - given.input_pivot));
    return farthest;
  }
  double operator()(const SymmetricLambdas& given) const { return given.stroke; }
  double operator()(const Search& given) const { return given.stroke; }
  template <class OfPole>
  double operator()(const OfPole& given) const {
    return std::abs(given.pole_distance);
  }
};

}  // namespace

std::string_view name(const StraightLineCase& of) { return std::visit(CaseName{}, of); }

int promised_contact(const StraightLineCase& of) {
  if (std::holds_alternative<SixPoint>(of)) return 6;
  if (std::holds_alternative<SymmetricLambdas>(of) || std::holds_alternative<Search>(of)) return 2;
  if (const auto* mixed = std::get_if<MixedContacts>(&of)) return mixed->contacts.front().multiplicity;
  const bool five = std::holds_alternative<FivePoint>(of) || std::holds_alternative<FivePointInflectionPole>(of) ||
                    std::holds_alternative<FivePointSideLinkOnFrame>(of) ||
                    std::holds_alternative<ParallelSideLinks>(of);
  return five ? 5 : 4;
}

double size_of(const StraightLineTask& task) { return std::visit(CaseSize{task.line}, task.given); }

std::vector<Error> mistakes_in(const StraightLineTask& task) {
  std::vector<Error> found;
  check_number(task.line.point.real(), "a coordinate", "task.line.point[0]", found);
  check_number(task.line.point.imag(), "a coordinate", "task.line.point[1]", found);
  check_angle(task.line.angle, "the direction of the line", "task.line.direction_deg", found);
  GivenCheck check(task.line, found);
  std::visit(check, task.given);
  return found;
}

}  // namespace linkwright
