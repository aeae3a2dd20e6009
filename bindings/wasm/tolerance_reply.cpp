#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analyses/tolerances/tolerance_analysis.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"
#include "robust/sampled_positions.hpp"

namespace linkwright::wasm {
namespace {

constexpr int samples_at_a_glance = 2000, samples_of_a_histogram = 20'000;

std::vector<std::int64_t> counts_of(const std::vector<double>& errors, double from, double to, int bins) {
  std::vector<std::int64_t> counts(static_cast<std::size_t>(bins));
  for (const double error : errors) {
    const double place = to > from ? (error - from) / (to - from) * bins : 0;
    ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, bins - 1.0))];
  }
  return counts;
}

// One scale for all positions, from 0 or, of lines, as far to one side as to the other.
Histograms histograms_of(const LinkageOutput& output, const Tolerances& tolerances, int bins) {
  const ErrorSamples samples =
      error_samples(output, tolerances, static_cast<std::size_t>(std::min(tolerances.samples, samples_of_a_histogram)));
  double most = 0;
  for (const auto& errors : samples.errors)
    for (const double error : errors) most = std::max(most, std::abs(error));
  const double unit = is_angle(output) ? degrees(1) : 1, from = is_line(output) ? -most : 0;
  Histograms histograms{unit * from, unit * most, {}};
  for (const auto& errors : samples.errors) histograms.counts.push_back(counts_of(errors, from, most, bins));
  return histograms;
}

/// Of a straight line its ends and the middle; of others all positions.
LinkageOutput drawn_positions(const LinkageOutput& output) {
  if (!is_line(output)) return output;
  PlanarOutput line = std::get<PlanarOutput>(output);
  const auto& all = line.positions;
  line.positions = {all.front(), all[all.size() / 2], all.back()};
  return line;
}

void append(std::vector<double>& drawn, std::initializer_list<Point> points) {
  for (const Point p : points) drawn.insert(drawn.end(), {p.real(), p.imag()});
}
void append_joints(std::vector<double>& drawn, const TracingFourBar& made) {
  append(drawn,
         {made.bars.input_fixed, made.bars.input_moving, made.bars.output_moving, made.bars.output_fixed, made.point});
}
void append_joints(std::vector<double>& drawn, const SphericalFourBar& made) {
  for (const Vector3 axis : {made.input_fixed, made.input_moving, made.output_moving, made.output_fixed})
    drawn.insert(drawn.end(), {axis.x, axis.y, axis.z});
}
void append_joints(std::vector<double>& drawn, const SampledSixBar& made) {
  for (const Point joint : made.joints) append(drawn, {joint});
  append(drawn, {made.guided.origin});
}

std::vector<double> drawn_samples(const LinkageOutput& output, const Tolerances& tolerances, int count) {
  std::vector<double> drawn;
  std::visit(
      [&](const auto& one) {
        for (const auto& sample : sampled_positions(one, tolerances, static_cast<std::size_t>(count)))
          for (const auto& made : sample) append_joints(drawn, made);
      },
      drawn_positions(output));
  return drawn;
}

}  // namespace

void fields(FieldVisitor& v, const YieldsReply& of) {
  v.object({.name = "yields_reply"}, [&](FieldVisitor& to) {
    to.shown("done", of.yields.done, forms::count);
    to.shown(Field("total", "Cells that meet all else."), of.yields.total, forms::count);
  });
}

void fields(FieldVisitor& v, const FrontReply& of) {
  v.object({.name = "front_reply"}, [&](FieldVisitor& to) {
    to.shown(Field("front", "Row, column, first and second objective; the best by the first one first."), of.cells,
             forms::on_a_line, four);
  });
}

static void fields(FieldVisitor& v, const Histograms& of) {
  const Object described = {"histograms",
                            "Errors of samples, a row of counts to each position over one scale: from 0, of lines from "
                            "the right to the left."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("from", of.from);
    to.shown("to", of.to);
    to.shown("counts", of.counts, forms::on_a_line, forms::on_a_line, forms::count);
  });
}

void fields(FieldVisitor& v, const ToleranceFigures& of) {
  v.object({.name = "tolerance_reply", .on_lines = true}, [&](FieldVisitor& to) {
    member_of_results(to, "tolerance", "tolerance", of.report);
    to.shown("histograms", of.histograms);
    to.shown(Field("positions", "Of the samples drawn: of a straight line its ends and the middle."), of.positions,
             forms::count);
  });
}

ToleranceReply tolerance_reply(const LinkageOutput& output, const Tolerances& tolerances, int bins, int drawn) {
  const auto report = tolerance_report(output, tolerances);
  if (!report) return {};
  const KeptVisit figures = [&](FieldVisitor& v) { linkwright::fields(v, ToleranceRecord{*report, tolerances.seed}); };
  ToleranceReply reply;
  reply.report = text_of(ToleranceFigures{figures, histograms_of(output, tolerances, bins),
                                          static_cast<std::int64_t>(positions_of(drawn_positions(output)))});
  reply.drawn = drawn_samples(output, tolerances, drawn);
  return reply;
}

std::string tolerance_at_a_glance(const LinkageOutput& output, const Tolerances& tolerances) {
  Tolerances few = tolerances;
  few.samples = std::min(tolerances.samples, samples_at_a_glance);
  const auto report = tolerance_report(output, few);
  if (!report) return "";
  return json_text_of([&](JsonWriter& json) { write_fields(json, ToleranceRecord{*report, few.seed}); });
}

}  // namespace linkwright::wasm
