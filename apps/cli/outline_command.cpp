#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "commands.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/outline_file.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright::cli {
namespace {

constexpr int usual_points = 48;  // along a path

/// About how large a body is beside the way that it goes.
double usual_size(std::span<const PrescribedPose> poses) {
  double left = poses[0].pose.origin.real(), right = left, bottom = poses[0].pose.origin.imag(), top = bottom;
  for (const PrescribedPose& pose : poses) {
    left = std::min(left, pose.pose.origin.real());
    right = std::max(right, pose.pose.origin.real());
    bottom = std::min(bottom, pose.pose.origin.imag());
    top = std::max(top, pose.pose.origin.imag());
  }
  const double diagonal = std::hypot(right - left, top - bottom);
  return 0.3 * (diagonal > 0 ? diagonal : 1);
}

/// What is wrong with the flags, the drawing's shapes known.
std::vector<Error> mistakes_in(const OutlineArguments& arguments, const Drawing& drawing, bool is_path) {
  std::vector<Error> mistakes;
  const std::size_t shapes = drawing.shapes.size();
  if (arguments.shape < 1 || static_cast<std::size_t>(arguments.shape) > shapes)
    mistakes.push_back({"no_such_shape", "--shape",
                        fmt::format("there is no shape {}; this drawing has 1 to {}", arguments.shape, shapes)});
  if (!arguments.unit.empty() && !millimetres(arguments.unit))
    mistakes.push_back(
        {"unknown_unit", "--unit",
         fmt::format("\"{}\" is no unit of length; give µm, mm, cm, dm, m, in or ft, or say --scale", arguments.unit)});
  if (arguments.scale && !(*arguments.scale > 0 && *arguments.scale <= 1e12))
    mistakes.push_back({"scale_range", "--scale", "a scale is larger than 0 and 1e12 at most"});
  for (const double value : arguments.at)
    if (!(std::abs(value) <= 1e12)) {
      mistakes.push_back({"place_range", "--at", "the drawing's place is finite numbers x,y,degrees of 1e12 at most"});
      break;
    }
  const bool as_listed = is_path && drawing.listed && !arguments.points;
  if (as_listed && drawing.shapes.front().corners.size() > PathTask::most_points)
    mistakes.push_back({"path_point_range", "--points",
                        fmt::format("the table has {} points, and a path is laid along 3 to {}; say how many",
                                    drawing.shapes.front().corners.size(), PathTask::most_points)});
  const int points = arguments.points.value_or(usual_points);
  if (points < 3 || static_cast<std::size_t>(points) > PathTask::most_points)
    mistakes.push_back(
        {"path_point_range", "--points", fmt::format("a path is laid along 3 to {} points", PathTask::most_points)});
  return mistakes;
}

/// To a billionth of a size, as somebody would write it.
Point rounded(Point p, double size) {
  const double unit = std::pow(10, std::floor(std::log10(size)) - 9);
  const auto short_of = [&](double value) {
    return std::stod(fmt::format("{:.12g}", std::round(value / unit) * unit)) + 0.0;
  };
  return {short_of(p.real()), short_of(p.imag())};
}

/// Lengths of the problem to the drawing's unit.
double scale_of(const OutlineArguments& arguments, const Drawing& drawing, const std::string& length_unit) {
  if (arguments.scale) return *arguments.scale;
  return drawing_scale(arguments.unit.empty() ? drawing.unit_mm : millimetres(arguments.unit), length_unit);
}

OutlineFit fit_of(const OutlineArguments& arguments, const DrawnShape& shape, double scale, double size) {
  OutlineFit fit = fit_outline(shape, scale, size);
  if (arguments.scale && fit.resized) {
    fit.placed.origin *= scale / fit.scale;
    fit.scale = scale;
    fit.resized = false;
  }
  if (!arguments.at.empty()) fit.placed = {{arguments.at[0], arguments.at[1]}, radians(arguments.at[2])};
  return fit;
}

std::string size_text(const DrawnShape& shape, double scale, const std::string& unit) {
  return fmt::format("{} × {}{}{}", significant_text(scale * shape.width, 4), significant_text(scale * shape.height, 4),
                     unit.empty() ? "" : " ", unit);
}

std::string shapes_text(const OutlineArguments& arguments, const Drawing& drawing, double scale,
                        const std::string& unit) {
  std::string text;
  for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
    const DrawnShape& shape = drawing.shapes[i];
    const bool is_taken = i + 1 == static_cast<std::size_t>(arguments.shape);
    text += fmt::format("{} shape {}: {}, {}\n", is_taken ? "*" : " ", i + 1, size_text(shape, scale, unit),
                        shape.frame    ? "frame of the sheet"
                        : shape.closed ? "closed"
                                       : "open");
  }
  return text;
}

