#include "task_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "curve_path.hpp"
#include "drawing/four_bar/linkage_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/task_label.hpp"
#include "linkwright/planar/path_crank.hpp"
#include "palette.hpp"
#include "planar/function_couplers.hpp"
#include "planar/function_family.hpp"

namespace linkwright {
namespace {

/// Grounded links between the last one of an arc of directions and the arc's end, half a step on, where two sheets
/// meet: closer and closer, as the pivots run faster and faster.
void add_end_of_arc(std::vector<Dyad>& links, const FourBarFamily& family, Side side, double last, double half_step) {
  constexpr int looks = 9;
  for (int k = 1; k <= looks; ++k)
    if (const auto dyad = family.dyad(side, last + half_step * (1 - std::pow(0.5, k)))) links.push_back(*dyad);
}

/// The family's polygon with the ends of its arcs.
std::vector<Dyad> with_ends(const std::vector<Dyad>& polygon, const FourBarFamily& family, Side side) {
  double step = 1;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    step = std::min(step, std::abs(polygon[i + 1].coordinate - polygon[i].coordinate));
  const auto follows = [&](std::size_t i) {
    return i > 0 && i < polygon.size() && polygon[i].coordinate - polygon[i - 1].coordinate < 1.5 * step &&
           std::floor(polygon[i].coordinate) == std::floor(polygon[i - 1].coordinate);
  };
  std::vector<Dyad> links;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!follows(i)) {
      std::vector<Dyad> before;
      add_end_of_arc(before, family, side, polygon[i].coordinate, -step / 2);
      links.insert(links.end(), before.rbegin(), before.rend());
    }
    links.push_back(polygon[i]);
    if (!follows(i + 1)) add_end_of_arc(links, family, side, polygon[i].coordinate, step / 2);
  }
  return links;
}

/// So many that curves look smooth in the picture, however fast the pivots run.
std::vector<Dyad> fine_polygon(const FourBarFamily& family, Side side) {
  constexpr int corners_of_a_branch = 4096;
  const int corners = corners_of_a_branch * static_cast<int>(family.axis(side).branches.size());
  std::vector<Dyad> polygon;
  for (const double tau : family.samples(side, corners, Spacing::coordinate))
    if (const auto dyad = family.dyad(side, tau)) polygon.push_back(*dyad);
  return with_ends(polygon, family, side);
}

std::vector<Dyad> links_along(const FourBarFamily& family, Side side) {
  std::vector<Dyad> polygon = fine_polygon(family, side);
  if (polygon.empty()) polygon = family.polygon(side);  // its dyads depend on the other link
  for (Dyad& dyad : polygon) {
    const double coordinate = dyad.coordinate;
    dyad = family.frame().to_user(dyad);
    dyad.coordinate = coordinate;
  }
  return polygon;
}

/// The nearest that keeps away from dead points, or the nearest.
const RelaxedPosition* way_to_show(const MotionAnswer& answer) {
  constexpr double least_angle = radians(10);
  const RelaxedPosition* nearest = nullptr;
  for (const RelaxedPosition& way : answer.relaxed) {
    if (!way.linkage) continue;
    if (way.linkage->report.min_transmission_angle > least_angle) return &way;
    if (nearest == nullptr) nearest = &way;
  }
  return nearest;
}

/// What the window must hold: the poses with their arms' room, and the linkage in all its positions. `size`: of what
/// there is to see about a single pose.
std::vector<Point> points_of_interest(const TaskScene& scene, double size) {
  std::vector<Point> points;
  for (const PrescribedPose& pose : scene.frames) points.push_back(pose.pose.origin);
  if (scene.linkage == nullptr && points.size() == 1) points = {points[0] - size, points[0] + size};
  if (scene.linkage == nullptr) {
    if (scene.function) points = {scene.function->input_pivot, scene.function->output_pivot};
    return points;
  }
  const FourBar& best = scene.linkage->four_bar;
  for (std::size_t pose = 0; pose < scene.served.size(); ++pose) {
    const FourBar bars = in_pose(best, scene.served, pose);
    points.insert(points.end(), {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving});
  }
  if (scene.traced)
    for (const Point p : path_of_task(best, scene.served, *scene.traced)) points.push_back(p);
  if (scene.function)
    for (const Point p : angle_scale_points(best, *scene.function)) points.push_back(p);
  return points;
}

