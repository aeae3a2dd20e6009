#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/approximate/curve_error.hpp"
#include "linkwright/approximate/fit_wishes.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/region/pivot_windows.hpp"

namespace linkwright {

/// Points that the path of a coupler point is to come near to, in the order in which it passes them, without timing.
/// User's frame and unit.
struct CurveTarget {
  std::vector<Point> points;    ///< finite, at least three of them distinct; the first is not repeated at the end
  std::vector<double> weights;  ///< of the squared distances, ≥ 0, one to each point, not all 0; empty: 1 each
  bool closed = false;          ///< the path goes on from the last point to the first, and the input turns fully

  /// That of the bounding box of the points.
  [[nodiscard]] double diagonal() const;
};

struct CurveFitOptions {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  FitEffort effort = FitEffort::standard;
  FitMeasure measure = FitMeasure::least_squares;
  /// Longest and shortest of the four links of the realisation that is listed first, in diagonals of the target.
  /// Without a limit there may be no best linkage: an ellipse is approached by ever longer ones.
  double max_length = 10, min_length = 1e-3;
  double max_link_ratio = unlimited;  ///< longest over shortest of the same
  /// Least Grashof excess – the two other links less the shortest and the longest – as a share of the diagonal;
  /// nothing: non-Grashof linkages are allowed, too. Of closed curves only. Towards 0 the best linkage often is a flat
  /// one.
  std::optional<double> grashof_margin = 0.003;
  double min_transmission_angle = 0;  ///< at the points, closed: all round, radians in [0, π/2); 0: any
  /// Boxes: for both fixed pivots, between which is fitted; and for both moving ones at the first point, which only
  /// tells which curves are listed.
  PivotWindows windows;
  /// Where the fixed pivot of the driving link stands, and that of the other; nothing: anywhere.
  std::optional<Point> input_pivot, output_pivot;
  /// Linkages from which least squares begin, too, beside what the scan finds: as they lie where the first point is to
  /// be passed. Those that cannot be moved are passed over; one is listed as it is where nothing found is nearer.
  std::vector<TracingFourBar> starts;
  std::size_t max_fits = 20;    ///< how many are listed
  int threads = 0;              ///< 0: as many as the machine has; never shows in results
  Simd simd = Simd::automatic;  ///< instruction set of the kernels; all give the same bits
};

/// Where the linkage is when its point is nearest to a point of the target.
struct FitState {
  FourBar bars;            ///< the first realisation there
  double input_angle = 0;  ///< of input_fixed → input_moving, fixed frame, radians, counted on along the way
  Point point{};           ///< of the coupler
  double distance = 0;     ///< from the point of the target, user's unit
};

/// What driving the linkage along its circuit from the first point showed. It knows the bars, the states and the
/// target, and nothing of how they were found.
struct CurveDrive {
  bool one_circuit = false;   ///< all states lie on the circuit of the first
  bool in_order = false;      ///< and come in turn in one sense; closed: within one round
  bool input_drives = false;  ///< and the input meets no dead point on the way; closed: all the way round
  bool output_drives = false;
  bool full_turn = false;  ///< the input turns fully

  /// Nothing keeps the input from doing the task; that of a closed target turns fully.
  [[nodiscard]] bool no_defects(bool closed) const {
    return one_circuit && in_order && input_drives && (full_turn || !closed);
  }
};

/// A curve that a coupler point traces, and the three four-bars that trace it (Roberts' theorem, 1875).
struct CurveFit {
  /// As they lie at the first point of the target, the point of the plane the same in each. The first can be driven by
  /// its input without defects and keeps the limits, where one does.
  std::array<TracingFourBar, 3> realisations;
  std::size_t realisation_count = 0;  ///< 3; 1 where the point is a moving pivot and the path so a circle
  CurveError error;
  std::vector<FitState> states;  ///< one to each point of the target, in its order
  /// Of each realisation: by how much its input turns from the first point to each on the way, radians. Where the
  /// points do not come in turn, by the shorter way from each to the next.
  std::array<std::vector<double>, 3> input_turns;
  CurveDrive drive;  ///< of the first realisation
  double min_transmission_angle =
      0;  ///< of the first realisation, over the path from the first to the last point, radians
  /// Lengths, ratio, margin, transmission angle and windows are kept by the first realisation.
  bool within_limits = false;
  bool at_length_limit = false;  ///< its longest link is max_length to a thousandth: longer ones may come nearer

  [[nodiscard]] const TracingFourBar& linkage() const { return realisations[0]; }
};

struct CurveFits {
  /// Those without defects and within the limits; best first; distinct by their three ground pivots.
  std::vector<CurveFit> fits;
  std::optional<CurveFit> smallest_with_defects;  ///< of the curves that a defect keeps out of `fits`
  struct Counts {
    std::size_t places = 0;  ///< of a fixed pivot at which dyads were scanned
    std::size_t starts = 0;  ///< of the least squares
    std::size_t minima = 0;  ///< distinct curves that came out
  } counts;
  bool cancelled = false;  ///< stopped before the end; what was found so far is listed
};

/// Four-bars whose coupler point passes nearest to the points of a target. Evidence, not proof: local minima from a
/// fixed number of starts. A driving dyad is assumed, which turns the points into poses of the coupler, to which the
/// second dyad is fitted in closed form; the best of many such pairs are starts of least squares over all nine
/// dimensions, the states at the points being eliminated. The limits act inside the fit, as hinges. Of fewer than ten
/// points exact solutions exist, in families. Same input, same output. `target`: as CurveTarget says, asserted.
[[nodiscard]] CurveFits fit_curve(const CurveTarget& target, const CurveFitOptions& options = {},
                                  const Progress& progress = {});

/// How near the path of a linkage comes to a target, on the circuit in which it lies: error, states and verdict as of a
/// fit; the linkage is the first realisation. To each point belongs a state, such that all come in turn and the sum of
/// squares is least. Nothing where a link has no length or the bars cannot be moved.
[[nodiscard]] std::optional<CurveFit> compare_with_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                                         const CurveFitOptions& options = {});

}  // namespace linkwright
