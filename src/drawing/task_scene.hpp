#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// What the large card of a solution's picture shows, fixed frame.
struct TaskScene {
  std::string heading;
  std::vector<PrescribedPose> frames;           ///< drawn with their numbers
  bool of_point = false;                        ///< only where they are is to be passed: drawn without their axes
  const FourBarSolution* linkage = nullptr;     ///< the best one, or the nearest way out
  std::vector<PrescribedPose> served;           ///< what its coupler visits; it lies in the first
  std::optional<Point> traced;                  ///< point of the coupler there whose path is drawn
  std::vector<Dyad> beads;                      ///< a few grounded links
  std::optional<FunctionTask> function;         ///< the linkage's own, its free parameter fixed
  std::shared_ptr<const BurmesterCurve> curve;  ///< of grounded links, or of couplers
  WorkingFrame curve_frame;                     ///< its frame
  std::vector<Dyad> input_links, output_links;  ///< along the axes of the map, where there is no curve
};

/// The answer must outlive it.
[[nodiscard]] TaskScene task_scene(const MotionAnswer& answer);
[[nodiscard]] TaskScene task_scene(const FunctionAnswer& answer);
[[nodiscard]] TaskScene task_scene(const PathAnswer& answer);

/// Draws it in a card.
void draw_task_scene(SvgCanvas& svg, const TaskScene& scene, const Problem& problem, const FourBarAnswer& answer,
                     const PixelBox& card);

}  // namespace linkwright