/// The body in a pose.
std::vector<Point> placed_outline(const Problem& problem, const Pose& pose) {
  std::vector<Point> corners;
  for (const Point corner : problem.outline) corners.push_back(displaced(corner, Pose{}, pose));
  return corners;
}

void draw_outlines(SvgCanvas& svg, const TaskScene& scene, const Problem& problem, const PlaneWindow& window) {
  if (problem.outline.empty()) return;
  for (std::size_t pose = scene.frames.size(); pose-- > 0;) {
    std::vector<Point> corners = placed_outline(problem, scene.frames[pose].pose);
    for (Point& corner : corners) corner = window.to_px(corner);
    svg.polygon(corners,
                fill(palette::accent, pose == 0 ? 0.1 : 0.05) + " " + stroke(palette::accent, pose == 0 ? 1.3 : 0.8));
  }
}

/// Beads that do not make all else small.
void add_near_beads(std::vector<Point>& points, const TaskScene& scene, const WorkingFrame& frame) {
  constexpr double reach = 2;  // of what else there is to see
  if (points.empty()) return;
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
    high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
  }
  const Point middle = (low + high) / 2.0;
  const double farthest = reach * std::max(std::abs(high - low), frame.scale) / 2;
  for (const Dyad& bead : scene.beads)
    for (const Point p : finite_pivots(bead, frame))
      if (std::abs(p - middle) <= farthest) points.push_back(p);
}

/// Without a linkage the poses alone leave no room to see the curves.
double window_margin(const TaskScene& scene) {
  if (scene.linkage != nullptr) return 76;
  return scene.beads.empty() ? 170 : 100;
}

void draw_paths(SvgCanvas& svg, const CurvePaths& paths, std::string_view color, double width) {
  for (const auto& path : paths.centers) svg.polyline(path, stroke(color, width));
  for (const auto& path : paths.circles) svg.polyline(path, stroke(color, width, "5 4"));
}

void draw_curves(SvgCanvas& svg, const TaskScene& scene, const PlaneWindow& window) {
  if (scene.curve) draw_paths(svg, visible_curves(*scene.curve, scene.curve_frame, window), palette::curve, 1.5);
  draw_paths(svg, visible_polygon(scene.input_links, window), palette::input, 1.1);
  draw_paths(svg, visible_polygon(scene.output_links, window), palette::output, 1.1);
}

void draw_motion(SvgCanvas& svg, const TaskScene& scene, const PlaneWindow& window) {
  const FourBar& best = scene.linkage->four_bar;
  if (scene.traced) draw_traced_path(svg, window, path_of_cycle(best, *scene.traced), false);
  for (std::size_t pose = scene.served.size(); --pose > 0;) draw_ghost(svg, window, in_pose(best, scene.served, pose));
  if (!scene.traced) return;
  draw_traced_path(svg, window, path_of_task(best, scene.served, *scene.traced), true);
  draw_body(svg, window, best, *scene.traced);
}

void draw_frames(SvgCanvas& svg, const TaskScene& scene, const PlaneWindow& window) {
  for (std::size_t pose = scene.frames.size(); pose-- > 0;) {
    draw_direction(svg, window, scene.frames[pose]);
    if (scene.of_point)
      draw_place(svg, window, scene.frames[pose].pose.origin, pose + 1, pose == 0);
    else
      draw_pose(svg, window, scene.frames[pose].pose, pose + 1, pose == 0);
  }
}

