#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/mechanism/position.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

/// Numbers of one instant, lengths with the same number of decimals.
class InstantReport {
 public:
  InstantReport(const InstantAnalysis& analysis, double size, std::string_view pace)
      : analysis_(analysis), decimals_(length_decimals(size)), pace_(pace) {}

  [[nodiscard]] std::string text() const {
    if (!analysis_.instant) return wrapped("There is no instant: " + analysis_.degenerate.message + ".");
    const std::string kind = std::visit([this](const auto& instant) { return of(instant); }, *analysis_.instant);
    return notes() + kind + rates() + path();
  }

 private:
  [[nodiscard]] std::string length(double value) const { return rounded_text(value, decimals_); }
  [[nodiscard]] std::string point(Point p) const { return fmt::format("({}, {})", length(p.real()), length(p.imag())); }
  [[nodiscard]] static std::string number(double value, double size) { return significant_text(value, 6, size); }
  [[nodiscard]] static std::string signed_number(double value, double size) {
    return (value < 0 ? "− " : "+ ") + number(std::abs(value), size);
  }
  [[nodiscard]] std::string shape(const Circle& circle) const {
    return fmt::format("centre {}, radius {}", point(circle.center), length(circle.radius));
  }
  [[nodiscard]] std::string shape(const StraightLine& line) const {
    return fmt::format("the line through {} at {}", point(line.point), angle_text(std::arg(line.direction)));
  }
  [[nodiscard]] static std::string row(std::string_view name, std::string_view value) {
    return wrapped(fmt::format("  {:<18} {}", name, value), 21);
  }

  [[nodiscard]] std::string notes() const {
    std::string text;
    for (const Notice& note : analysis_.notes) text += wrapped("Note: " + note.message + ".", 2);
    return text;
  }

  [[nodiscard]] std::string of(const TurningInstant& instant) const {
    std::string text =
        row("pole", point(instant.pole)) + row("pole tangent", angle_text(std::arg(instant.tangent))) +
        row("inflection circle",
            fmt::format("diameter {}, {}", length(instant.diameter), shape(instant.inflection_circle()))) +
        row("inflection pole", point(instant.inflection_pole())) + row("return circle", shape(instant.return_circle()));
    const double per_length = 1 / instant.diameter;
    text += row("cubic", fmt::format("(x² + y²)({} x {} y) = x y, from P along tangent and normal",
                                     number(instant.m(), per_length), signed_number(instant.n(), per_length)));
    text += row("invariants", fmt::format("a3 {}, b3 {}{}", number(instant.a3, instant.diameter),
                                          number(instant.b3, instant.diameter), fourth(instant)));
    text += row("Ball's point", analysis_.ball_point ? point(*analysis_.ball_point)
                                                     : "none: the whole inflection circle is stationary");
    return text + burmester(instant);
  }
  [[nodiscard]] static std::string fourth(const TurningInstant& instant) {
    return instant.fourth ? fmt::format(", a4 {}, b4 {}", number(instant.fourth->a4, instant.diameter),
                                        number(instant.fourth->b4, instant.diameter))
                          : "";
  }
  [[nodiscard]] std::string burmester(const TurningInstant& instant) const {
    if (!instant.fourth) return row("Burmester points", "need one more derivative");
    std::string text;
    for (const CurvaturePair& pair : analysis_.burmester_points)
      if (const auto moving = finite_point(pair.moving)) text += (text.empty() ? "" : ", ") + point(*moving);
    return row("Burmester points", text.empty() ? "none" : text);
  }

  [[nodiscard]] std::string of(const PivotingInstant& instant) const {
    return row("pole", point(instant.pole)) +
           row("", "the body turns about it as about a pivot: all paths are circles about the pole");
  }

  [[nodiscard]] std::string of(const TranslatingInstant& instant) const {
    std::string text =
        row("pole", fmt::format("at infinity; all points move at {}", angle_text(std::arg(instant.velocity))));
    if (const auto line = instant.inflection_line())
      text += row("inflection circle", shape(*line)) +
              row("cubic", fmt::format("x y = {} about {}, x along the motion",
                                       number(instant.circling_points->product, 1 / std::abs(instant.slope)),
                                       point(instant.circling_points->center)));
    return text;
  }

  [[nodiscard]] std::string rates() const {
    if (!analysis_.rates) return "";
    std::string text =
        row("body turns", fmt::format("{} times as fast as {}, acceleration {}", number(analysis_.rates->velocity, 1),
                                      pace_, number(analysis_.rates->acceleration, 1)));
    if (analysis_.bresse_circle)
      text += row("Bresse circle",
                  std::visit([this](const auto& its_shape) { return shape(its_shape); }, *analysis_.bresse_circle));
    return text + (analysis_.acceleration_pole ? row("acceleration pole", point(*analysis_.acceleration_pole)) : "");
  }

  [[nodiscard]] std::string path() const {
    if (!analysis_.point) return "";
    const PathNow& path = *analysis_.point;
    const std::string at = fmt::format("point {}", point(path.point));
    if (!path.center) return row("", at + " is the pole and rests: its path has a cusp or turns there");
    const auto center = finite_point(*path.center);
    return row(
        "", center ? fmt::format("{}: centre of curvature {}, radius {}", at, point(*center),
                                 length(std::abs(*center - path.point)))
                   : fmt::format("{}: runs straight, {} points in common with its tangent", at, path.contact_points));
  }

  const InstantAnalysis& analysis_;
  int decimals_;
  std::string_view pace_;
};

}  // namespace

std::string instant_words(const LinkageAnalysis& analysis) {
  const LinkageInstant& instant = *analysis.instant;
  return fmt::format("Instant of the coupler with the input at {} from the ground link:\n",
                     angle_text(configuration_of(instant.four_bar).input_angle)) +
         InstantReport(instant.analysis, analysis.lengths.longest(), "the input").text();
}

std::string instant_words(const PrescribedInstant& instant) {
  const std::string title = instant.title.empty() ? "Prescribed motion" : printable(instant.title);
  const auto* turning = instant.analysis.instant ? std::get_if<TurningInstant>(&*instant.analysis.instant) : nullptr;
  const double size = turning ? turning->diameter : std::abs(instant.pose.derivatives.front().origin);
  return wrapped(title + ", at the instant of its pose:") +
         InstantReport(instant.analysis, size, "its parameter").text();
}

}  // namespace linkwright::cli
