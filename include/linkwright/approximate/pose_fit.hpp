#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/approximate/fit_wishes.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/pivot_windows.hpp"

namespace linkwright {

/// Poses that a body on the coupler is to pass as near as it can, in their order, some of them exactly. User's frame
/// and unit.
struct PoseTarget {
  std::vector<Pose> poses;         ///< finite, one at least; to be fitted to, three or more of them distinct
  std::vector<double> weights;     ///< of the squared errors, ≥ 0, one to each pose, not all 0; empty: 1 each
  std::vector<std::size_t> exact;  ///< indices of poses that are passed exactly, rising; five at most
  double turning_length = 1;       ///< > 0: an error of angle by 1 radian weighs as one of position by this

  /// What lengths of links are told by: the turning length, or the root mean square distance of the poses' origins from
  /// their centroid where that is larger.
  [[nodiscard]] double scale() const;
  [[nodiscard]] double weight(std::size_t pose) const { return weights.empty() ? 1 : weights[pose]; }
  [[nodiscard]] bool is_exact(std::size_t pose) const;
};

/// A linkage from which least squares begin, as it lies where the first pose is to be taken.
struct PoseFitStart {
  FourBar bars;
  std::optional<Pose> body;  ///< that it carries there; nothing: it lies in that pose
};

struct PoseFitOptions {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  FitEffort effort = FitEffort::standard;
  FitMeasure measure = FitMeasure::least_squares;
  /// Longest and shortest of the four links, in scales of the target. Without a limit there may be no best linkage: a
  /// straight line is approached by ever longer ones.
  double max_length = 20, min_length = 1e-3;
  double max_link_ratio = 40;         ///< longest over shortest
  double min_transmission_angle = 0;  ///< at the poses, radians in [0, π/2); 0: any
  /// Boxes: for both fixed pivots, between which is fitted; and for both moving ones at the first pose, which only
  /// tells which linkages are listed.
  PivotWindows windows;
  /// Beside what the field finds. Those that cannot be moved are passed over; one is listed as it is where nothing
  /// found is nearer.
  std::vector<PoseFitStart> starts;
  std::size_t max_fits = 20;  ///< how many are listed
  int threads = 0;            ///< 0: as many as the machine has; never shows in results
};

/// How far a body that a linkage carries is from the poses that it is to pass near, user's unit and radians. The error
/// of a pose is √(d² + (L Δθ)²), d being that of its origin, Δθ that of its angle and L the turning length.
struct PoseFitError {
  double sum_of_squares = 0;  ///< of the errors at the near poses, weighted
  double rms = 0;             ///< √(sum_of_squares / sum of weights); 0 where no pose is near
  double position_rms = 0, position_max = 0;
  double angle_rms = 0, angle_max = 0;
  std::size_t max_at = 0;     ///< the near pose of the largest error
  double exact_residual = 0;  ///< largest error at the exact poses
};

/// Where the linkage is when its body is nearest to a pose of the target.
struct PoseState {
  FourBar bars;
  Pose body;               ///< its angle within half a turn of the pose's
  double input_angle = 0;  ///< of input_fixed → input_moving, fixed frame, radians, counted on along the way
  double position_error = 0, angle_error = 0;  ///< from the pose: a distance, and radians ≥ 0
};

/// A linkage and how near it carries its body to the poses.
struct PoseFit {
  FourBar bars;  ///< as it lies nearest to the first pose
  PoseFitError error;
  std::vector<PoseState> states;  ///< one to each pose, in their order
  CurveDrive drive;
  double min_transmission_angle = 0;  ///< on the way from the first pose to the last, radians
  bool within_limits = false;         ///< lengths, ratio, transmission angle and windows are kept
  bool at_length_limit = false;       ///< its longest link is max_length to a thousandth
};

struct PoseFits {
  /// Those without defects and within the limits; best first; distinct.
  std::vector<PoseFit> fits;
  std::optional<PoseFit> smallest_with_defects;  ///< of the linkages that a defect keeps out of `fits`
  struct Counts {
    std::size_t dyads = 0;   ///< points of the body whose best circles were paired
    std::size_t starts = 0;  ///< of the least squares
    std::size_t minima = 0;  ///< distinct linkages that came out
  } counts;
  bool cancelled = false;  ///< stopped before the end; what was found so far is listed
};

/// Four-bars whose coupler carries a body nearest to poses. Evidence, not proof: local minima from a fixed number of
/// starts. Points of the body whose places lie near to circles are paired, the pairs rated by the least displacement of
/// the body that closes both dyads, in closed form; the best start least squares over all ten dimensions, the states at
/// the poses being eliminated. The limits act inside the fit, as hinges; exact poses by weights that grow. Of five
/// poses or fewer exact solutions are known otherwise (task_family()). Same input, same output. `target`: as PoseTarget
/// says, asserted.
[[nodiscard]] PoseFits fit_poses(const PoseTarget& target, const PoseFitOptions& options = {},
                                 const Progress& progress = {});

/// How near any four-bar carries a body to poses, on the circuit in which it lies; `body` is where the body is as the
/// bars lie. To each pose belongs a state, such that all come in turn and the sum of squares is least. Nothing where a
/// link has no length or the bars cannot be moved. `target`: as PoseTarget says, asserted; one pose is enough.
[[nodiscard]] std::optional<PoseFit> compare_with_poses(const FourBar& bars, const Pose& body, const PoseTarget& target,
                                                        const PoseFitOptions& options = {});

}  // namespace linkwright
