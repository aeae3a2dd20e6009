#include "files/document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/problem_fields.hpp"
#include "files/result_fields.hpp"
#include "linkwright/files/number_text.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

constexpr Number rounded_share = {.least = 0, .most = 1.000001};

double readable(double value, bool is_angle) { return is_angle ? degrees_for_files(value) : value; }

void half_tolerance_fields(FieldVisitor& v, double tolerance, bool is_angle) {
  const double shown = readable(tolerance, is_angle);
  v.shown_if_any("tolerance", forms::where(!is_angle, shown), forms::not_negative);
  v.shown_if_any("tolerance_deg", forms::where(is_angle, shown), forms::not_negative);
}

}  // namespace

static void fields(FieldVisitor& v, const ParameterShare& share) {
  v.object({.name = "sensitivity"}, [&](FieldVisitor& to) {
    to.shown("parameter", share.parameter);
    half_tolerance_fields(to, share.tolerance, share.is_angle);
    to.shown("share", share.share, rounded_share);
    to.shown("per_position", share.per_position, forms::on_a_line, rounded_share);
  });
}

static void fields(FieldVisitor& v, const ParameterTolerance& of) {
  v.object({.name = "allocated_tolerance"}, [&](FieldVisitor& to) {
    to.shown("parameter", of.parameter);
    half_tolerance_fields(to, of.tolerance, of.is_angle);
  });
}

namespace {

void sampling_fields(FieldVisitor& v, const SampledErrors& sampled, std::uint64_t seed) {
  const auto& yield = sampled.yield;
  const auto interval = yield ? std::optional(std::array{yield->low, yield->high}) : std::nullopt;
  v.shown(
      Field("yield", "Share of the samples that assemble and keep the limit in all positions; null without a limit."),
      yield ? std::optional(yield->share) : std::nullopt, forms::share);
  v.shown(Field("yield_interval", "In which the true yield lies with 95 %."), interval,
          Pair{.form = "[low, high]", .each = forms::share});
  v.shown(Field("not_assembled", "Share of the samples."),
          static_cast<double>(sampled.not_assembled) / static_cast<double>(sampled.samples), forms::share);
  v.shown("samples", sampled.samples, Whole{1, forms::count.most});
  v.shown("seed", seed, forms::count);
}

void error_fields(FieldVisitor& v, const ToleranceReport& report) {
  const auto readable_error = [&](double error) { return readable(error, report.of_angle); };
  const auto& realigned = report.sampled_realigned;
  v.shown(Field("error",
                "To first order: root mean square over the positions; of a straight line the largest 3σ over the "
                "stroke."),
          readable_error(report.error), forms::not_negative);
  v.shown("error_sampled", readable_error(report.sampled.error), forms::not_negative);
  v.shown_if_any(Field("error_realigned", "Straight lines: the line laid anew in each linkage made."),
                 forms::where(report.error_realigned.has_value(), readable_error(report.error_realigned.value_or(0))),
                 forms::not_negative);
  v.shown_if_any("error_realigned_sampled", realigned ? std::optional(readable_error(realigned->error)) : std::nullopt,
                 forms::not_negative);
  v.shown(Field("beyond_first_order", "The sampled error is the one that counts."), report.beyond_first_order);
  v.shown("worst_case", readable_error(report.worst_case), forms::not_negative);
  v.shown(Field("mean_plus_3_sigma", "Of the largest error over the positions, sampled."),
          readable_error(report.sampled.mean_plus_3_sigma()), forms::not_negative);
  v.shown_if_any("mean_plus_3_sigma_realigned",
                 realigned ? std::optional(readable_error(realigned->mean_plus_3_sigma())) : std::nullopt,
                 forms::not_negative);
}

}  // namespace

void fields(FieldVisitor& v, const ToleranceRecord& of) {
  const ToleranceReport& report = of.report;
  v.object({.name = "tolerance", .about = "What tolerances do to the linkage.", .on_lines = true},
           [&](FieldVisitor& to) {
             to.shown(Field("unit", "Of the errors."), std::size_t{report.of_angle}, Words{{"length", "degrees"}});
             error_fields(to, report);
             to.shown("signal_to_noise_db", report.signal_to_noise(), forms::or_infinite);
             sampling_fields(to, report.sampled, of.seed);
             to.shown(Field("sensitivities", "Largest share of the variance first."), report.shares, forms::on_lines);
             to.shown(Field("allocation",
                            "The tolerances of least cost that keep the error; null where no cost is given, and of "
                            "straight lines."),
                      report.allocation, forms::on_lines);
           });
}

void tolerance_field(FieldVisitor& v, const Findings* found, std::size_t place) {
  const bool is_told = found && place < found->tolerance.size();
  const std::optional<ToleranceReport> none;
  v.member(Field("tolerance", "Only with tolerances; null at a dead point.").written(is_told), false,
           [&](FieldVisitor& to) {
             visit_or_null(to, is_told ? found->tolerance[place] : none,
                           [&](FieldVisitor& in, const ToleranceReport& report) {
                             fields(in, ToleranceRecord{report, is_told ? found->options.tolerances->seed : 0});
                           });
           });
}

void fields(FieldVisitor& v, const ToleranceStudy& of) {
  Tolerances tolerances = of.tolerances;
  v.object({"tolerance_study", "Of one linkage of a result, with the tolerances that were used.", true},
           [&](FieldVisitor& to) {
             head_fields(to, of);
             to.member("tolerances", true, [&](FieldVisitor& at) {
               at.described_in("problem.schema.json#/$defs/tolerances",
                               [&](FieldVisitor& in) { fields(in, tolerances); });
             });
             to.shown("tolerance", ToleranceRecord{of.report, of.tolerances.seed});
           });
}

std::string write_tolerance_study(const ToleranceStudy& study) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, study); });
}

}  // namespace linkwright
