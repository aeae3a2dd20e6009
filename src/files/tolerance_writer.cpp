#include "tolerance_writer.hpp"

#include "file_header.hpp"
#include "files/fields/field_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/tolerance_file.hpp"
#include "problem_fields.hpp"
#include "problem_writer.hpp"
#include "result_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

double readable(double value, bool is_angle) { return is_angle ? degrees_for_files(value) : value; }

void write_half_tolerance(JsonWriter& json, double tolerance, bool is_angle) {
  json.member(is_angle ? "tolerance_deg" : "tolerance", readable(tolerance, is_angle));
}

void write_shares(JsonWriter& json, const std::vector<ParameterShare>& shares) {
  json.key("sensitivities");
  json.begin_list();
  for (const ParameterShare& share : shares) {
    json.begin_object(Layout::one_line);
    json.member("parameter", std::string_view(share.parameter));
    write_half_tolerance(json, share.tolerance, share.is_angle);
    json.member("share", share.share);
    json.key("per_position");
    json.begin_list(Layout::one_line);
    for (const double part : share.per_position) json.value(part);
    json.end_list();
    json.end_object();
  }
  json.end_list();
}

void write_allocation(JsonWriter& json, const std::optional<std::vector<ParameterTolerance>>& allocation) {
  json.key("allocation");
  if (!allocation) return json.null();
  json.begin_list();
  for (const ParameterTolerance& of : *allocation) {
    json.begin_object(Layout::one_line);
    json.member("parameter", std::string_view(of.parameter));
    write_half_tolerance(json, of.tolerance, of.is_angle);
    json.end_object();
  }
  json.end_list();
}

void write_yield(JsonWriter& json, const SampledErrors& sampled) {
  json.key("yield");
  sampled.yield ? json.value(sampled.yield->share) : json.null();
  json.key("yield_interval");
  sampled.yield ? write_interval(json, sampled.yield->low, sampled.yield->high) : json.null();
  json.member("not_assembled", static_cast<double>(sampled.not_assembled) / static_cast<double>(sampled.samples));
}

}  // namespace

void write_tolerance_report(JsonWriter& json, const ToleranceReport& report, const Tolerances& tolerances) {
  const auto number = [&](std::string_view key, double error) { json.member(key, readable(error, report.of_angle)); };
  json.begin_object();
  json.member("unit", report.of_angle ? "degrees" : "length");
  number("error", report.error);
  number("error_sampled", report.sampled.error);
  if (report.error_realigned) number("error_realigned", *report.error_realigned);
  if (report.sampled_realigned) number("error_realigned_sampled", report.sampled_realigned->error);
  json.member("beyond_first_order", report.beyond_first_order);
  number("worst_case", report.worst_case);
  number("mean_plus_3_sigma", report.sampled.mean_plus_3_sigma());
  if (report.sampled_realigned) number("mean_plus_3_sigma_realigned", report.sampled_realigned->mean_plus_3_sigma());
  json.member("signal_to_noise_db", report.signal_to_noise());
  write_yield(json, report.sampled);
  json.member("samples", report.sampled.samples);
  json.member("seed", static_cast<std::int64_t>(tolerances.seed));
  write_shares(json, report.shares);
  write_allocation(json, report.allocation);
  json.end_object();
}

ListedNotes::ListedNotes(const Findings& found, std::size_t place) {
  if (place < found.fails.size()) fails_ = &found.fails[place];
  if (place < found.tolerance.size()) tolerance_ = &found.tolerance[place];
  if (found.options.tolerances) tolerances_ = &*found.options.tolerances;
}

void ListedNotes::write(JsonWriter& json) const {
  if (fails_) write_failures(json, *fails_);
  if (!tolerance_) return;
  json.key("tolerance");
  *tolerance_ ? write_tolerance_report(json, **tolerance_, *tolerances_) : json.null();
}

std::string write_tolerance_study(const ToleranceStudy& study) {
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(study.title));
    json.member("length_unit", std::string_view(study.length_unit));
    json.key("tolerances");
    write_fields(json, study.tolerances);
    json.key("tolerance");
    write_tolerance_report(json, study.report, study.tolerances);
    json.end_object();
  });
}

}  // namespace linkwright
