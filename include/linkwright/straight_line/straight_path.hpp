#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/infinitesimal/motion_series.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Why a straight stretch ends where it does.
enum class PathEnd {
  deviation,  ///< farther off the line than asked for
  turn,       ///< the point turns back
  travel,     ///< as far along the line as asked for
  unfinished  ///< more steps than a path takes (max_stretches): the linkage is all but singular
};
/// Key in result files: "deviation", "turn", …
[[nodiscard]] std::string_view name(PathEnd end);

/// A straight stretch by the way s along the line, which is 0 where the linkage lies; user's unit.
struct UsableLine {
  double from = 0, to = 0;
  PathEnd begin = PathEnd::turn, end = PathEnd::turn;

  [[nodiscard]] double length() const { return to - from; }
};

/// How the input turns while the point runs along its stroke.
struct DriveOfStroke {
  double sweep = 0;                 ///< angle that the input turns, radians, of the sense in which s rises
  double slowest = 0, fastest = 0;  ///< |ds/dφ|, user's unit a radian

  /// (fastest − slowest) / mean, the mean over the sweep: 0 where the point travels evenly with the input.
  [[nodiscard]] double nonuniformity(double stroke) const { return (fastest - slowest) * std::abs(sweep) / stroke; }
};

/// How well a point runs straight over a stroke, but for the best line of any direction, which takes longer.
struct StrokeFigures {
  double from = 0, to = 0;             ///< s
  double max_deviation = 0;            ///< largest |e|, off the line itself
  double parallel_line_deviation = 0;  ///< off the best line parallel to it: half of what e ranges over
  double middle_deviation = 0;         ///< e of that line
  double min_transmission_angle = 0;   ///< of the input driving, radians
  std::optional<DriveOfStroke> drive;  ///< nothing where the input turns back on the way, and the velocity is unbounded
};
struct StrokeReport : StrokeFigures {
  double best_line_deviation = 0;  ///< off the best line of any direction
};

/// How far a path is traced from where the linkage lies, either way along the line: some way, both.
struct PathLimits {
  double max_deviation = std::numeric_limits<double>::infinity();                                        ///< |e|
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();  ///< s
};

/// The path of a coupler point beside the line through it along a direction, as far as it runs on along that line: both
/// ways until it turns back. In stretches, each a Taylor series (loop_series()) as long as its last terms leave it
/// exact to rounding, so that places, extremes and lengths are roots of polynomials; the configuration is closed anew
/// by Newton's method between them. Passes dead points of both links.
class StraightPath {
 public:
  /// Nothing where all links lie in one line, or the point rests or runs across the line.
  [[nodiscard]] static std::optional<StraightPath> of(const TracingFourBar& linkage, Point direction,
                                                      const PathLimits& limits = {});

  [[nodiscard]] double from() const;  ///< s where it begins
  [[nodiscard]] double to() const;    ///< s where it ends
  [[nodiscard]] PathEnd begin() const { return begin_; }
  [[nodiscard]] PathEnd end() const { return end_; }

  /// The connected stretch around s = 0 with |e| ≤ deviation, at most what was traced.
  [[nodiscard]] UsableLine usable(double deviation) const;
  /// The longest stretch that holds s = 0 and over which e ranges over 2 · deviation at most.
  [[nodiscard]] UsableLine usable_strip(double deviation) const;
  /// It runs over from ≤ s ≤ to, a way that is not empty.
  [[nodiscard]] bool reaches(double from, double to) const;
  /// Over from ≤ s ≤ to; nothing where the path does not reach that far.
  [[nodiscard]] std::optional<StrokeReport> stroke(double from, double to) const;
  [[nodiscard]] std::optional<StrokeFigures> stroke_figures(double from, double to) const;

  /// The linkage and its path at one place.
  struct State {
    double s = 0, e = 0;
    TracingFourBar linkage;
    double velocity = 0;  ///< ds/dφ by the input's angle; infinite at its dead point
  };
  /// At `count` ≥ 2 places evenly along s, from the beginning to the end.
  [[nodiscard]] std::vector<State> states(int count) const { return states(from(), to(), count); }
  /// The same over a part of it.
  [[nodiscard]] std::vector<State> states(double first, double last, int count) const;

 private:
  struct Stretch {
    double from = 0, to = 0;  ///< of the series' parameter
    RealSeries<motion_order> s, e;
    LoopSeries loop;  ///< turns from where the linkage lies
  };
  struct Place {
    std::size_t stretch = 0;
    double t = 0;
  };
  struct Walk;
  struct Strips;

  /// The connected stretch around s = 0 with low ≤ e ≤ high.
  [[nodiscard]] UsableLine within(double low, double high) const;
  [[nodiscard]] Place place_at(double s) const;
  [[nodiscard]] double s_at(Place place) const;
  [[nodiscard]] double e_at(Place place) const;
  [[nodiscard]] std::vector<Place> extremes(double from, double to, double slope) const;
  [[nodiscard]] double best_line(double from, double to) const;
  [[nodiscard]] TracingFourBar linkage_at(Place place) const;

  TracingFourBar start_;
  std::vector<Stretch> stretches_;  ///< by rising s
  std::size_t first_ahead_ = 0;     ///< the stretch that begins where the linkage lies
  PathEnd begin_ = PathEnd::turn, end_ = PathEnd::turn;
};

}  // namespace linkwright
