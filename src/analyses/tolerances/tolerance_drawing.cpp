#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <vector>

#include "drawing/axis_ticks.hpp"
#include "drawing/palette.hpp"
#include "drawing/plane_window.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "robust/sampled_positions.hpp"

namespace linkwright {
namespace {

constexpr int figure_digits = 3, histogram_bins = 60;
constexpr std::size_t histogram_samples = 20'000, scattered_samples = 300, drawn_paths = 60, most_histograms = 5;
constexpr PixelBox histograms_card{70, 118, 500, 620}, places_card{640, 118, 320, 260}, shares_card{640, 440, 320, 320};

// Of the positions in a row.
constexpr std::array<std::string_view, most_histograms> position_colors = {
    palette::input, palette::output, palette::link_2, palette::link_5, palette::body};

std::string unit_of(const ToleranceStudy& study) { return study.report.of_angle ? "°" : study.length_unit; }

double readable_in(const ToleranceStudy& study, double error) { return study.report.of_angle ? degrees(error) : error; }

std::string error_words_in(const ToleranceStudy& study, double error) {
  const std::string number = significant_text(readable_in(study, error), figure_digits), unit = unit_of(study);
  return study.report.of_angle || unit.empty() ? number + unit : number + " " + unit;
}

/// The positions of which there is a histogram: of a long list the ends and the middle.
std::vector<std::size_t> shown_positions(const LinkageOutput& output) {
  const std::size_t count = positions_of(output);
  if (is_line(output)) return {0, count / 2, count - 1};
  std::vector<std::size_t> shown;
  for (std::size_t j = 0; j < std::min(count, most_histograms); ++j) shown.push_back(j);
  return shown;
}

std::string name_of_position(const LinkageOutput& output, std::size_t position) {
  if (!is_line(output)) return fmt::format("position {}", position + 1);
  if (position == 0) return "where the stroke begins";
  return position + 1 == positions_of(output) ? "where it ends" : "in its middle";
}

struct Span {
  double from = 0, to = 0;
};

Span span_of(const ErrorSamples& samples, const std::vector<std::size_t>& shown, bool both_ways) {
  double most = 0;
  for (const std::size_t j : shown)
    for (const double error : samples.errors[j]) most = std::max(most, std::abs(error));
  if (!(most > 0)) most = 1;
  return {both_ways ? -most : 0, most};
}

std::vector<double> histogram(const std::vector<double>& errors, Span span) {
  std::vector<double> counts(histogram_bins);
  for (const double error : errors) {
    const double place = (error - span.from) / (span.to - span.from) * histogram_bins;
    ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, histogram_bins - 1.0))];
  }
  return counts;
}

// A limit of the kind that the errors are of.
std::optional<double> limit_on_errors(const ToleranceStudy& study) {
  const auto& limit = study.tolerances.limit;
  const auto* planar = std::get_if<PlanarOutput>(&study.output);
  if (!limit || (planar && planar->kind == PlanarOutput::Kind::pose) ||
      std::holds_alternative<SixBarOutput>(study.output))
    return std::nullopt;
  return limit->value;
}

void draw_limit(SvgCanvas& svg, const PixelBox& box, Span span, double limit) {
  for (const double side : {-limit, limit}) {
    if (side < span.from || side > span.to) continue;
    const double x = box.left + box.width * (side - span.from) / (span.to - span.from);
    svg.line({x, box.top}, {x, box.bottom()}, stroke(palette::bad, 1.4, "4 3"));
  }
}

void draw_error_axis(SvgCanvas& svg, const PixelBox& box, Span span, const ToleranceStudy& study) {
  const double from = readable_in(study, span.from), to = readable_in(study, span.to);
  for (const double place : even_ticks(from, to, box.width, 60, false)) {
    const double x = box.left + box.width * (place - from) / (to - from);
    svg.line({x, box.bottom()}, {x, box.bottom() + 4}, stroke(palette::ink2, 1));
    svg.text({x, box.bottom() + 17}, significant_text(place, figure_digits),
             {.size = 11, .color = palette::ink2, .anchor = "middle"});
  }
}

void draw_histogram(SvgCanvas& svg, const PixelBox& box, const std::vector<double>& counts, std::string_view color) {
  const double most = *std::max_element(counts.begin(), counts.end()), width = box.width / histogram_bins;
  svg.rectangle(box.corner(), box.width, box.height, fill(palette::paper) + " " + stroke(palette::line, 1));
  for (int bin = 0; bin < histogram_bins && most > 0; ++bin) {
    const double height = (box.height - 4) * counts[static_cast<std::size_t>(bin)] / most;
    svg.rectangle({box.left + bin * width, box.bottom() - height}, width * 0.9, height, fill(color, 0.8));
  }
}

