#pragma once

#include <memory>
#include <mutex>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"

// The compiled half of `import linkwright`: the library's own calls, JSON text where the files have it, arrays where
// there are many numbers. What people use is written in Python, in ../linkwright.
namespace linkwright::python {

namespace py = pybind11;

/// Becomes linkwright.ProblemError.
struct CallersMistakes {
  std::vector<Error> errors;
};

template <class T>
T value_of(Result<T> result) {
  if (!result) throw CallersMistakes{result.errors()};
  return std::move(result).value();
}

/// An array that shows `data`, cannot be written to, and keeps `owner` alive.
template <class T>
py::array view(const T* data, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array_t<T> array(std::move(shape), data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// An array of its own, which cannot be written to.
template <class T>
py::array owned(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* held) { delete static_cast<std::vector<T>*>(held); });
  return view(kept->data(), std::move(shape), owner);
}

/// Work that Python's other threads need not wait for.
template <class Work>
auto without_gil(Work&& work) {
  const py::gil_scoped_release free;
  return work();
}

void bind_mistakes(py::module_& module);
void bind_solving(py::module_& module);
void bind_linkages(py::module_& module);
void bind_attitude(py::module_& module);
void bind_session(py::module_& module);
void bind_sweeps(py::module_& module);
void bind_vocabulary(py::module_& module);

}  // namespace linkwright::python
