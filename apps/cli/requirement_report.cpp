#include "requirement_report.hpp"

#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright::cli {
namespace {

constexpr int limit_digits = 6;     // of a limit in words
constexpr double touching = 0.005;  // of the limit, or of a box's side

std::string limit_words(double length, std::string_view unit) {
  const std::string number = significant_text(length, limit_digits);
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string angle_words(double angle) { return significant_text(degrees(angle), limit_digits) + "°"; }

std::string type_list(const std::vector<LinkageType>& types) {
  std::string text;
  for (std::size_t i = 0; i < types.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == types.size() ? " or " : ", ") + std::string(name(types[i]));
  }
  return text;
}

/// "the input's fixed pivot at the border x = 70 of its box", or nothing.
void add_border(std::vector<std::string>& touched, const std::optional<Box>& box, Point pivot, std::string_view which,
                std::string_view of = "its box") {
  if (!box) return;
  const auto check = [&](double value, double low, double high, char axis) {
    const double room = touching * (high - low);
    if (value - low > room && high - value > room) return;
    const double border = value - low <= room ? low : high;
    touched.push_back(
        fmt::format("{} at the border {} = {} of {}", which, axis, significant_text(border, limit_digits), of));
  };
  check(pivot.real(), box->x_low, box->x_high, 'x');
  check(pivot.imag(), box->y_low, box->y_high, 'y');
}

std::vector<std::string> limit_of_transmission(const Requirements& requirements, double gamma) {
  const double least_gamma = requirements.min_transmission_angle;
  if (least_gamma > 0 && gamma <= (1 + touching) * least_gamma)
    return {"transmission angle at least " + angle_words(least_gamma)};
  if (least_gamma == 0 && gamma < radians(1)) return {"a dead point, its transmission angle all but 0"};
  return {};
}

/// Of those that ask for no place.
std::vector<std::string> limits_of_size(const Requirements& requirements, double gamma, double ratio, double longest,
                                        std::string_view unit) {
  std::vector<std::string> touched = limit_of_transmission(requirements, gamma);
  if (ratio >= (1 - touching) * requirements.max_link_ratio) {
    touched.push_back("link ratio at most " + significant_text(requirements.max_link_ratio, limit_digits));
  }
  if (requirements.max_length && longest >= (1 - touching) * *requirements.max_length) {
    touched.push_back("longest link at most " + limit_words(*requirements.max_length, unit));
  }
  if (requirements.min_length && longest <= (1 + touching) * *requirements.min_length * ratio) {
    touched.push_back("shortest link at least " + limit_words(*requirements.min_length, unit));
  }
  return touched;
}

/// "the input's fixed axis at the border of its cone, 30° of (0, 0, 1)", or nothing.
void add_cone_border(std::vector<std::string>& touched, const std::optional<Cone>& cone, Vector3 axis,
                     std::string_view which) {
  if (cone && cone->angle_to(axis) >= (1 - touching) * cone->half_angle)
    touched.push_back(fmt::format("{} at the border of its cone, {}", which, cone_words(*cone)));
}

}  // namespace

std::string box_words(const Box& box) {
  return fmt::format("x {}…{}, y {}…{}", significant_text(box.x_low, limit_digits),
                     significant_text(box.x_high, limit_digits), significant_text(box.y_low, limit_digits),
                     significant_text(box.y_high, limit_digits));
}

std::string cone_words(const Cone& cone) {
  return fmt::format("{} of ({}, {}, {})", angle_words(cone.half_angle), significant_text(cone.axis.x, limit_digits),
                     significant_text(cone.axis.y, limit_digits), significant_text(cone.axis.z, limit_digits));
}

