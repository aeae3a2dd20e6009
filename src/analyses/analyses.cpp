#include "analyses.hpp"

#include <algorithm>

#include "analyses/tolerances/tolerance_analysis.hpp"

namespace linkwright {

void analysis_fields(FieldVisitor& v, SynthesisOptions& options) { v.optional("tolerances", options.tolerances); }

std::vector<Error> mistakes_in_analyses(const SynthesisOptions& options) {
  return options.tolerances ? mistakes_in(*options.tolerances) : std::vector<Error>();
}

std::vector<Error> mistakes_in_analyses(const Task& task, const Requirements& wanted, const SynthesisOptions& options) {
  return mistakes_about_tolerances(task, wanted, options);
}

SynthesisOptions with_task_defaults(SynthesisOptions options, double characteristic_length) {
  if (options.tolerances && !options.tolerances->turning_length)
    options.tolerances->turning_length = characteristic_length;
  return options;
}

SynthesisOptions reported_soon(SynthesisOptions options) {
  constexpr int few_samples = 10'000;
  if (options.tolerances) options.tolerances->samples = std::min(options.tolerances->samples, few_samples);
  return options;
}

bool analyze_alike(const SynthesisOptions& a, const SynthesisOptions& b) { return a.tolerances == b.tolerances; }

AddedMeasures added_measures(const LinkageFamily& family, const SynthesisOptions& options, bool with_sampled) {
  return options.tolerances ? tolerance_measures(family, *options.tolerances, with_sampled) : AddedMeasures{};
}

void report_analyses(Answer& answer, const Progress& progress) {
  if (findings(answer).options.tolerances) report_tolerances(answer, progress);
}

void report_fields(FieldVisitor& v, const Findings* found, std::size_t place) { tolerance_field(v, found, place); }

void list_analyses(LinkageColumns& list, const Problem& problem) {
  if (problem.options.tolerances) list_tolerances(list, problem.task);
}

std::vector<Shape> study_documents() {
  return {{JsonType::object, [](FieldVisitor& v) { fields(v, ToleranceStudy{}); }}};
}

}  // namespace linkwright
