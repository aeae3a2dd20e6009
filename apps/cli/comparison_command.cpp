#include <algorithm>
#include <cctype>
#include <filesystem>
#include <variant>

#include "commands.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/outline_file.hpp"
#include "linkwright/files/point_table.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "report.hpp"

// analyze --compare: a path and points, a body and poses.
namespace linkwright::cli {
namespace {

using Compared = std::variant<ComparedPath, NearPoses>;

template <class Found>
Result<Compared> compared(const Result<Found>& found) {
  if (!found) return found.errors();
  return Compared(*found);
}

Result<Compared> task_to_compare(const std::string& file) {
  const auto problem = read_problem_file(file);
  if (!problem) return problem.errors();
  if (const auto* path = std::get_if<PathTask>(&problem->task)) return compared(compared_path(*path));
  if (const auto* motion = std::get_if<MotionTask>(&problem->task)) return compared(compared_poses(*motion));
  if (const auto* six_bar = std::get_if<SixBarTask>(&problem->task)) {
    MotionTask motion;
    motion.poses = six_bar->poses;
    return compared(compared_poses(motion));
  }
  return Error{"nothing_to_compare", "task",
               "this task has neither a path nor poses in the plane that a four-bar could be compared with; give a "
               "task of kind \"path\" or \"motion\", a table of points or poses, or a drawing"};
}

/// Of a drawing its first shape, as `outline` lays a path along it.
Result<Compared> shape_to_compare(const Result<Drawing>& drawing, bool closed, const std::string& length_unit) {
  if (!drawing) return drawing.errors();
  constexpr int usual_points = 48;
  const DrawnShape& shape = drawing->shapes.front();
  std::vector<Point> points = drawing->listed ? shape.corners : points_along(shape, usual_points);
  const double scale = drawing_scale(drawing->unit_mm, length_unit);
  for (Point& point : points) point *= scale;
  return compared(compared_path(points, shape.closed || closed));
}

Result<Compared> table_to_compare(const AnalyzeArguments& arguments, const std::string& length_unit) {
  const auto text = read_text_file(arguments.compared, max_drawing_bytes);
  if (!text) return text.errors();
  if (is_pose_table(*text)) {
    const auto poses = read_pose_table(*text);
    return poses ? compared(compared_poses(*poses)) : Result<Compared>(poses.errors());
  }
  auto points = read_point_table(*text);
  if (!points) return points.errors();
  return shape_to_compare(drawing_of_points(*std::move(points)), arguments.closed, length_unit);
}

Result<Compared> what_to_compare(const AnalyzeArguments& arguments, const std::string& length_unit) {
  const std::string& file = arguments.compared;
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".json") return task_to_compare(file);
  if (ending == ".csv") return table_to_compare(arguments, length_unit);
  return shape_to_compare(read_outlines_file(file), arguments.closed, length_unit);
}

/// Flags that do not go with what is compared.
std::optional<Error> wrong_flag(const AnalyzeArguments& arguments, const Compared& with) {
  const bool is_path = std::holds_alternative<ComparedPath>(with);
  if (is_path && !arguments.body.empty())
    return Error{"body_of_a_path", "--body",
                 "a body is compared with poses, and these are points; leave this flag out"};
  if (is_path) return std::nullopt;
  if (!arguments.point.empty())
    return Error{"point_of_poses", "--point",
                 "a body is compared with these poses; leave this flag out, or give --body"};
  if (arguments.closed)
    return Error{"closed_poses", "--closed", "these are poses, not points of a path; leave this flag out"};
  return std::nullopt;
}

Result<LinkageAnalysis> comparison_of(const StoredLinkage& linkage, const AnalyzeArguments& arguments,
                                      const Compared& with) {
  if (const auto wrong = wrong_flag(arguments, with)) return *wrong;
  LinkageAnalysis analysis = linkwright::analyze(linkage);
  if (const auto* path = std::get_if<ComparedPath>(&with)) {
    std::optional<Point> point;
    if (!arguments.point.empty()) point = Point{arguments.point[0], arguments.point[1]};
    auto found = compare_with_path(linkage, point, *path);
    if (!found) return found.errors();
    analysis.comparison = *std::move(found);
    return analysis;
  }
  std::optional<Pose> body;
  if (!arguments.body.empty()) body = Pose{{arguments.body[0], arguments.body[1]}, radians(arguments.body[2])};
  auto found = compare_with_poses(linkage, body, std::get<NearPoses>(with));
  if (!found) return found.errors();
  analysis.pose_comparison = *std::move(found);
  return analysis;
}

// What is compared, told in one of the ways there are for either.
template <class Tell>
std::string told(const LinkageAnalysis& analysis, const Tell& tell) {
  if (analysis.comparison) return tell(*analysis.comparison);
  return analysis.pose_comparison ? tell(*analysis.pose_comparison) : "";
}

bool write_comparison(const AnalyzeArguments& arguments, const LinkageAnalysis& analysis) {
  const bool as_table = arguments.report.ends_with(".csv");
  return write_output(arguments.report, [&](const TextSink& sink) {
    sink(as_table ? told(analysis, [](const auto& of) { return comparison_table(of); }) : write_analysis(analysis));
  });
}

bool draw_compared(const AnalyzeArguments& arguments, const LinkageAnalysis& analysis) {
  return write_output(arguments.picture, [&](const TextSink& sink) {
    sink(told(analysis, [&](const auto& of) { return draw_comparison(analysis.linkage, of); }));
  });
}

}  // namespace

int compare(const StoredLinkage& linkage, const AnalyzeArguments& arguments) {
  const auto with = what_to_compare(arguments, linkage.length_unit);
  if (!with) {
    print_mistakes(arguments.compared, with.errors());
    return mistake;
  }
  const auto analysis = comparison_of(linkage, arguments, *with);
  if (!analysis) {
    print_mistakes(arguments.linkage, analysis.errors());
    return mistake;
  }
  if (!arguments.report.empty() && !write_comparison(arguments, *analysis)) return failure;
  if (!arguments.picture.empty() && !draw_compared(arguments, *analysis)) return failure;
  const std::string text = linkage_words(*analysis, arguments.drive) +
                           told(*analysis, [&](const auto& of) { return comparison_words(of, linkage.length_unit); });
  return arguments.report == "-" || print_answer(text) ? 0 : failure;
}

}  // namespace linkwright::cli
