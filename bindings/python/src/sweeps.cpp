#include <pybind11/stl.h>

#include "bindings.hpp"
#include "cancellation.hpp"
#include "linkwright/sweep/run_sweep.hpp"

namespace linkwright::python {
namespace {

py::dtype type_of(const SweepColumn& column) {
  switch (column.kind) {
    case ColumnKind::number:
      return py::dtype::of<double>();
    case ColumnKind::count:
      return py::dtype::of<std::int64_t>();
    case ColumnKind::flag:
      return py::dtype::of<std::uint8_t>();
    default:
      return py::dtype("S" + std::to_string(column.width));
  }
}

/// Table by table the columns, what `of` makes of each.
template <class Of>
py::dict by_table(const SweepPlan& plan, Of&& of) {
  py::dict tables;
  for (std::size_t t = 0; t < sweep_table_names.size(); ++t) {
    py::dict columns;
    for (std::size_t k = 0; k < plan.columns()[t].size(); ++k)
      columns[py::str(plan.columns()[t][k].name)] = of(t, k, plan.columns()[t][k]);
    tables[py::str(std::string(sweep_table_names[t]))] = columns;
  }
  return tables;
}

py::dict rows_of(const SweepPlan& plan, std::int64_t first, std::int64_t last,
                 const std::shared_ptr<Cancellation>& cancellation) {
  if (first < 0 || last > plan.samples() || first > last) throw py::index_error("there are no such samples");
  const auto rows = without_gil([&] { return sweep_samples(plan, first, last, &cancellation->asked); });
  if (!rows) throw CallersMistakes{{Error{"cancelled", "", "stopped before all samples were there", {}}}};
  return by_table(plan, [&](std::size_t table, std::size_t k, const SweepColumn& column) {
    const TableRows& of = rows->of(static_cast<SweepTable>(table));
    return py::array(type_of(column), std::vector<py::ssize_t>{static_cast<py::ssize_t>(of.rows())},
                     of.bytes(k).data());
  });
}

std::int64_t checked(const SweepPlan& plan, std::int64_t sample) {
  if (sample < 0 || sample >= plan.samples()) throw py::index_error("there is no such sample");
  return sample;
}

}  // namespace

void bind_sweeps(py::module_& module) {
  py::class_<SweepPlan>(module, "SweepPlan")
      .def(py::init(
          [](const std::string& text, const std::string& folder) { return value_of(SweepPlan::read(text, folder)); }))
      .def_property_readonly("title", &SweepPlan::title)
      .def_property_readonly("samples", &SweepPlan::samples)
      .def_property_readonly("block_samples", &SweepPlan::block_samples)
      .def_property_readonly("variables",
                             [](const SweepPlan& plan) {
                               py::list names;
                               for (const SweepVariable& variable : plan.variables()) names.append(variable.name);
                               return py::tuple(names);
                             })
      .def_property_readonly("problem_text", &SweepPlan::base_text)
      .def_property_readonly("sweep_text", &SweepPlan::sweep_text)
      .def("values", [](const SweepPlan& plan, std::int64_t sample) { return plan.values(checked(plan, sample)); })
      .def("problem",
           [](const SweepPlan& plan, std::int64_t sample) { return plan.problem_text(checked(plan, sample)); })
      .def("columns",
           [](const SweepPlan& plan) {
             return by_table(plan, [](std::size_t, std::size_t, const SweepColumn& column) {
               return py::make_tuple(column.unit, column.description);
             });
           })
      .def("rows", rows_of);
}

}  // namespace linkwright::python
