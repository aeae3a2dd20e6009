#include <map>
#include <mutex>
#include <optional>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "cancellation.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/task_label.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "watched_work.hpp"

namespace linkwright::python {
namespace {

/// A problem and its answer, and columns of the map as files have them, made when they are first asked for.
class Solved {
 public:
  Solved(Problem problem, Answer answer) : problem_(std::move(problem)), answer_(std::move(answer)) {}

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const Answer& answer() const { return answer_; }
  [[nodiscard]] const RegionMap& map() const { return findings(answer_).region; }

  [[nodiscard]] const std::vector<float>& values(const std::string& key) const {
    const std::lock_guard lock(mutex_);
    if (const auto kept = values_.find(key); kept != values_.end()) return kept->second;
    const std::vector<Measure> known = map().reported_measures();
    const auto named = std::find(known.begin(), known.end(), Measure{key});
    if (named == known.end()) throw py::key_error(key);
    std::vector<float> column(map().rows() * map().columns());
    for (std::size_t row = 0; row < map().rows(); ++row)
      row_values(map(), *named, row, std::span(column).subspan(map().index(row, 0), map().columns()));
    return values_.emplace(key, std::move(column)).first->second;
  }
  [[nodiscard]] const std::vector<FailureBits>& failures() const {
    const std::lock_guard lock(mutex_);
    if (!failures_) {
      failures_.emplace(map().rows() * map().columns());
      const auto family =
          std::visit([](const auto& of_kind) { return static_cast<const LinkageFamily*>(of_kind.family()); }, answer_);
      if (family) filter_of(*family, map(), findings(answer_).requirements).failures_of_all(*failures_);
    }
    return *failures_;
  }

 private:
  Problem problem_;
  Answer answer_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::vector<float>> values_;
  mutable std::optional<std::vector<FailureBits>> failures_;
};

using SharedSolved = std::shared_ptr<Solved>;

SharedSolved solve(const Problem& problem, const py::object& report,
                   const std::shared_ptr<Cancellation>& cancellation) {
  auto answer = watched([&](const Progress& progress) { return linkwright::solve(problem, progress); }, report,
                        &cancellation->asked);
  return std::make_shared<Solved>(problem, value_of(std::move(answer)));
}

Problem problem_of_file(const std::string& path) { return value_of(read_problem_file(path)); }

py::array of_cells(const Solved& solved, const auto& column, const py::handle& owner) {
  const RegionMap& map = solved.map();
  return view(column.data(), {static_cast<py::ssize_t>(map.rows()), static_cast<py::ssize_t>(map.columns())}, owner);
}
py::array of_axis(std::span<const double> coordinates, const py::handle& owner) {
  return view(coordinates.data(), {static_cast<py::ssize_t>(coordinates.size())}, owner);
}

std::vector<std::string> measure_keys(const Solved& solved) {
  std::vector<std::string> keys;
  if (solved.map().measures().empty()) return keys;
  for (const Measure& measure : solved.map().reported_measures()) keys.emplace_back(measure.key);
  return keys;
}

std::vector<std::string> requirement_keys(const Solved& solved) {
  std::vector<std::string> keys;
  for (const RequirementKind kind : linkages(solved.problem().task).requirements) keys.emplace_back(key(kind));
  return keys;
}

}  // namespace

void bind_solving(py::module_& module) {
  py::class_<Cancellation, std::shared_ptr<Cancellation>>(module, "Cancellation",
                                                          "Stops a solve() that runs in another thread.")
      .def(py::init<>())
      .def(
          "cancel", [](Cancellation& of) { of.asked = true; }, "Ask solve() to stop; may be called by any thread.")
      .def_property_readonly(
          "cancelled", [](const Cancellation& of) { return of.asked.load(); }, "Whether it was asked to stop.");
  py::class_<Problem>(module, "Problem")
      .def(py::init([](const std::string& text) { return value_of(read_problem(text)); }))
      .def("set_samples",
           [](Problem& problem, int samples) {
             SynthesisOptions options = problem.options;
             options.region_samples = samples;
             if (auto mistakes = mistakes_in(options); !mistakes.empty()) throw CallersMistakes{std::move(mistakes)};
             problem.options = std::move(options);
           })
      .def("text", [](const Problem& problem) { return write_problem(problem); })
      .def("label", [](const Problem& problem) { return task_label(problem.task); });
  module.def("read_problem_file", &problem_of_file);
  module.def("read_result_file",
             [](const std::string& path) { return py::bytes(value_of(read_text_file(path, max_result_bytes))); });
  module.def("write_file", [](const std::string& path, const std::string& text) {
    const auto failure = write_atomically(path, text);
    return failure ? failure->message : "";
  });
  module.def("solve", &solve);
  py::class_<Solved, SharedSolved>(module, "Solved")
      .def("result",
           [](const Solved& solved, bool with_region) {
             return without_gil([&] { return write_result(solved.problem(), solved.answer(), with_region); });
           })
      .def("svg",
           [](const Solved& solved) {
             return without_gil([&] { return draw_answer(solved.problem(), solved.answer()); });
           })
      .def("measures", &measure_keys)
      .def("requirements", &requirement_keys)
      .def("input",
           [](const py::object& self) { return of_axis(self.cast<const Solved&>().map().input_coordinates(), self); })
      .def("output",
           [](const py::object& self) { return of_axis(self.cast<const Solved&>().map().output_coordinates(), self); })
      .def("types",
           [](const py::object& self) {
             const auto& solved = self.cast<const Solved&>();
             return of_cells(solved, solved.map().types(), self);
           })
      .def("defects",
           [](const py::object& self) {
             const auto& solved = self.cast<const Solved&>();
             return of_cells(solved, solved.map().defects(), self);
           })
      .def("values",
           [](const py::object& self, const std::string& key) {
             const auto& solved = self.cast<const Solved&>();
             return of_cells(solved, solved.values(key), self);
           })
      .def("failures", [](const py::object& self) {
        const auto& solved = self.cast<const Solved&>();
        return of_cells(solved, solved.failures(), self);
      });
}

}  // namespace linkwright::python
