#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <vector>

#include "drawing/palette.hpp"
#include "drawing/plot_scale.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/analyses/load_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr PixelBox forces_card{80, 130, 880, 400}, lower_card{80, 610, 880, 130};
constexpr PixelBox left_card{80, 610, 410, 130}, right_card{550, 610, 410, 130};
constexpr std::array<std::string_view, 6> case_colors = {palette::accent, palette::output, palette::link_2,
                                                         palette::link_5, palette::body,   palette::curve};

std::string_view color_of(std::size_t of_case) { return case_colors[of_case % case_colors.size()]; }

/// Of the body from position 1, degrees, positive in the sense in which it opens.
class Opening {
 public:
  explicit Opening(const LoadStudy& study) : sign_(study.curves.front().back().at.body_turn < 0 ? -1 : 1) {}
  [[nodiscard]] double of(const LoadPlace& at) const { return sign_ * degrees(at.body_turn); }
  [[nodiscard]] double of(const LoadStation& station) const { return of(station.at); }

 private:
  double sign_;
};

PlotScale scale_over(const PixelBox& box, const LoadStudy& study) {
  const auto& curve = study.curves.front();
  const Opening opening(study);
  return PlotScale(box, opening.of(curve.front()), opening.of(curve.back()));
}

bool can_be_drawn(const LoadStudy& study) {
  if (study.curves.empty() || study.curves.front().size() < 2) return false;
  const auto& curve = study.curves.front();
  return curve.front().at.body_turn != curve.back().at.body_turn;
}

using Value = std::function<std::optional<double>(const LoadStation& station)>;

void draw_line(SvgCanvas& svg, const PlotScale& scale, const Opening& opening, const std::vector<LoadStation>& curve,
               const Value& value, const std::string& style) {
  std::vector<Point> piece;
  const auto end_piece = [&] {
    if (piece.size() > 1) svg.polyline(piece, style + " stroke-linejoin=\"round\"");
    piece.clear();
  };
  for (const LoadStation& station : curve) {
    const auto at = value(station);
    if (at)
      piece.push_back(scale.at(opening.of(station), *at));
    else
      end_piece();
  }
  end_piece();
}

/// From the least to the largest of all cases.
void draw_band(SvgCanvas& svg, const PlotScale& scale, const LoadStudy& study, const Value& value,
               std::string_view color) {
  const Opening opening(study);
  std::vector<Point> upper, lower;
  for (std::size_t i = 0; i < study.curves.front().size(); ++i) {
    std::optional<double> low, high;
    for (const auto& curve : study.curves) {
      const auto here = value(curve[i]);
      if (!here) return;
      low = std::min(low.value_or(*here), *here);
      high = std::max(high.value_or(*here), *here);
    }
    const double turn = opening.of(study.curves.front()[i]);
    upper.push_back(scale.at(turn, *high));
    lower.push_back(scale.at(turn, *low));
  }
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  svg.polygon(upper, fill(color, 0.10));
}

void draw_positions(SvgCanvas& svg, const PlotScale& scale, const LoadStudy& study) {
  for (const LoadStation& station : study.curves.front()) {
    if (!station.position) continue;
    const double x = scale.x(Opening(study).of(station));
    svg.line({x, scale.box().top}, {x, scale.box().bottom()}, stroke(palette::line, 1, "3 3"));
    svg.text({x, scale.box().top + 14}, fmt::format("{}", *station.position + 1),
             {.size = 11, .color = palette::ink3, .anchor = "middle", .halo = palette::paper});
  }
}

void draw_rests(SvgCanvas& svg, const PlotScale& scale, const Opening& opening, const CaseReport& report,
                std::string_view color) {
  for (const Equilibrium& rest : report.equilibria)
    svg.circle(scale.at(opening.of(rest.at), 0), 4.5,
               fill(rest.stable ? color : palette::paper) + " " + stroke(color, 1.8));
}

/// One line a case, or two.
struct Plotted {
  std::string heading;
  Value line, broken;
};

/// Of the hand; without one, or in motion, of what drives.
Plotted efforts_of(const Loads& loads) {
  const bool is_driven = has_inertia(loads) && loads.drive != LoadDrive::hand;
  if (loads.handle && !is_driven)
    return {"Force of the hand: opening ——, closing – – –, N", &LoadStation::open, &LoadStation::close};
  if (loads.drive == LoadDrive::cylinder)
    return {"Force of the cylinder, opening without friction, N", &LoadStation::cylinder_force, {}};
  return {fmt::format("Torque of the driving crank, opening without friction, {}", loads.metres ? "N·m" : "N × unit"),
          &LoadStation::torque,
          {}};
}

/// Where there is a value.
void draw_plotted(SvgCanvas& svg, PlotScale scale, const LoadStudy& study, const Plotted& what, const PlotAxes& axes) {
  const Opening opening(study);
  scale.hold(0);
  for (const auto& curve : study.curves)
    for (const LoadStation& station : curve)
      for (const Value& value : {what.line, what.broken})
        if (const auto at = value ? value(station) : std::nullopt) scale.hold(*at);
  scale.widen();
  const PixelBox& box = scale.box();
  draw_plot_frame(svg, box, what.heading);
  draw_plot_axes(svg, scale, axes);
  draw_positions(svg, scale, study);
  svg.line({box.left, scale.y(0)}, {box.right(), scale.y(0)}, stroke(palette::curve, 1.2));
  if (study.curves.size() > 1) {
    draw_band(svg, scale, study, what.line, palette::accent);
    if (what.broken) draw_band(svg, scale, study, what.broken, palette::output);
  }
  for (std::size_t k = 0; k < study.curves.size(); ++k) {
    draw_line(svg, scale, opening, study.curves[k], what.line, stroke(color_of(k), 2));
    if (what.broken) draw_line(svg, scale, opening, study.curves[k], what.broken, stroke(color_of(k), 1.6, "6 4"));
    draw_rests(svg, scale, opening, study.report.cases[k], color_of(k));
  }
}

