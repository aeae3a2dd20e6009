#include <map>
#include <optional>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "linkwright/analyses/load_study.hpp"
#include "linkwright/analyses/spring_places.hpp"
#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/machine/machine_export.hpp"
#include "watched_work.hpp"

namespace linkwright::python {
namespace {

/// A linkage as files carry it.
struct Linkage {
  AnyStoredLinkage stored;
};

MotionTable motion_of(const StoredLinkage& linkage) { return motion_columns(linkage); }
MotionTable motion_of(const StoredSixBar& linkage) {
  return motion_columns(tabulated_motion(linkage.six_bar, framed_poses(linkage)));
}
MotionTable motion_of(const StoredSphericalFourBar& linkage) { return motion_columns(analyze(linkage)); }

std::vector<Linkage> numbered(std::vector<AnyStoredLinkage> stored) {
  std::vector<Linkage> linkages;
  for (AnyStoredLinkage& linkage : stored) {
    std::string& title = std::visit([](auto& of_kind) -> std::string& { return of_kind.title; }, linkage);
    title += (title.empty() ? "linkage " : ", linkage ") + std::to_string(linkages.size() + 1);
    linkages.push_back({std::move(linkage)});
  }
  return linkages;
}

template <class Stored>
Stored swapped(Stored stored) {
  stored.four_bar = stored.four_bar.swapped();
  return stored;
}
StoredSixBar swapped(const StoredSixBar& /*stored*/) {
  throw CallersMistakes{
      {{"six_bar_driver", "drive", "a six-bar is analysed as body 1 drives it, at hinge a; leave drive out"}}};
}

std::string analysis_text(const Linkage& linkage, const std::string& drive) {
  if (drive != "input" && drive != "output")
    throw CallersMistakes{{{"unknown_drive", "drive", "the driving link is \"input\" or \"output\""}}};
  return std::visit(
      [&](const auto& stored) { return write_analysis(analyze(drive == "output" ? swapped(stored) : stored)); },
      linkage.stored);
}

using Pair = std::array<double, 2>;

std::optional<Point> point_of(const std::optional<Pair>& pair) {
  return pair ? std::optional(Point{(*pair)[0], (*pair)[1]}) : std::nullopt;
}

/// JSON text and picture.
std::pair<std::string, std::string> instant(const Linkage& linkage, const std::optional<Pair>& point,
                                            std::optional<double> input_deg, double input_acceleration) {
  const auto* stored = std::get_if<StoredLinkage>(&linkage.stored);
  if (stored == nullptr)
    throw CallersMistakes{{{"instant_of_a_plane", "mechanism", "an instant is told of planar four-bars"}}};
  InstantAsked asked{point_of(point), {}, input_acceleration};
  if (input_deg) asked.input_angle = radians(*input_deg);
  LinkageAnalysis analysis = analyze(*stored);
  analysis.instant = value_of(instant_of(*stored, asked));
  return {write_analysis(analysis), analysis.instant->analysis.instant ? draw_instant(analysis) : ""};
}

/// JSON text and picture.
std::pair<std::string, std::string> comparison(const Linkage& linkage, const std::vector<Pair>& points,
                                               const std::vector<double>& input_deg, bool closed, bool absolute,
                                               const std::optional<Pair>& point) {
  const auto* stored = std::get_if<StoredLinkage>(&linkage.stored);
  if (stored == nullptr)
    throw CallersMistakes{
        {{"comparison_of_a_plane", "mechanism", "paths of planar four-bars are compared with points"}}};
  PathTask task;
  task.closed = closed;
  task.crank_timing = input_deg.empty() ? CrankTiming::free : absolute ? CrankTiming::absolute : CrankTiming::relative;
  for (std::size_t j = 0; j < points.size(); ++j) {
    task.points.push_back({{points[j][0], points[j][1]}, {}, {}, {}, {}, {}});
    if (j < input_deg.size()) task.points.back().input = radians(input_deg[j]);
  }
  LinkageAnalysis analysis = analyze(*stored);
  analysis.comparison = value_of(compare_with_path(*stored, point_of(point), value_of(compared_path(task))));
  return {write_analysis(analysis), draw_comparison(*stored, *analysis.comparison)};
}

/// Likewise; poses are x, y and degrees.
std::pair<std::string, std::string> pose_comparison(const Linkage& linkage,
                                                    const std::vector<std::array<double, 3>>& poses,
                                                    const std::optional<std::array<double, 3>>& body,
                                                    const std::optional<double>& turning_length) {
  const auto* stored = std::get_if<StoredLinkage>(&linkage.stored);
  if (stored == nullptr)
    throw CallersMistakes{
        {{"comparison_of_a_plane", "mechanism", "bodies of planar four-bars are compared with poses"}}};
  const auto pose_of = [](const std::array<double, 3>& given) { return Pose{{given[0], given[1]}, radians(given[2])}; };
  std::vector<Pose> all;
  for (const auto& pose : poses) all.push_back(pose_of(pose));
  const std::optional<Pose> lies = body ? std::optional(pose_of(*body)) : std::nullopt;
  LinkageAnalysis analysis = analyze(*stored);
  analysis.pose_comparison = value_of(compare_with_poses(*stored, lies, value_of(compared_poses(all, turning_length))));
  return {write_analysis(analysis), draw_comparison(*stored, *analysis.pose_comparison)};
}

std::pair<std::string, std::string> instant_of_problem(const std::string& text, const std::optional<Pair>& point) {
  const PrescribedInstant found = value_of(prescribed_instant(value_of(read_problem(text)), point_of(point)));
  return {write_instant(found), found.analysis.instant ? draw_instant(found) : ""};
}

std::pair<std::string, std::string> tolerance(const std::string& result, int linkage, std::optional<double> length,
                                              std::optional<int> samples, std::optional<std::int64_t> seed) {
  const ListedStudy listed = value_of(listed_study(result, linkage, {length, samples, seed}));
  return {write_tolerance_study(listed.study), draw_tolerances(listed.study)};
}

/// Report, curves as a table, picture.
std::tuple<std::string, std::string, std::string> loads(const std::string& result, int linkage,
                                                        const std::optional<std::string>& of_case,
                                                        const std::optional<double>& free_share) {
  LoadChanges changes{of_case, {}};
  if (free_share) changes.real_springs.free_share = *free_share;
  const LoadStudy study = value_of(listed_loads(result, linkage, changes));
  return {write_load_study(study), load_table(study), draw_loads(study)};
}

/// A spring placed for a linkage of a result, by files' texts; `catalogue` may be nothing.
std::string place_spring(const std::string& result, int linkage, const std::string& boxes,
                         const std::optional<std::string>& catalogue) {
  return watched([&](const Progress& progress) {
    std::optional<SpringCatalogue> parts;
    if (catalogue) parts = value_of(read_spring_catalogue(*catalogue));
    const SpringWanted wanted = value_of(read_spring_boxes(boxes));
    return write_placed_spring(value_of(place_listed_spring(result, linkage, wanted, parts, {}, progress)));
  });
}

/// Content and warning; `sizes` by the names of WantedSizes.
std::pair<py::bytes, std::string> built(const Linkage& linkage, const std::string& format,
                                        const std::map<std::string, double>& sizes,
                                        const std::optional<int>& position) {
  MachineWishes wishes;
  if (position) wishes.position = *position - 1;
  const auto take = [&](const char* name, double& size) {
    if (const auto given = sizes.find(name); given != sizes.end()) size = given->second;
  };
  take("width", wishes.sizes.width);
  take("thickness", wishes.sizes.thickness);
  take("gap", wishes.sizes.gap);
  take("pin", wishes.sizes.pin);
  take("clearance", wishes.sizes.clearance);
  take("radius", wishes.sizes.radius);
  if (const auto given = sizes.find("density"); given != sizes.end()) wishes.density = given->second;
  const MachineFile file = without_gil([&] { return value_of(exported_machine(linkage.stored, format, wishes)); });
  return {py::bytes(file.content), file.warning};
}

}  // namespace

void bind_linkages(py::module_& module) {
  py::class_<Linkage>(module, "Linkage")
      .def(py::init([](const std::string& text) { return Linkage{value_of(read_any_linkage(text))}; }))
      .def("record",
           [](const Linkage& linkage) {
             return std::visit([](const auto& stored) { return stored.record; }, linkage.stored);
           })
      .def("title",
           [](const Linkage& linkage) {
             return std::visit([](const auto& stored) { return stored.title; }, linkage.stored);
           })
      .def("length_unit",
           [](const Linkage& linkage) {
             return std::visit([](const auto& stored) { return stored.length_unit; }, linkage.stored);
           })
      .def("exported",
           [](const Linkage& linkage, const std::string& format) {
             return without_gil([&] { return exported(linkage.stored, format); });
           })
      .def("built", &built)
      .def("motion",
           [](const Linkage& linkage) {
             MotionTable table = without_gil(
                 [&] { return std::visit([](const auto& stored) { return motion_of(stored); }, linkage.stored); });
             const auto rows = static_cast<py::ssize_t>(table.rows());
             const auto columns = static_cast<py::ssize_t>(table.columns.size());
             return py::make_tuple(table.columns, owned(std::move(table.values), {rows, columns}));
           })
      .def("analysis",
           [](const Linkage& linkage, const std::string& drive) {
             return without_gil([&] { return analysis_text(linkage, drive); });
           })
      .def("comparison",
           [](const Linkage& linkage, const std::vector<Pair>& points, const std::vector<double>& input_deg,
              bool closed, bool absolute, const std::optional<Pair>& point) {
             return without_gil([&] { return comparison(linkage, points, input_deg, closed, absolute, point); });
           })
      .def("pose_comparison",
           [](const Linkage& linkage, const std::vector<std::array<double, 3>>& poses,
              const std::optional<std::array<double, 3>>& body, const std::optional<double>& turning_length) {
             return without_gil([&] { return pose_comparison(linkage, poses, body, turning_length); });
           })
      .def("instant", [](const Linkage& linkage, const std::optional<Pair>& point, std::optional<double> input_deg,
                         double input_acceleration) {
        return without_gil([&] { return instant(linkage, point, input_deg, input_acceleration); });
      });
  module.def("linkages_of_result", [](const std::string& text) {
    return without_gil([&] { return numbered(value_of(read_any_result_linkages(text))); });
  });
  module.def("machine_formats",
             [] { return std::vector<std::string>(machine_formats().begin(), machine_formats().end()); });
  module.def("instant_of_problem", &instant_of_problem);
  module.def("tolerance", [](const std::string& result, int linkage, std::optional<double> length,
                             std::optional<int> samples, std::optional<std::int64_t> seed) {
    return without_gil([&] { return tolerance(result, linkage, length, samples, seed); });
  });
  module.def("place_spring", &place_spring);
  module.def("loads", [](const std::string& result, int linkage, const std::optional<std::string>& of_case,
                         const std::optional<double>& free_share) {
    return without_gil([&] { return loads(result, linkage, of_case, free_share); });
  });
}

}  // namespace linkwright::python