void draw_histograms(SvgCanvas& svg, const ToleranceStudy& study) {
  const ErrorSamples samples = error_samples(
      study.output, study.tolerances, std::min(histogram_samples, static_cast<std::size_t>(study.tolerances.samples)));
  const std::vector<std::size_t> shown = shown_positions(study.output);
  const Span span = span_of(samples, shown, is_line(study.output));
  svg.text({histograms_card.left, histograms_card.top - 26},
           fmt::format("Errors of the samples{}", unit_of(study).empty() ? "" : ", " + unit_of(study)),
           {.size = 14, .weight = 650});
  const double step = histograms_card.height / static_cast<double>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PixelBox box{histograms_card.left, histograms_card.top + static_cast<double>(i) * step, histograms_card.width,
                       step - 44};
    draw_histogram(svg, box, histogram(samples.errors[shown[i]], span), position_colors[i]);
    svg.text({box.left, box.top - 5},
             fmt::format("{}: σ {}", name_of_position(study.output, shown[i]),
                         error_words_in(study, study.report.sampled.deviations[shown[i]])),
             {.size = 12, .weight = 650});
    draw_error_axis(svg, box, span, study);
    if (const auto limit = limit_on_errors(study)) draw_limit(svg, box, span, *limit);
  }
}

void draw_scatter(SvgCanvas& svg, const std::vector<std::vector<Point>>& offsets, const std::string& unit) {
  double most = 0;
  std::vector<Point> corners;
  for (const auto& of_position : offsets)
    for (const Point p : of_position) most = std::max({most, std::abs(p.real()), std::abs(p.imag())});
  if (!(most > 0)) most = 1;
  for (const double x : {-most, most})
    for (const double y : {-most, most}) corners.emplace_back(x, y);
  svg.text({places_card.left, places_card.top - 26}, "Origin of the body about where it is to be",
           {.size = 14, .weight = 650});
  svg.rectangle(places_card.corner(), places_card.width, places_card.height,
                fill(palette::paper) + " " + stroke(palette::line, 1));
  const PlaneWindow window(places_card, corners, 12);
  const Point middle = window.to_px({0, 0});
  svg.line({places_card.left, middle.imag()}, {places_card.right(), middle.imag()}, stroke(palette::line, 1));
  svg.line({middle.real(), places_card.top}, {middle.real(), places_card.bottom()}, stroke(palette::line, 1));
  for (std::size_t j = 0; j < offsets.size(); ++j)
    for (const Point p : offsets[j]) svg.circle(window.to_px(p), 1.5, fill(position_colors[j % most_histograms], 0.55));
  const double length = round_length(most);
  const Point from{places_card.left + 12, places_card.bottom() - 12};
  svg.line(from, from + Point{length * window.scale(), 0}, stroke(palette::ink, 2));
  svg.text(from + Point{0, -6},
           fmt::format("{}{}", significant_text(length, figure_digits), unit.empty() ? "" : " " + unit),
           {.size = 11, .halo = palette::paper});
}

std::vector<std::vector<Point>> origin_offsets(const PlanarOutput& output, const Tolerances& tolerances) {
  std::vector<std::vector<Point>> offsets(output.positions.size());
  for (const auto& sample : sampled_positions(output, tolerances, scattered_samples))
    for (std::size_t j = 0; j < offsets.size(); ++j) offsets[j].push_back(sample[j].point - output.positions[j].point);
  return offsets;
}
std::vector<std::vector<Point>> origin_offsets(const SixBarOutput& output, const Tolerances& tolerances) {
  std::vector<std::vector<Point>> offsets(output.positions.size());
  for (const auto& sample : sampled_positions(output, tolerances, scattered_samples))
    for (std::size_t j = 0; j < offsets.size(); ++j)
      offsets[j].push_back(sample[j].guided.origin -
                           guided_pose(output.six_bar, output.positions[j], output.reference).origin);
  return offsets;
}

