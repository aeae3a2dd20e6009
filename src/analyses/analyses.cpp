#include "analyses.hpp"

#include "analyses/tolerances/tolerance_analysis.hpp"

namespace linkwright {

void analysis_fields(FieldVisitor& v, SynthesisOptions& options) { v.optional("tolerances", options.tolerances); }

bool analyze_alike(const SynthesisOptions& a, const SynthesisOptions& b) { return a.tolerances == b.tolerances; }

AddedMeasures added_measures(const LinkageFamily& family, const SynthesisOptions& options, bool with_sampled) {
  return options.tolerances ? tolerance_measures(family, *options.tolerances, with_sampled) : AddedMeasures{};
}

void report_analyses(Answer& answer, const Progress& progress) {
  if (findings(answer).options.tolerances) report_tolerances(answer, progress);
}

void report_fields(FieldVisitor& v, const Findings* found, std::size_t place) { tolerance_field(v, found, place); }

std::vector<Shape> study_documents() {
  return {{JsonType::object, [](FieldVisitor& v) { fields(v, ToleranceStudy{}); }}};
}

}  // namespace linkwright