std::string answer_of(const OutlineArguments& arguments, const Drawing& drawing, const OutlineFit& fit,
                      const Problem& problem) {
  std::string text = shapes_text(arguments, drawing, fit.scale, problem.length_unit) +
                     fmt::format("Outline of {} corners from {}", problem.outline.size(), arguments.drawing);
  if (fit.resized)
    text += fmt::format(", brought to the size of the task by the scale {} (--scale sets another)",
                        significant_text(fit.scale, 4));
  return text + "\n";
}

/// The points of a table as they are, unless a number is asked for; of a shape evenly along it.
std::vector<PathPoint> path_points(const OutlineArguments& arguments, const Drawing& drawing, double scale,
                                   const Pose& placed) {
  const DrawnShape& shape = drawing.shapes[static_cast<std::size_t>(arguments.shape - 1)];
  const double size = std::max(shape.width, shape.height);
  std::vector<PathPoint> points;
  for (const Point drawn : drawing.listed && !arguments.points
                               ? shape.corners
                               : points_along(shape, arguments.points.value_or(usual_points)))
    points.push_back(
        {rounded(placed.origin + std::polar(scale, placed.angle) * drawn, scale * size), {}, {}, {}, {}, {}});
  return points;
}

/// The shape as the path that the task is to pass near, in the fixed frame.
int path_of_drawing(const OutlineArguments& arguments, const Drawing& drawing, Problem problem, PathTask path) {
  const DrawnShape& shape = drawing.shapes[static_cast<std::size_t>(arguments.shape - 1)];
  const double scale = scale_of(arguments, drawing, problem.length_unit);
  Pose placed;
  if (!arguments.at.empty()) placed = {{arguments.at[0], arguments.at[1]}, radians(arguments.at[2])};
  path.points = path_points(arguments, drawing, scale, placed);
  const std::size_t count = path.points.size();
  path.pivots = {};
  path.closed = shape.closed;
  if (!path.is_approximate()) path.between = PathBetween::free;
  problem.task = std::move(path);
  if (!write_output(arguments.output, [&](const TextSink& sink) { sink(write_problem(problem)); })) return failure;
  if (arguments.output == "-") return 0;
  const std::string text =
      shapes_text(arguments, drawing, scale, problem.length_unit) +
      fmt::format("{} path near {} points along {}\n", shape.closed ? "Closed" : "Open", count, arguments.drawing);
  return print_answer(text) ? 0 : failure;
}

}  // namespace

int outline(const OutlineArguments& arguments) {
  const Interruption interruption(Interruption::Answer::at_once);
  auto problem = read_problem_file(arguments.problem);
  if (!problem) {
    print_mistakes(arguments.problem == "-" ? "standard input" : arguments.problem, problem.errors());
    return mistake;
  }
  const std::span<const PrescribedPose> poses = guided_poses(problem->task);
  const auto* path = std::get_if<PathTask>(&problem->task);
  if (poses.empty() && path == nullptr) {
    print_mistakes(arguments.problem, {{"no_body", "task",
                                        "this task guides no body in the plane, so none can have an outline, and no "
                                        "point along a path"}});
    return mistake;
  }
  const auto drawing = read_outlines_file(arguments.drawing);
  const auto mistakes = drawing ? mistakes_in(arguments, *drawing, path != nullptr) : drawing.errors();
  if (!mistakes.empty()) {
    print_mistakes(arguments.drawing, mistakes);
    return mistake;
  }
  if (path != nullptr) return path_of_drawing(arguments, *drawing, *problem, *path);
  const DrawnShape& shape = drawing->shapes[static_cast<std::size_t>(arguments.shape - 1)];
  const OutlineFit fit =
      fit_of(arguments, shape, scale_of(arguments, *drawing, problem->length_unit), usual_size(poses));
  problem->outline = body_outline(shape, fit.scale, fit.placed);
  if (!write_output(arguments.output, [&](const TextSink& sink) { sink(write_problem(*problem)); })) return failure;
  if (arguments.output == "-") return 0;
  return print_answer(answer_of(arguments, *drawing, fit, *problem)) ? 0 : failure;
}

}  // namespace linkwright::cli
