#include "bindings.hpp"

namespace linkwright::python {
namespace {

py::dict values_of(const Values& values) {
  py::dict named;
  for (const NamedValue& value : values)
    named[py::str(value.name)] = std::visit([](const auto& content) { return py::cast(content); }, value.value);
  return named;
}

void raise(const std::vector<Error>& errors) {
  const py::module_ package = py::module_::import("linkwright.errors");
  py::list mistakes;
  for (const Error& error : errors)
    mistakes.append(package.attr("Mistake")(error.code, error.place, error.message, values_of(error.values)));
  const bool cancelled = errors.size() == 1 && errors.front().code == "cancelled";
  const py::object type = package.attr(cancelled ? "Cancelled" : "ProblemError");
  const py::object raised = cancelled ? type(errors.front().message) : type(mistakes);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void bind_mistakes(py::module_& /*module*/) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const CallersMistakes& mistakes) {
      raise(mistakes.errors);
    }
  });
}

}  // namespace linkwright::python