void draw_paths(SvgCanvas& svg, const PlanarOutput& line, const ToleranceStudy& study) {
  std::vector<std::vector<Point>> paths;  // places along the line, distances from it
  const auto path_of = [&](const std::vector<TracingFourBar>& made) {
    std::vector<Point> path;
    for (const TracingFourBar& there : made) path.push_back(line.line.to_line(there.point));
    return path;
  };
  for (const auto& sample : sampled_positions(line, study.tolerances, drawn_paths)) paths.push_back(path_of(sample));
  const std::vector<Point> nominal = path_of(line.positions);
  double most = 0;
  for (const auto& path : paths)
    for (const Point p : path) most = std::max(most, std::abs(p.imag()));
  if (!(most > 0)) most = 1;
  svg.text({places_card.left, places_card.top - 26},
           fmt::format("Paths of {} linkages made, ± {} across", paths.size(), error_words_in(study, most)),
           {.size = 14, .weight = 650});
  svg.rectangle(places_card.corner(), places_card.width, places_card.height,
                fill(palette::paper) + " " + stroke(palette::line, 1));
  const double from = nominal.front().real(), to = nominal.back().real();
  const auto draw = [&](const std::vector<Point>& path, const std::string& style) {
    std::vector<Point> px;
    for (const Point p : path)
      px.emplace_back(places_card.left + places_card.width * std::clamp((p.real() - from) / (to - from), 0.0, 1.0),
                      places_card.top + places_card.height * (0.5 - 0.48 * p.imag() / most));
    svg.polyline(px, style);
  };
  for (const auto& path : paths) draw(path, stroke(palette::input, 0.8) + " stroke-opacity=\"0.4\" fill=\"none\"");
  draw(nominal, stroke(palette::ink, 1.8) + " fill=\"none\"");
}

void draw_places(SvgCanvas& svg, const ToleranceStudy& study) {
  if (const auto* six_bar = std::get_if<SixBarOutput>(&study.output))
    return draw_scatter(svg, origin_offsets(*six_bar, study.tolerances), study.length_unit);
  const auto* planar = std::get_if<PlanarOutput>(&study.output);
  if (planar == nullptr || planar->kind == PlanarOutput::Kind::angle) return;
  if (planar->kind == PlanarOutput::Kind::line) return draw_paths(svg, *planar, study);
  draw_scatter(svg, origin_offsets(*planar, study.tolerances), study.length_unit);
}

std::string tolerance_text(const ParameterShare& share, const std::string& unit) {
  if (share.is_angle) return fmt::format("± {}°", significant_text(degrees(share.tolerance), figure_digits));
  return fmt::format("± {}{}", significant_text(share.tolerance, figure_digits), unit.empty() ? "" : " " + unit);
}

void draw_shares(SvgCanvas& svg, const ToleranceStudy& study) {
  constexpr std::size_t most_bars = 11;
  constexpr double step = 28;
  const double top = std::holds_alternative<SphericalOutput>(study.output) ? places_card.top : shares_card.top;
  svg.text({shares_card.left, top - 26}, "Shares of the variance of the error", {.size = 14, .weight = 650});
  const auto& shares = study.report.shares;
  for (std::size_t i = 0; i < std::min(shares.size(), most_bars); ++i) {
    const double y = top + static_cast<double>(i) * step;
    svg.text({shares_card.left, y},
             fmt::format("{}  {}", dimension_label(shares[i].parameter), tolerance_text(shares[i], study.length_unit)),
             {.size = 11.5});
    svg.text({shares_card.right(), y}, fmt::format("{} %", significant_text(100 * shares[i].share, 2)),
             {.size = 11.5, .anchor = "end", .weight = 650});
    svg.rectangle({shares_card.left, y + 4}, shares_card.width, 6, fill(palette::grid));
    svg.rectangle({shares_card.left, y + 4}, shares_card.width * shares[i].share, 6, fill(palette::accent));
  }
}

std::string figures_of(const ToleranceStudy& study) {
  const ToleranceReport& report = study.report;
  std::string text = fmt::format("error {} to first order, {} of {} samples   ·   worst case {}",
                                 error_words_in(study, report.error), error_words_in(study, report.sampled.error),
                                 grouped_text(report.sampled.samples), error_words_in(study, report.worst_case));
  if (report.sampled.yield)
    text += fmt::format("   ·   yield {} %", significant_text(100 * report.sampled.yield->share, 5));
  if (report.sampled.not_assembled > 0) text += fmt::format("   ·   {} do not assemble", report.sampled.not_assembled);
  return text;
}

}  // namespace

std::string draw_tolerances(const ToleranceStudy& study) {
  SvgCanvas svg = linkage_sheet::begin(study.title.empty() ? "Linkage" : study.title, "tolerances");
  svg.text({linkage_sheet::border, 66}, figures_of(study), {.size = 13, .color = palette::ink2});
  if (study.report.sampled.assembled() > 0) {
    draw_histograms(svg, study);
    draw_places(svg, study);
  }
  draw_shares(svg, study);
  return svg.file();
}

}  // namespace linkwright