/// The keys of the lines, as far right as they fit.
class Keys {
 public:
  Keys(SvgCanvas& svg, const PixelBox& card) : svg_(svg), card_(card) {}

  void line(std::string attributes, std::string_view name) {
    entries_.push_back({std::move(attributes), std::string(name)});
    width_ += line_key_width(name);
  }
  void beads() {
    has_beads_ = true;
    width_ += bead_key_width();
  }
  /// From `left` on, or with nothing to spare at the right.
  void draw(std::optional<double> left) const {
    const double y = card_.top + 24;
    double x = left.value_or(card_.right() - width_);
    if (has_beads_) x = draw_bead_key(svg_, {x, y});
    for (const Entry& entry : entries_) x = draw_line_key(svg_, {x, y}, entry.attributes, entry.name);
  }

 private:
  struct Entry {
    std::string attributes, name;
  };
  SvgCanvas& svg_;
  PixelBox card_;
  std::vector<Entry> entries_;
  bool has_beads_ = false;
  double width_ = 0;
};

void draw_keys(SvgCanvas& svg, const TaskScene& scene, const PixelBox& card) {
  const std::string dotted = stroke(palette::accent, 2, "0.1 4.5") + " stroke-linecap=\"round\"";
  const bool of_couplers = scene.function.has_value();
  Keys keys(svg, card);
  if (!scene.beads.empty()) keys.beads();
  if (scene.curve) {
    keys.line(stroke(palette::curve, 1.5), of_couplers ? "output's moving pivot" : "centre-point curve");
    keys.line(stroke(palette::curve, 1.5, "5 4"), of_couplers ? "input's moving pivot" : "circle-point curve");
  } else if (!scene.input_links.empty()) {
    keys.line(stroke(palette::ink2, 1.2), "fixed pivots");
    keys.line(stroke(palette::ink2, 1.2, "5 4"), "moving pivots, position 1");
  }
  if (scene.traced) keys.line(dotted, scene.of_point ? "path of the point" : "path of the frame's origin");
  const bool are_usual = scene.curve && !of_couplers && scene.linkage != nullptr;
  keys.draw(are_usual ? std::optional(card.left + 190) : std::nullopt);
}

TaskScene scene_of_best(const FourBarAnswer& answer, const Task& task) {
  TaskScene scene;
  scene.curve = answer.given.curve;
  scene.curve_frame = answer.given.frame();
  if (!answer.linkages.empty()) scene.linkage = &answer.linkages.front();
  scene.heading = scene.linkage != nullptr ? "Best linkage" : "The " + short_task_label(task);
  return scene;
}

}  // namespace

TaskScene task_scene(const MotionAnswer& answer) {
  const MotionTask& task = answer.task;
  TaskScene scene = scene_of_best(answer, task);
  scene.frames = all_poses(task);
  const TaskFamily& given = answer.given;
  if (!given.curve)
    for (const BurmesterPoint& point : given.points) scene.beads.push_back(given.frame().to_user(point.dyad));
  if (given.family && !given.curve && given.points.empty()) {
    scene.input_links = links_along(*given.family, Side::input);
    if (!given.family->is_symmetric()) scene.output_links = links_along(*given.family, Side::output);
  }
  if (scene.linkage != nullptr && given.near) {
    scene.served = given.family->user_poses(answer.point_of(answer.linkages.front()), scene.linkage->four_bar);
  } else if (scene.linkage != nullptr) {
    scene.served = task.relaxed ? relaxed_task(task, *task.relaxed).task.poses : task.poses;
  } else if (const RelaxedPosition* way_out = way_to_show(answer); way_out != nullptr && way_out->linkage) {
    scene.linkage = &*way_out->linkage;
    scene.served = relaxed_task(task, way_out->pose).task.poses;
    scene.heading = fmt::format("Alternative: without position {}", way_out->pose + 1);
  }
  if (!scene.served.empty()) scene.traced = scene.served.front().pose.origin;
  return scene;
}