namespace {

std::string words_of_limit(RequirementKind kind, const Requirements& wanted, std::string_view unit) {
  const double most = wanted.max_length.value_or(Requirements::unlimited), least = wanted.min_length.value_or(0);
  const double angle = wanted.min_link_angle.value_or(0);
  switch (kind) {
    case RequirementKind::min_transmission_angle:
      if (!(wanted.min_transmission_angle > 0)) return "";
      return "transmission angle over the task at least " + angle_words(wanted.min_transmission_angle);
    case RequirementKind::max_link_ratio:
      if (!std::isfinite(wanted.max_link_ratio)) return "";
      return "link ratio at most " + significant_text(wanted.max_link_ratio, limit_digits);
    case RequirementKind::max_length:
      return std::isfinite(most) ? "longest link at most " + limit_words(most, unit) : "";
    case RequirementKind::min_length:
      return least > 0 ? "shortest link at least " + limit_words(least, unit) : "";
    case RequirementKind::min_link_angle:
      return angle > 0 ? "link angles at least " + angle_words(angle) : "";
    case RequirementKind::max_link_angle:
      return wanted.max_link_angle ? "link angles at most " + angle_words(*wanted.max_link_angle) : "";
    case RequirementKind::min_stroke:
      return wanted.min_stroke > 0 ? "usable length at least " + limit_words(wanted.min_stroke, unit) : "";
    case RequirementKind::max_deviation:
      if (!std::isfinite(wanted.max_deviation)) return "";
      return "deviation at most " + limit_words(wanted.max_deviation, unit);
    case RequirementKind::max_tolerance_error:
      if (!std::isfinite(wanted.max_tolerance_error)) return "";
      return "error by tolerances at most " + significant_text(wanted.max_tolerance_error, limit_digits);
    case RequirementKind::min_yield:
      return wanted.min_yield > 0
                 ? fmt::format("yield at least {} %", significant_text(100 * wanted.min_yield, limit_digits))
                 : "";
    default:
      return "";
  }
}

std::string words_of_place(RequirementKind kind, const Requirements& wanted, int position) {
  const auto words = [](std::string_view what, std::string_view where) { return fmt::format("{} {}", what, where); };
  const std::string lying = fmt::format("(position {})", position);
  switch (kind) {
    case RequirementKind::ground_pivots_within:
      return wanted.ground_pivots_within ? words("fixed pivots in", box_words(*wanted.ground_pivots_within)) : "";
    case RequirementKind::moving_pivots_within:
      if (!wanted.moving_pivots_within) return "";
      return words("moving pivots " + lying + " in", box_words(*wanted.moving_pivots_within));
    case RequirementKind::fixed_axes_within:
      return wanted.fixed_axes_within ? words("fixed axes within", cone_words(*wanted.fixed_axes_within)) : "";
    case RequirementKind::moving_axes_within:
      if (!wanted.moving_axes_within) return "";
      return words("moving axes " + lying + " within", cone_words(*wanted.moving_axes_within));
    default:
      return "";
  }
}

}  // namespace

std::string requirement_words(const Requirements& requirements, const LinkageClass& asked, std::string_view unit,
                              int position) {
  std::string text;
  if (place_among(asked.requirements, RequirementKind::no_defects) < asked.requirements.size())
    text = requirements.no_defects ? "no defects" : "defects allowed";
  for (const RequirementKind kind : asked.requirements) {
    std::string words = kind == RequirementKind::types && !requirements.types.empty()
                            ? "type " + type_list(requirements.types)
                            : words_of_limit(kind, requirements, unit);
    words += words_of_place(kind, requirements, position);
    if (!words.empty()) text += (text.empty() ? "" : ", ") + words;
  }
  return text.empty() ? "none" : text;
}

std::vector<std::string> limits_touched(const Requirements& requirements, const FourBarSolution& found,
                                        std::string_view unit) {
  const double gamma = found.report.min_transmission_angle;
  const double longest = found.lengths.longest();
  std::vector<std::string> touched =
      limits_of_size(requirements, gamma, longest / found.lengths.shortest(), longest, unit);
  add_border(touched, requirements.ground_pivots_within, found.four_bar.input_center, "the input's fixed pivot");
  add_border(touched, requirements.ground_pivots_within, found.four_bar.output_center, "the output's fixed pivot");
  add_border(touched, requirements.moving_pivots_within, found.four_bar.input_circle, "the input's moving pivot");
  add_border(touched, requirements.moving_pivots_within, found.four_bar.output_circle, "the output's moving pivot");
  return touched;
}

