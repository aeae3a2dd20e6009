#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
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

constexpr PixelBox forces_card{80, 130, 880, 400}, springs_card{80, 610, 880, 130};
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

using Value = std::optional<double> LoadStation::*;

void draw_line(SvgCanvas& svg, const PlotScale& scale, const Opening& opening, const std::vector<LoadStation>& curve,
               Value value, const std::string& style) {
  std::vector<Point> piece;
  const auto end_piece = [&] {
    if (piece.size() > 1) svg.polyline(piece, style + " stroke-linejoin=\"round\"");
    piece.clear();
  };
  for (const LoadStation& station : curve) {
    const auto& at = station.*value;
    if (at)
      piece.push_back(scale.at(opening.of(station), *at));
    else
      end_piece();
  }
  end_piece();
}

/// From the least to the largest of all cases.
void draw_band(SvgCanvas& svg, const PlotScale& scale, const LoadStudy& study, Value value, std::string_view color) {
  const Opening opening(study);
  std::vector<Point> upper, lower;
  for (std::size_t i = 0; i < study.curves.front().size(); ++i) {
    std::optional<double> low, high;
    for (const auto& curve : study.curves) {
      const auto& here = curve[i].*value;
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

void draw_forces(SvgCanvas& svg, const LoadStudy& study) {
  const Opening opening(study);
  PlotScale scale = scale_over(forces_card, study);
  scale.hold(0);
  for (const auto& curve : study.curves)
    for (const LoadStation& station : curve)
      for (const Value value : {&LoadStation::open, &LoadStation::close})
        if (station.*value) scale.hold(*(station.*value));
  scale.widen();
  draw_plot_frame(svg, forces_card, "Force of the hand: opening ——, closing – – –, N");
  draw_plot_axes(svg, scale, {"Body turned from position 1, degrees", palette::body, true, false});
  draw_positions(svg, scale, study);
  svg.line({forces_card.left, scale.y(0)}, {forces_card.right(), scale.y(0)}, stroke(palette::curve, 1.2));
  if (study.curves.size() > 1) {
    draw_band(svg, scale, study, &LoadStation::open, palette::accent);
    draw_band(svg, scale, study, &LoadStation::close, palette::output);
  }
  for (std::size_t k = 0; k < study.curves.size(); ++k) {
    draw_line(svg, scale, opening, study.curves[k], &LoadStation::open, stroke(color_of(k), 2));
    draw_line(svg, scale, opening, study.curves[k], &LoadStation::close, stroke(color_of(k), 1.6, "6 4"));
    draw_rests(svg, scale, opening, study.report.cases[k], color_of(k));
  }
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

void draw_springs(SvgCanvas& svg, const LoadStudy& study) {
  const auto& curve = study.curves.front();
  PlotScale scale = scale_over(springs_card, study);
  bool is_any = false;
  for (const LoadStation& station : curve)
    for (const auto& spring : station.springs)
      if (spring) {
        scale.hold(spring->length);
        is_any = true;
      }
  if (!is_any) return;
  for (const Spring& spring : study.loads.springs)
    if (const auto* gas = std::get_if<GasSpring>(&spring.law)) {
      scale.hold(gas->extended_length);
      scale.hold(gas->extended_length - gas->stroke);
    }
  scale.widen();
  draw_plot_frame(svg, springs_card,
                  fmt::format("Length of springs within their stroke{}",
                              study.length_unit.empty() ? "" : ", " + study.length_unit));
  for (std::size_t k = 0; k < study.loads.springs.size(); ++k)
    if (const auto* gas = std::get_if<GasSpring>(&study.loads.springs[k].law)) {
      const double top = scale.y(gas->extended_length), bottom = scale.y(gas->extended_length - gas->stroke);
      svg.rectangle({springs_card.left, top}, springs_card.width, bottom - top, fill(color_of(k), 0.07));
    }
  draw_plot_axes(svg, scale, {"", palette::body, true, false});
  for (std::size_t k = 0; k < study.loads.springs.size(); ++k) {
    std::vector<Point> line;
    for (const LoadStation& station : curve)
      if (station.springs[k]) line.push_back(scale.at(Opening(study).of(station), station.springs[k]->length));
    if (line.size() > 1) svg.polyline(line, stroke(color_of(k), 1.8));
  }
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
  return text;
}

}  // namespace

std::string draw_loads(const LoadStudy& study) {
  SvgCanvas svg = linkage_sheet::begin(study.title.empty() ? "Linkage" : study.title, "loads");
  svg.text({linkage_sheet::border, 66}, figures_of(study), {.size = 13, .color = palette::ink2});
  if (can_be_drawn(study)) {
    draw_legend(svg, study);
    draw_forces(svg, study);
    draw_springs(svg, study);
  }
  return svg.file();
}

}  // namespace linkwright
