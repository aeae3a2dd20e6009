#include "linkwright/solve/session.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/solve/halo.hpp"
#include "planar/path_family.hpp"

namespace linkwright::python {
namespace {

py::dict counts_of(const ColouredMap& map) {
  const RequirementCensus& census = map.census;
  std::vector<std::int64_t> only, left;
  for (const RequirementKind kind : census.kinds) {
    only.push_back(census.failing_only(kind));
    left.push_back(census.left_after(kind));
  }
  py::list relax;
  for (const Relaxation& relaxation : map.relax)
    relax.append(py::dict(py::arg("requirement") = key(relaxation.requirement), py::arg("leaves") = relaxation.leaves));
  return py::dict(py::arg("types") = map.counts.types, py::arg("pairs") = map.counts.pairs,
                  py::arg("order") = map.counts.order, py::arg("branch") = map.counts.branch,
                  py::arg("circuit") = map.counts.circuit, py::arg("defect_free") = map.counts.defect_free,
                  py::arg("meeting") = census.meeting, py::arg("meeting_types") = census.meeting_types,
                  py::arg("only") = only, py::arg("left") = left, py::arg("relax") = relax);
}

py::dict task_of(const Findings& known) {
  std::vector<std::string> warnings;
  for (const Notice& warning : known.warnings) warnings.push_back(warning.message);
  return py::dict(py::arg("pattern") = known.pattern, py::arg("condition") = known.condition,
                  py::arg("characteristic_length") = known.characteristic_length, py::arg("warnings") = warnings);
}

/// Rows of the travel: turn of the driver and transmission angle, degrees, then the hinges' coordinates.
py::array states_of(const Travel& travel) {
  std::vector<double> numbers;
  for (const TravelState& state : travel.states) {
    numbers.insert(numbers.end(), {degrees(state.turn), degrees(state.transmission_angle)});
    for (const Vector3 hinge : std::span(state.hinges).first(travel.linkage.hinges.size())) {
      numbers.insert(numbers.end(), {hinge.x, hinge.y});
      if (travel.linkage.spherical) numbers.push_back(hinge.z);
    }
  }
  const auto rows = static_cast<py::ssize_t>(travel.states.size());
  const auto columns = rows == 0 ? 0 : static_cast<py::ssize_t>(numbers.size()) / rows;
  return owned(std::move(numbers), {rows, columns});
}

std::string result_of(const Session& session, const Answer& answer) {
  constexpr bool with_region = false;
  return write_result(session.problem(), answer, with_region);
}

/// Where the linkages stand that share a place of the map, the best first.
std::vector<MapPoint> all_at(const Session& session, MapPoint place) {
  const auto* known = std::get_if<PathAnswer>(&session.known());
  const PathFamily* paths = known == nullptr ? nullptr : known->given.paths.get();
  if (paths == nullptr || paths->axis(Side::input).layers == 0) return {place};
  place.input = paths->axis(Side::input).onto(place.input);
  std::vector<MapPoint> places;
  for (const Cell& cell : paths->all_at(place, session.requirements().respect_direction)) places.push_back(cell.place);
  return places;
}

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
    std::vector<double> input, output;
    std::vector<std::uint8_t> types, defects;
    std::vector<FailureBits> fails;
    std::vector<float> values;
  };
  static Explored copy_of(const ColouredMap& map) {
    const auto copied = [](const auto& from) { return std::vector(from.begin(), from.end()); };
    return {copied(map.region.input_coordinates()),
            copied(map.region.output_coordinates()),
            copied(map.region.types()),
            copied(map.region.defects()),
            map.fails,
            map.values};
  }

 public:
  explicit LockedSession(const Problem& problem) : session_(problem) {}

  void set(const Problem& problem) {
    ask([&](Session& session) { session.set(problem); });
  }

  py::dict explore(int samples, std::array<double, 2> input, std::array<double, 2> output,
                   const std::string& property) {
    py::dict reply;
    std::unique_lock lock(mutex_, std::defer_lock);
    const ColouredMap* map = without_gil([&] {
      lock.lock();
      return session_.explore({samples, input, output, property, MapRequest{}.order});
    });
    reply["task"] = task_of(findings(session_.known()));
    if (map == nullptr) return reply;
    reply["counts"] = counts_of(*map);
    Explored found = copy_of(*map);
    const auto rows = static_cast<py::ssize_t>(found.input.size()),
               columns = static_cast<py::ssize_t>(found.output.size());
    reply["input"] = owned(std::move(found.input), {rows});
    reply["output"] = owned(std::move(found.output), {columns});
    reply["types"] = owned(std::move(found.types), {rows, columns});
    reply["defects"] = owned(std::move(found.defects), {rows, columns});
    reply["failures"] = owned(std::move(found.fails), {rows, columns});
    reply["values"] = owned(std::move(found.values), {rows, columns});
    return reply;
  }

  /// A result that lists it alone, empty where there is none; why it does not do the task; its states.
  py::tuple linkage(double input, double output) {
    std::string result, reason;
    const Travel travel = ask([&](Session& session) {
      if (!session.family()) return Travel{};
      if (const auto answer = session.result_at({input, output})) result = result_of(session, *answer);
      PickedLinkage picked = session.linkage({input, output});
      if (picked.reason) reason = picked.reason->message;
      return std::move(picked.travel);
    });
    return py::make_tuple(result, reason, states_of(travel));
  }
  std::vector<std::pair<double, double>> all_at(double input, double output) {
    std::vector<std::pair<double, double>> places;
    for (const MapPoint place : ask([&](const Session& of) { return python::all_at(of, {input, output}); }))
      places.emplace_back(place.input, place.output);
    return places;
  }
  /// A result.
  std::string best(int most) {
    return ask([&](const Session& session) {
      const auto answer = session.best(most);
      return answer ? result_of(session, *answer) : "";
    });
  }
  std::array<double, 2> improve(double input, double output) {
    const auto better = ask([&](const Session& session) { return session.improved({input, output}); });
    return better ? std::array{better->input, better->output} : std::array{input, output};
  }
  std::string exported(double input, double output, const std::string& format) {
    return ask([&](const Session& session) -> std::string {
      const bool is_result = format == "result";
      const auto answer = is_result ? session.result_at({input, output}) : session.answer_at({input, output});
      if (!answer) return "";
      if (is_result) return result_of(session, *answer);
      const Problem& problem = session.problem();
      return linkwright::exported(stored_linkages(problem, *answer).front(), format, problem.options.loads);
    });
  }
  py::array offsets(int part, bool turn, double reach, int steps, int samples) {
    std::vector<std::uint32_t> counts = ask([&](const Session& session) {
      return halo(session.problem(), {part, turn, reach, steps, samples});
    });
    const auto size = static_cast<py::ssize_t>(steps);
    const bool is_line = counts.size() == static_cast<std::size_t>(steps);
    if (counts.empty()) return owned(std::move(counts), {0});
    return is_line ? owned(std::move(counts), {size}) : owned(std::move(counts), {size, size});
  }

 private:
  std::mutex mutex_;
  Session session_;
};

}  // namespace

void bind_session(py::module_& module) {
  py::class_<LockedSession>(module, "Session")
      .def(py::init<const Problem&>())
      .def("set", &LockedSession::set)
      .def("explore", &LockedSession::explore)
      .def("linkage", &LockedSession::linkage)
      .def("all_at", &LockedSession::all_at)
      .def("best", &LockedSession::best)
      .def("improve", &LockedSession::improve)
      .def("exported", &LockedSession::exported)
      .def("offsets", &LockedSession::offsets);
}

}  // namespace linkwright::python