std::vector<std::string> limits_touched(const Requirements& requirements, const SixBarSolution& found,
                                        const std::optional<Box>& search, std::string_view unit) {
  const SixBarShape& shape = found.rating.shape;
  std::vector<std::string> touched =
      limits_of_size(requirements, found.rating.min_transmission_angle(), shape.link_ratio, shape.longest, unit);
  const auto& joints = found.member.six_bar.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string which = fmt::format("hinge {}", joint_name(i));
    add_border(touched, is_on_ground(joints[i]) ? requirements.ground_pivots_within : requirements.moving_pivots_within,
               joints[i].point, which);
    add_border(touched, search, joints[i].point, which, "the search's box");
  }
  return touched;
}

std::vector<std::string> limits_touched(const Requirements& requirements, const SphericalSolution& found) {
  std::vector<std::string> touched = limit_of_transmission(requirements, found.report.min_transmission_angle);
  const double least = requirements.min_link_angle.value_or(0);
  if (least > 0 && found.angles.shortest() <= (1 + touching) * least)
    touched.push_back("link angles at least " + angle_words(least));
  if (requirements.max_link_angle && found.angles.longest() >= (1 - touching) * *requirements.max_link_angle)
    touched.push_back("link angles at most " + angle_words(*requirements.max_link_angle));
  add_cone_border(touched, requirements.fixed_axes_within, found.input.fixed_axis, "the input's fixed axis");
  add_cone_border(touched, requirements.fixed_axes_within, found.output.fixed_axis, "the output's fixed axis");
  add_cone_border(touched, requirements.moving_axes_within, found.input.moving_axis, "the input's moving axis");
  add_cone_border(touched, requirements.moving_axes_within, found.output.moving_axis, "the output's moving axis");
  return touched;
}

std::string held_back_words(const std::vector<std::string>& limits) {
  if (limits.empty()) return "is at no limit of the requirements.";
  return fmt::format("is at a limit of the requirements: {}.", fmt::join(limits, "; "));
}

std::string relaxation_words(const Relaxation& relaxation, std::string_view unit) {
  const std::string leaves = grouped_text(relaxation.leaves);
  if (relaxation.box)
    return fmt::format("{} of {} would leave {}.", key(relaxation.requirement), box_words(*relaxation.box), leaves);
  if (!relaxation.value) return fmt::format("Without {} there would be {}.", key(relaxation.requirement), leaves);
  switch (relaxation.requirement) {
    case RequirementKind::min_transmission_angle:
      return fmt::format("A transmission angle of at least {} would leave {}.", angle_words(*relaxation.value), leaves);
    case RequirementKind::max_link_ratio:
      return fmt::format("A link ratio of at most {} would leave {}.",
                         significant_text(*relaxation.value, limit_digits), leaves);
    case RequirementKind::max_length:
      return fmt::format("A longest link of at most {} would leave {}.", limit_words(*relaxation.value, unit), leaves);
    case RequirementKind::min_length:
      return fmt::format("A shortest link of at least {} would leave {}.", limit_words(*relaxation.value, unit),
                         leaves);
    case RequirementKind::min_link_angle:
      return fmt::format("Link angles of at least {} would leave {}.", angle_words(*relaxation.value), leaves);
    case RequirementKind::max_link_angle:
      return fmt::format("Link angles of at most {} would leave {}.", angle_words(*relaxation.value), leaves);
    case RequirementKind::min_stroke:
      return fmt::format("A usable length of at least {} would leave {}.", limit_words(*relaxation.value, unit),
                         leaves);
    case RequirementKind::max_deviation:
      return fmt::format("A deviation of at most {} would leave {}.", limit_words(*relaxation.value, unit), leaves);
    case RequirementKind::fixed_axes_within:
    case RequirementKind::moving_axes_within:
      return fmt::format("{} of {} would leave {}.", key(relaxation.requirement), angle_words(*relaxation.value),
                         leaves);
    default:
      break;
  }
  return fmt::format("{} = {} would leave {}.", key(relaxation.requirement),
                     significant_text(*relaxation.value, limit_digits), leaves);
}

}  // namespace linkwright::cli
