#pragma once

#include <string>

#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/comparison_file.hpp"
#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/orientation_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// An answer as one picture (SVG, 1440 × 900): the poses with both Burmester curves and the best linkage; the solution
/// region by type; the best linkage's numbers. Below 300 kB at any number of samples.
[[nodiscard]] std::string draw_answer(const Problem& problem, const Answer& answer);

/// One linkage as a picture (SVG, 1000 × 800): its positions, its dimensions, its coupler curve; of one with poses the
/// springs and the cylinder of `loads`, and where its masses are and the hand takes hold, in position 1.
[[nodiscard]] std::string draw_linkage(const StoredLinkage& linkage, const Loads* loads = nullptr);

/// One six-bar as a picture of the same size: its positions, the path of the moving frame, its hinges and lengths.
[[nodiscard]] std::string draw_linkage(const StoredSixBar& linkage);

/// One spherical four-bar as a picture of the same size.
[[nodiscard]] std::string draw_linkage(const StoredSphericalFourBar& linkage);

// Pictures of rotations and displacements (SVG, 640 px wide): orthographic views of the fixed frame from above and in
// front, z upwards, in which nothing hides anything else.

/// An orientation: given by three angles, the three turns one after another and all of them together, with the line of
/// nodes, or at gimbal lock the two axes that have come to lie in one line; given otherwise, one turn about its axis,
/// both triads, and a vector (the task's first, or one that shows the turn well) with its image.
[[nodiscard]] std::string draw_orientation(const OrientationReport& report);

/// A displacement as a screw: its axis, both triads, the helix of the origin (or, where that lies on the axis, of a
/// point beside it), angle and slide.
[[nodiscard]] std::string draw_displacement(const DisplacementReport& report);

/// One instant as a picture (SVG, 1000 × 800): the linkage, pole, pole tangent and normal, inflection, return and
/// Bresse circles, circling-point and centering-point curves, Ball's point, Burmester points, and the centre of
/// curvature of the point that was asked for. `analysis` has an instant.
[[nodiscard]] std::string draw_instant(const LinkageAnalysis& analysis);

/// The same of a body in a prescribed pose.
[[nodiscard]] std::string draw_instant(const PrescribedInstant& instant);

/// A linkage and points that its path is compared with (SVG, 1000 × 800): from each point the way to where the path is.
[[nodiscard]] std::string draw_comparison(const StoredLinkage& linkage, const PathComparison& comparison);

/// The same with poses that its body is compared with: the frame in each of them, and the way of its origin.
[[nodiscard]] std::string draw_comparison(const StoredLinkage& linkage, const PoseComparison& comparison);

}  // namespace linkwright
