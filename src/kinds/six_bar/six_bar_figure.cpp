#include "six_bar_figure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/point_marks.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

using HingePoints = SixBarScene::Hinges;

constexpr double path_step = radians(0.5);

std::vector<Point> origins(const SixBarMotion& motion) {
  std::vector<Point> path;
  for (const SixBarMotionState& state : motion.states) path.push_back(state.place.body.origin);
  return path;
}

void add_paths(SixBarScene& scene, const std::vector<PrescribedPose>& framed) {
  if (framed.size() > 1) scene.path = origins(travel_through(scene.six_bar, framed, path_step));
  scene.whole_path = origins(six_bar_motion(scene.six_bar, framed, path_step));
}

/// The turns of all bodies in pose j, from where bodies 0 … 3 are; nothing where links 4 and 5 do not fit.
std::optional<SixBarTurns> turns_in_pose(const StoredSixBar& linkage, const std::array<BodyPositions, 4>& bodies,
                                         std::size_t j) {
  SixBarTurns turns{1, 1, 1, 1, 1, 1};
  for (std::size_t body = 1; body < bodies.size(); ++body) turns[body] = bodies[body].at[j].turn;
  const SixBar& bars = linkage.six_bar;
  const auto moved = [&](SixBar::JointIndex joint, int body) -> Point {
    if (body < 4) return bodies[static_cast<std::size_t>(body)].moved(bars.at(joint), j);
    const auto carrier = static_cast<std::size_t>(linkage.row.added[0].a);  // of link 4's first hinge
    return bodies[carrier].moved(bars.at(SixBar::c4), j) + turns[4] * (bars.at(joint) - bars.at(SixBar::c4));
  };
  const auto turn_of = [&](SixBar::JointIndex c, SixBar::JointIndex z, BodyPair between) {
    const Point turn = (moved(z, between.b) - moved(c, between.a)) / (bars.at(z) - bars.at(c));
    return std::abs(turn) > 0 ? turn / std::abs(turn) : Point{1, 0};
  };
  turns[4] = turn_of(SixBar::c4, SixBar::z4, linkage.row.added[0]);
  turns[5] = turn_of(SixBar::c5, SixBar::z5, linkage.row.added[1]);
  return closure_error(bars, turns) < tolerance::links_fit ? std::optional(turns) : std::nullopt;
}

std::vector<Point> body_corners(const SixBar& six_bar, const HingePoints& hinges, int body) {
  std::vector<Point> corners;
  for (const std::size_t joint : six_bar.joints_of(body)) corners.push_back(hinges[joint]);
  return corners;
}

std::vector<Point> to_px(const PlaneWindow& window, std::vector<Point> points) {
  for (Point& point : points) point = window.to_px(point);
  return points;
}

HingePoints hinges_of(const SixBar& six_bar) {
  HingePoints hinges{};
  for (std::size_t joint = 0; joint < hinges.size(); ++joint) hinges[joint] = six_bar.joints[joint].point;
  return hinges;
}

/// All bodies but the ground as thin outlines.
void draw_outlines(SvgCanvas& svg, const PlaneWindow& window, const SixBar& six_bar, const HingePoints& hinges) {
  svg.begin_group("stroke-opacity=\"0.45\" stroke-linejoin=\"round\" stroke-linecap=\"round\" fill=\"none\"");
  for (int body = 1; body < SixBar::bodies; ++body) {
    const std::vector<Point> corners = to_px(window, body_corners(six_bar, hinges, body));
    corners.size() > 2 ? svg.polygon(corners, stroke(body_color(body), 1.2))
                       : svg.line(corners[0], corners[1], stroke(body_color(body), 1.2));
  }
  svg.end_group();
}

void draw_ground(SvgCanvas& svg, const PlaneWindow& window, const SixBar& six_bar, const HingePoints& hinges) {
  std::vector<Point> corners = to_px(window, body_corners(six_bar, hinges, 0));
  for (const Point corner : corners) draw_ground_symbol(svg, corner);
  if (corners.size() > 2) corners.push_back(corners.front());
  svg.polyline(corners, stroke(palette::ink3, 1, "9 3 2 3"));
}

/// The guided body reaches to the frame that it carries.
void draw_carried_frame(SvgCanvas& svg, const PlaneWindow& window, const SixBarScene& scene) {
  if (scene.poses.empty()) return;
  std::vector<Point> corners = body_corners(scene.six_bar, hinges_of(scene.six_bar), SixBar::guided);
  const Point origin = scene.poses.front().pose.origin;
  if (corners.size() == 2) {
    corners.push_back(origin);
  } else {
    corners = {corners[0], origin, corners[1]};
  }
  svg.polygon(to_px(window, corners), fill(palette::body, 0.1) + " " + stroke(palette::body, 1.2) +
                                          " stroke-opacity=\"0.6\" stroke-linejoin=\"round\"");
}