TaskScene task_scene(const FunctionAnswer& answer) {
  TaskScene scene = scene_of_best(answer, answer.task);
  const auto& family = answer.given.functions;
  if (!family) return scene;
  if (scene.linkage == nullptr && !answer.pairs.empty()) {
    scene.linkage = &answer.pairs.front();
    scene.heading = "The linkage through all pairs, which has a defect";
  }
  scene.function = scene.linkage ? family->task_at(answer.point_of(*scene.linkage)) : answer.task;
  if (scene.linkage != nullptr)
    scene.served = family->user_poses(answer.point_of(*scene.linkage), scene.linkage->four_bar);
  if (!answer.task.free) return scene;
  const FunctionCouplers couplers = function_couplers(*scene.function);
  scene.curve = couplers.curve;
  scene.curve_frame = couplers.frame();
  return scene;
}

// The cranks along their curve, or the few there are; the poses are those of the point alone.
TaskScene task_scene(const PathAnswer& answer) {
  TaskScene scene = scene_of_best(answer, answer.task);
  scene.curve = nullptr;
  scene.of_point = true;
  for (const PathPoint& point : answer.task.points) {
    scene.frames.push_back({{point.point, 0}, {}});
    for (const PathDerivative& d : point.derivatives) scene.frames.back().derivatives.push_back({d.point, 0});
  }
  const TaskFamily& given = answer.given;
  if (!given.curve)
    for (const BurmesterPoint& crank : given.points)
      scene.beads.push_back(given.frame().to_user(crank_link(crank.dyad)));
  if (given.family && given.curve) scene.input_links = links_along(*given.family, Side::input);
  if (scene.linkage == nullptr) return scene;
  scene.served = given.family->user_poses(answer.point_of(*scene.linkage), scene.linkage->four_bar);
  scene.traced = scene.served.front().pose.origin;
  return scene;
}

void draw_task_scene(SvgCanvas& svg, const TaskScene& scene, const Problem& problem, const FourBarAnswer& answer,
                     const PixelBox& card) {
  draw_card(svg, card, scene.heading);
  const PixelBox box{card.left + 1, card.top + 44, card.width - 2, card.height - 45};
  const WorkingFrame& frame = answer.given.frame();
  std::vector<Point> points = points_of_interest(scene, frame.scale);
  add_near_beads(points, scene, frame);
  for (const PrescribedPose& pose : scene.frames)
    for (const Point corner : placed_outline(problem, pose.pose)) points.push_back(corner);
  const PlaneWindow window(box, points, window_margin(scene));
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_grid(svg, window);
  const Requirements& requirements = answer.requirements;
  if (requirements.ground_pivots_within) draw_box(svg, window, *requirements.ground_pivots_within, "fixed pivots");
  if (requirements.moving_pivots_within) draw_box(svg, window, *requirements.moving_pivots_within, "moving pivots");
  draw_outlines(svg, scene, problem, window);
  draw_curves(svg, scene, window);
  draw_bead_links(svg, window, frame, scene.beads);
  if (scene.linkage != nullptr) draw_motion(svg, scene, window);
  if (scene.linkage != nullptr) draw_bars(svg, window, scene.linkage->four_bar);
  if (scene.linkage != nullptr && scene.function)
    draw_angle_scales(svg, window, scene.linkage->four_bar, *scene.function);
  draw_frames(svg, scene, window);
  std::vector<Point> origins;
  for (const PrescribedPose& pose : scene.frames) origins.push_back(window.to_px(pose.pose.origin));
  draw_beads(svg, window, frame, scene.beads, std::move(origins));
  if (scene.linkage != nullptr) draw_pins(svg, window, scene.linkage->four_bar);
  draw_scale_bar(svg, window, {box.left + 22, box.bottom() - 20}, problem.length_unit);
  svg.end_group();
  draw_keys(svg, scene, card);
}

}  // namespace linkwright