void draw_forces(SvgCanvas& svg, const LoadStudy& study) {
  draw_plotted(svg, scale_over(forces_card, study), study, efforts_of(study.loads),
               {"Body turned from position 1, degrees", palette::body, true, false});
}

std::optional<double> shaking_of(const LoadStation& station) {
  return station.motion ? std::optional(std::abs(station.motion->shaking)) : std::nullopt;
}
std::optional<double> largest_pin_of(const LoadStation& station) {
  if (!station.joints) return std::nullopt;
  double most = 0;
  for (const Point joint : *station.joints) most = std::max(most, std::abs(joint));
  return most;
}

/// What shakes the ground, and what the pins carry while it opens.
void draw_motion(SvgCanvas& svg, const LoadStudy& study, const PixelBox& box) {
  draw_plotted(svg, scale_over(box, study), study,
               {"Force on the ground ——, largest pin – – –, N", shaking_of, largest_pin_of},
               {"", palette::body, true, false});
}

void draw_legend(SvgCanvas& svg, const LoadStudy& study) {
  double x = forces_card.left;
  for (std::size_t k = 0; k < study.report.cases.size(); ++k) {
    const std::string& name = study.report.cases[k].name;
    const std::string text = fit_text(name, 12, 240);
    svg.line({x, 92}, {x + 22, 92}, stroke(color_of(k), 2.4));
    svg.text({x + 28, 96}, text, {.size = 12});
    x += 28 + text_width(text, 12) + 24;
  }
}

bool has_lengths(const LoadStudy& study) {
  const auto& springs = study.curves.front().front().springs;
  return std::any_of(springs.begin(), springs.end(), [](const auto& spring) { return spring.has_value(); });
}

void draw_springs(SvgCanvas& svg, const LoadStudy& study, const PixelBox& box) {
  const auto& curve = study.curves.front();
  PlotScale scale = scale_over(box, study);
  for (const LoadStation& station : curve)
    for (const auto& spring : station.springs)
      if (spring) scale.hold(spring->length);
  for (const Spring& spring : study.loads.springs)
    if (const auto* gas = std::get_if<GasSpring>(&spring.law)) {
      scale.hold(gas->extended_length);
      scale.hold(gas->extended_length - gas->stroke);
    }
  scale.widen();
  draw_plot_frame(svg, box,
                  fmt::format("Length of springs within their stroke{}",
                              study.length_unit.empty() ? "" : ", " + study.length_unit));
  for (std::size_t k = 0; k < study.loads.springs.size(); ++k)
    if (const auto* gas = std::get_if<GasSpring>(&study.loads.springs[k].law)) {
      const double top = scale.y(gas->extended_length), bottom = scale.y(gas->extended_length - gas->stroke);
      svg.rectangle({box.left, top}, box.width, bottom - top, fill(color_of(k), 0.07));
    }
  draw_plot_axes(svg, scale, {"", palette::body, true, false});
  for (std::size_t k = 0; k < study.loads.springs.size(); ++k) {
    std::vector<Point> line;
    for (const LoadStation& station : curve)
      if (station.springs[k]) line.push_back(scale.at(Opening(study).of(station), station.springs[k]->length));
    if (line.size() > 1) svg.polyline(line, stroke(color_of(k), 1.8));
  }
}

/// The largest of all cases.
std::string motion_text(const LoadStudy& study) {
  double most = 0;
  for (const CaseReport& of : study.report.cases)
    if (of.shaking) most = std::max(most, of.shaking->force);
  return fmt::format("{}shakes the ground with {} N", "   ·   ", significant_text(most, 3));
}

std::string figures_of(const LoadStudy& study) {
  std::string text;
  const auto add = [&](ReadOut read_out, std::string_view words) {
    const auto& worst = study.report.worst_of(read_out);
    if (!worst) return;
    text += fmt::format("{}{} {} N", text.empty() ? "" : "   ·   ", words, significant_text(worst->value, 3));
  };
  add(ReadOut::max_open_force, "opens with at most");
  add(ReadOut::max_close_force, "closes with at most");
  add(ReadOut::hold_open, "holds open against");
  add(ReadOut::max_pin_force, "largest pin");
  if (has_inertia(study.loads)) text += motion_text(study);
  return text;
}

}  // namespace

std::string draw_loads(const LoadStudy& study) {
  SvgCanvas svg = linkage_sheet::begin(study.title.empty() ? "Linkage" : study.title, "loads");
  svg.text({linkage_sheet::border, 66}, figures_of(study), {.size = 13, .color = palette::ink2});
  if (can_be_drawn(study)) {
    draw_legend(svg, study);
    draw_forces(svg, study);
    const bool moves = has_inertia(study.loads), springs = has_lengths(study);
    if (springs) draw_springs(svg, study, moves ? left_card : lower_card);
    if (moves) draw_motion(svg, study, springs ? right_card : lower_card);
  }
  return svg.file();
}

}  // namespace linkwright