void draw_bodies(SvgCanvas& svg, const PlaneWindow& window, const SixBar& six_bar, const HingePoints& hinges) {
  for (const int body : {5, 4, 3, 2, 1}) {
    const std::vector<Point> corners = to_px(window, body_corners(six_bar, hinges, body));
    if (corners.size() == 2) {
      draw_link(svg, corners[0], corners[1], body_color(body));
      continue;
    }
    svg.polygon(corners,
                fill(body_color(body), 0.28) + " " + stroke(body_color(body), 3.5) + " stroke-linejoin=\"round\"");
  }
}

/// A hinge has the colour of the added link that it belongs to, else of the later body of the chain.
std::string_view pin_color(const SixBarJoint& joint) { return body_color(std::max(joint.bodies[0], joint.bodies[1])); }

/// Points along the outlines of the bodies, on the poses' frames and on the ground's symbols (px).
std::vector<Point> obstacles(const PlaneWindow& window, const SixBarScene& scene, const HingePoints& hinges) {
  constexpr int points_a_side = 12;
  constexpr Point ground_symbol{0, 16};
  std::vector<Point> found;
  for (int body = 0; body < SixBar::bodies; ++body) {
    const std::vector<Point> corners = to_px(window, body_corners(scene.six_bar, hinges, body));
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int k = 0; k < points_a_side; ++k)
        found.push_back(corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) * (1.0 * k / points_a_side));
  }
  for (const SixBarJoint& joint : scene.six_bar.joints)
    if (is_on_ground(joint)) found.push_back(window.to_px(joint.point) + ground_symbol);
  for (const PrescribedPose& pose : scene.poses)
    for (const double along : {0.0, 15.0, 30.0, 45.0})
      found.push_back(window.to_px(pose.pose.origin) + along * std::conj(direction(pose.pose.angle)));
  return found;
}

}  // namespace

SixBarScene scene_of(const SixBarSolution& found, const std::vector<PrescribedPose>& poses) {
  SixBarScene scene{found.member.six_bar, poses, {}, {}, {}};
  for (std::size_t j = 1; j < found.member.turns.size(); ++j)
    scene.positions.push_back(joints_at(found.member.six_bar, found.member.turns[j]));
  add_paths(scene, poses);
  return scene;
}

SixBarScene scene_of(const StoredSixBar& linkage) {
  SixBarScene scene{linkage.six_bar, linkage.poses, {}, {}, {}};
  const SixBar& bars = linkage.six_bar;
  if (linkage.poses.size() == 4) {
    const ThreeLinkChain chain{bars.at(SixBar::a), bars.at(SixBar::b), bars.at(SixBar::d), linkage.assembly_mode};
    const auto bodies = chain_positions(linkage.poses, chain);
    for (std::size_t j = 1; bodies && j < linkage.poses.size(); ++j)
      if (const auto turns = turns_in_pose(linkage, *bodies, j)) scene.positions.push_back(joints_at(bars, *turns));
  }
  add_paths(scene, framed_poses(linkage));
  return scene;
}

std::vector<Point> points_of_interest(const SixBarScene& scene) {
  std::vector<Point> points;
  for (const SixBarJoint& joint : scene.six_bar.joints) points.push_back(joint.point);
  for (const PrescribedPose& pose : scene.poses) points.push_back(pose.pose.origin);
  for (const HingePoints& hinges : scene.positions) points.insert(points.end(), hinges.begin(), hinges.end());
  const std::vector<Point>& path = scene.path.empty() ? scene.whole_path : scene.path;
  points.insert(points.end(), path.begin(), path.end());
  return points;
}

std::string_view body_color(int body) {
  constexpr std::array<std::string_view, SixBar::bodies> colors = {palette::ink3, palette::input,  palette::link_2,
                                                                   palette::body, palette::output, palette::link_5};
  return colors.at(static_cast<std::size_t>(body));
}

void draw_six_bar(SvgCanvas& svg, const PlaneWindow& window, const SixBarScene& scene) {
  const HingePoints hinges = hinges_of(scene.six_bar);
  draw_traced_path(svg, window, scene.whole_path, scene.path.empty());
  for (std::size_t i = scene.positions.size(); i-- > 0;) draw_outlines(svg, window, scene.six_bar, scene.positions[i]);
  draw_traced_path(svg, window, scene.path, true);
  draw_carried_frame(svg, window, scene);
  draw_ground(svg, window, scene.six_bar, hinges);
  draw_bodies(svg, window, scene.six_bar, hinges);
  for (std::size_t pose = scene.poses.size(); pose-- > 0;)
    draw_pose(svg, window, scene.poses[pose].pose, pose + 1, pose == 0);
  for (const SixBarJoint& joint : scene.six_bar.joints) draw_pin(svg, window.to_px(joint.point), pin_color(joint));
  PointNames names(obstacles(window, scene, hinges));
  for (std::size_t joint = 0; joint < hinges.size(); ++joint)
    names.draw(svg, window.to_px(hinges[joint]), joint_name(joint), pin_color(scene.six_bar.joints[joint]));
}

}  // namespace linkwright
