#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"

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

bool is_least(const Criterion& asked) { return asked.rule == Criterion::Rule::at_least; }

/// Of a length unit that is not known in newtons times it.
std::string torque_unit(std::string_view of_length) {
  if (length_unit(of_length)) return "N·m";
  return of_length.empty() ? "N times the unit of length" : fmt::format("N·{}", of_length);
}

std::string value_words(const Criterion& asked, double value, std::string_view unit) {
  switch (asked.unit) {
    case Criterion::Unit::angle:
      return angle_words(value);
    case Criterion::Unit::length:
      return limit_words(value, unit);
    case Criterion::Unit::force:
      return limit_words(value, "N");
    case Criterion::Unit::torque:
      return limit_words(value, torque_unit(unit));
    case Criterion::Unit::share:
      return significant_text(100 * value, limit_digits) + " %";
    default:
      return significant_text(value, limit_digits);
  }
}

std::string words_of_place(const Criterion& asked, const PivotWindow& within, int position) {
  const auto* box = std::get_if<Box>(&within);
  return fmt::format("{}{} {}", asked.name,
                     asked.rule == Criterion::Rule::moving_inside ? fmt::format(" (position {})", position) : "",
                     box ? "in " + box_words(*box) : "within " + cone_words(std::get<Cone>(within)));
}

/// Nothing where it is not asked for.
std::string words_of(const Criterion& asked, const Requirements& wanted, std::string_view unit, int position) {
  if (asked.rule == Criterion::Rule::one_of_types && !wanted.types.empty())
    return fmt::format("{} {}", asked.name, type_list(wanted.types));
  if (const auto within = asked.window(wanted)) return words_of_place(asked, *within, position);
  if (asked.rule == Criterion::Rule::turning_fully) return wanted.full_turn ? std::string(asked.name) : "";
  if (!asked.has_limit(wanted)) return "";
  return fmt::format("{} at {} {}", asked.name, is_least(asked) ? "least" : "most",
                     value_words(asked, asked.limit(wanted), unit));
}

}  // namespace

std::string requirement_words(const Requirements& requirements, const LinkageClass& asked, std::string_view unit,
                              int position) {
  std::string text;
  if (place_among(asked.requirements, RequirementKind::no_defects) < asked.requirements.size())
    text = requirements.no_defects ? "no defects" : "defects allowed";
  for (const RequirementKind kind : asked.requirements) {
    const std::string words = words_of(criterion(kind), requirements, unit, position);
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
  add_border(touched, requirements.ground_pivots_within, found.four_bar.input_fixed, "the input's fixed pivot");
  add_border(touched, requirements.ground_pivots_within, found.four_bar.output_fixed, "the output's fixed pivot");
  add_border(touched, requirements.moving_pivots_within, found.four_bar.input_moving, "the input's moving pivot");
  add_border(touched, requirements.moving_pivots_within, found.four_bar.output_moving, "the output's moving pivot");
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
  const Criterion& asked = criterion(relaxation.requirement);
  const std::string leaves = grouped_text(relaxation.leaves);
  if (relaxation.box) return fmt::format("{} of {} would leave {}.", asked.key, box_words(*relaxation.box), leaves);
  if (!relaxation.value) return fmt::format("Without {} there would be {}.", asked.key, leaves);
  if (!asked.is_number())
    return fmt::format("{} of {} would leave {}.", asked.key, angle_words(*relaxation.value), leaves);
  if (asked.as_advice.empty())
    return fmt::format("{} = {} would leave {}.", asked.key, significant_text(*relaxation.value, limit_digits), leaves);
  return fmt::format("{} of at {} {} would leave {}.", asked.as_advice, is_least(asked) ? "least" : "most",
                     value_words(asked, *relaxation.value, unit), leaves);
}

}  // namespace linkwright::cli
