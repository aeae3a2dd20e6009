#include "session.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"

namespace linkwright::python {
namespace {

/// A session that one thread at a time asks. Arrays are copies: they stay as they are when it is asked again.
class LockedSession {
  template <class Question>
  auto ask(Question&& question) {
    return without_gil([&] {
      const std::lock_guard lock(mutex_);
      return question(session_);
    });
  }

  struct Explored {
    explicit Explored(const wasm::ExploreReply& reply) : task(reply.task), census(reply.census) {
      if (reply.map == nullptr) return;
      const RegionMap& map = reply.map->map();
      input.assign(reply.input_tau.begin(), reply.input_tau.end());
      output.assign(reply.output_tau.begin(), reply.output_tau.end());
      types.assign(map.types().begin(), map.types().end());
      defects.assign(map.defects().begin(), map.defects().end());
      fails = reply.map->fails();
      values = reply.map->values();
    }
    std::string task, census;
    std::vector<double> input, output;
    std::vector<std::uint8_t> types, defects;
    std::vector<FailureBits> fails;
    std::vector<float> values;
  };

 public:
  /// JSON text of the mistakes, "[]" for none.
  std::string set_problem(const std::string& text) {
    return ask([&](wasm::Session& session) {
      session.set_problem(text);
      return session.mistakes();
    });
  }

  py::dict explore(int samples, std::array<double, 2> input, std::array<double, 2> output,
                   const std::string& property) {
    Explored found = ask([&](wasm::Session& session) {
      return Explored(session.explore({samples, input, output, property, wasm::ExploreRequest{}.order}));
    });
    py::dict reply;
    reply["task"] = found.task;
    if (found.census.empty()) return reply;
    const auto rows = static_cast<py::ssize_t>(found.input.size()),
               columns = static_cast<py::ssize_t>(found.output.size());
    reply["census"] = found.census;
    reply["input"] = owned(std::move(found.input), {rows});
    reply["output"] = owned(std::move(found.output), {columns});
    reply["types"] = owned(std::move(found.types), {rows, columns});
    reply["defects"] = owned(std::move(found.defects), {rows, columns});
    reply["failures"] = owned(std::move(found.fails), {rows, columns});
    reply["values"] = owned(std::move(found.values), {rows, columns});
    return reply;
  }

  py::tuple linkage(double input, double output) {
    wasm::LinkageReply reply = ask([&](wasm::Session& session) { return session.linkage(input, output); });
    const auto count = static_cast<py::ssize_t>(reply.states.size());
    return py::make_tuple(reply.linkage, owned(std::move(reply.states), {count}), reply.tolerance);
  }
  std::string best(int most) {
    return ask([&](const wasm::Session& session) { return session.best(most); });
  }
  std::string improve(double input, double output) {
    return ask([&](const wasm::Session& session) { return session.improve(input, output); });
  }
  std::string verify(double input, double output) {
    return ask([&](wasm::Session& session) { return session.verify(input, output); });
  }
  std::string exported(double input, double output, const std::string& format) {
    return ask([&](const wasm::Session& session) { return session.exported(input, output, format); });
  }
  py::array offsets(int part, bool turn, double reach, int steps, int samples) {
    std::vector<std::uint32_t> counts = ask([&](const wasm::Session& session) {
      return session.halo({part, turn, reach, steps, samples});
    });
    const auto size = static_cast<py::ssize_t>(steps);
    const bool is_line = counts.size() == static_cast<std::size_t>(steps);
    if (counts.empty()) return owned(std::move(counts), {0});
    return is_line ? owned(std::move(counts), {size}) : owned(std::move(counts), {size, size});
  }

 private:
  std::mutex mutex_;
  wasm::Session session_;
};

}  // namespace

void bind_session(py::module_& module) {
  py::class_<LockedSession>(module, "Session")
      .def(py::init<>())
      .def("set_problem", &LockedSession::set_problem)
      .def("explore", &LockedSession::explore)
      .def("linkage", &LockedSession::linkage)
      .def("best", &LockedSession::best)
      .def("improve", &LockedSession::improve)
      .def("verify", &LockedSession::verify)
      .def("exported", &LockedSession::exported)
      .def("offsets", &LockedSession::offsets);
}

}  // namespace linkwright::python
