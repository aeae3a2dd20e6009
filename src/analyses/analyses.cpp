#include "analyses.hpp"

#include <algorithm>

#include "analyses/loads/loads_analysis.hpp"
#include "analyses/tolerances/tolerance_analysis.hpp"
#include "linkwright/files/length_unit.hpp"

namespace linkwright {

void analysis_fields(FieldVisitor& v, SynthesisOptions& options, std::string_view length_unit) {
  v.optional("tolerances", options.tolerances);
  v.member(Field("loads").absent(!options.loads), false, [&](FieldVisitor& to) {
    Loads loads = options.loads.value_or(Loads{});
    const auto mm = millimetres(length_unit);
    loads.metres = mm ? std::optional(*mm / 1000) : std::nullopt;
    fields(to, loads);
    options.loads = loads;
  });
}

std::vector<Error> mistakes_in_analyses(const SynthesisOptions& options) {
  std::vector<Error> found = options.loads ? mistakes_in(*options.loads) : std::vector<Error>();
  if (options.tolerances)
    for (Error& mistake : mistakes_in(*options.tolerances)) found.push_back(std::move(mistake));
  return found;
}

std::vector<Error> mistakes_in_analyses(const Task& task, const Requirements& wanted, const SynthesisOptions& options) {
  std::vector<Error> found = mistakes_about_tolerances(task, wanted, options);
  for (Error& mistake : mistakes_about_loads(task, wanted, options)) found.push_back(std::move(mistake));
  return found;
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

bool analyze_alike(const SynthesisOptions& a, const SynthesisOptions& b) {
  return a.tolerances == b.tolerances && a.loads == b.loads;
}

AddedMeasures added_measures(const LinkageFamily& family, const SynthesisOptions& options,
                             const std::shared_ptr<const CellMeasure>& of_task, bool with_sampled) {
  AddedMeasures added = options.loads ? load_measures(family, *options.loads) : AddedMeasures{};
  if (of_task) added.all.insert(added.all.begin(), {.measure = of_task});
  if (options.tolerances)
    for (AddedMeasure& measure : tolerance_measures(family, *options.tolerances, with_sampled).all)
      added.all.push_back(std::move(measure));
  return added;
}

std::optional<Requirements> report_analyses(Answer& answer, const Progress& progress) {
  std::optional<Requirements> with_room;
  if (findings(answer).options.loads) with_room = report_loads(answer, progress);
  if (findings(answer).options.tolerances) report_tolerances(answer, progress);
  return with_room;
}

void analyses_of_list(Answer& answer) {
  if (findings(answer).options.loads) loads_of_list(answer);
}

void report_fields(FieldVisitor& v, const Findings* found, std::size_t place) {
  tolerance_field(v, found, place);
  loads_field(v, found, place);
}

void list_analyses(LinkageColumns& list, const Problem& problem) {
  if (problem.options.tolerances) list_tolerances(list, problem.task);
  if (problem.options.loads) list_loads(list, *problem.options.loads);
}

std::vector<Shape> study_documents() {
  return {{JsonType::object, [](FieldVisitor& v) { fields(v, ToleranceStudy{}); }}, load_study_document()};
}

}  // namespace linkwright
