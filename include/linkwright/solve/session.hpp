#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/mechanism/travel.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/display_order.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

class YieldMap;

/// How fine a map is asked for, of which part, and what it is to show.
struct MapRequest {
  static constexpr int nearest_order = -1;
  static constexpr std::array<double, 2> whole = {0, 1};

  int samples = 400;
  std::array<double, 2> input = whole, output = whole;               ///< places: shares of the axes as they are shown
  std::string_view property = measures::min_transmission_angle.key;  ///< key of a measure, or of one of the task's own
  int order = 0;                                                     ///< code of a display order, or nearest_order
};

/// An axis of a map in its display order, and what people read along it, (coordinate, value); none: nothing else.
struct ShownAxis {
  MapAxis axis;
  DisplayOrder order;
  std::vector<std::array<double, 2>> ticks;
};
struct ShownAxes {
  ShownAxis input, output;
  bool symmetric = true;  ///< LinkageFamily::is_symmetric()

  [[nodiscard]] const ShownAxis& of(Side side) const { return side == Side::input ? input : output; }
};

/// The grounded links along an axis by rising coordinate, close enough to be drawn: three numbers to each end, in the
/// plane its homogeneous unit vector (w, x, y) in the user's frame, about a centre its axis. None where they depend on
/// the other coordinate.
struct LinkPolygon {
  std::vector<double> coordinate, fixed, moving;
  std::vector<std::uint8_t> branch;
};

/// A map under requirements, coloured by a property.
struct ColouredMap {
  RegionMap region;
  RegionCounts counts;
  std::vector<FailureBits> fails;  ///< by cell
  std::vector<float> values;       ///< by cell, of the property: as people read them; 0 where it is not defined
  Ridges ridges;                   ///< by the property
  RequirementCensus census;
  // Where no cell meets the requirements:
  InsideWindows inside;                           ///< what was looked at inside the windows of hinges
  std::vector<MissedBox> missed_boxes;            ///< that the curve does not enter
  std::vector<Relaxation> relax;                  ///< what would leave something, there or on the map
  std::optional<JointRelaxation> relax_together;  ///< where relaxing one alone would not
};

/// What is at a place of the map, and what it does.
struct PickedLinkage {
  MapPoint place;
  FailureBits fails = 0;         ///< the requirements that it fails, as of a cell
  std::optional<Answer> answer;  ///< lists the linkage alone, not driven through; nothing: there is none
  std::optional<Notice> reason;  ///< why there is none, or it does not do the task
  Travel travel;
  std::vector<int> positions;  ///< those that the travel is to pass, as the task counts them, from 1
};

/// By the links of an axis (LinkPolygon) the requirements failed with that link there and the other held.
struct LiveLinks {
  std::vector<FailureBits> input, output;
};

struct Verification {
  bool verified = false;  ///< driven through by a method that the finder does not use
  double residual = 0;    ///< user's unit
};

/// Of the cells of the map explored last that meet all else.
struct SampledYields {
  std::int64_t done = 0, total = 0;
};

/// One problem at a time, kept with all that was computed of it, so that what follows a dragged pose, a changed
/// requirement or the pointer costs only what is new. References are valid until it is asked again.
class Session {
 public:
  /// Of a problem without mistakes.
  explicit Session(Problem problem);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Another problem, or the same after a change: what was computed of the old one and holds of the new one stays.
  void set(Problem problem);
  [[nodiscard]] const Problem& problem() const { return problem_; }

  /// What is known of the task before linkages are looked for; requirements with their defaults filled in, options with
  /// the turning length of their tolerances.
  [[nodiscard]] const Answer& known() const { return known_; }
  [[nodiscard]] const Requirements& requirements() const { return findings(known_).requirements; }
  /// What the map is of; null where there is none.
  [[nodiscard]] const LinkageFamily* family() const;
  [[nodiscard]] const LinkPolygon& links(Side side);
  /// Places worth marking on the curves of the task.
  [[nodiscard]] const std::vector<CurveMark>& marks();

  /// Null where the task has no map.
  const ColouredMap* explore(const MapRequest& request);
  /// As the map explored last has them.
  [[nodiscard]] const ShownAxes& axes() const { return axes_; }
  /// Why there is no map, or no linkage on all of it; nothing: there are some, or a part of it was explored last.
  [[nodiscard]] std::optional<Notice> why_nothing() const;
  /// Samples the yields of so many more cells of the map explored last, coarse to fine; explore() shows them.
  SampledYields sample_yields(int cells);
  /// Of the map explored last the cells that no other beats in both objectives.
  [[nodiscard]] std::vector<ParetoCell> front(Objective first, Objective second) const;

  /// `place`: of a task with a map.
  [[nodiscard]] PickedLinkage linkage(MapPoint place);
  [[nodiscard]] LiveLinks live(MapPoint place);
  [[nodiscard]] std::vector<Point> trace(MapPoint place, Point traced) const;
  [[nodiscard]] Verification verify(MapPoint place) const;
  /// A place that is better by the problem's objective, reached by a climb from there; nothing: none is near.
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place) const;
  /// The answer that lists the linkage at a place alone, driven through; nothing where there is none.
  [[nodiscard]] std::optional<Answer> answer_at(MapPoint place) const;
  /// The same for a result file: with what analyses find of it, whatever it misses.
  [[nodiscard]] std::optional<Answer> result_at(MapPoint place) const;
  /// How the linkage at a place lies in the positions of the task, with tolerances its turning length set.
  [[nodiscard]] std::optional<LinkageOutput> output_at(MapPoint place) const;
  /// The best of the whole map, by solve(). Yields by fewer samples.
  [[nodiscard]] Result<Answer> best(int most) const;

 private:
  void set_options(bool task_is_new);
  void colour(std::string_view property);
  void measure_added(bool map_is_new);
  void look_closer(const RequirementFilter& passing);
  void evaluate(const RequirementFilter& passing);
  void draw();
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const;
  [[nodiscard]] RequirementFilter filter(const RegionMap& map) const;
  [[nodiscard]] std::vector<FailureBits> failures(RegionMap& map, std::span<const double> input,
                                                  std::span<const double> output) const;
  [[nodiscard]] FailureBits failures_at(MapPoint place);
  [[nodiscard]] FailureBits bit_of(RequirementKind kind) const;

  struct Drawn {
    LinkPolygon input, output;
    std::vector<CurveMark> marks;
  };
  struct MapKey {
    int samples = 0, order = 0;
    std::array<double, 2> input{}, output{};
    Spacing spacing = Spacing::coordinate;
    bool respect_direction = true;
    friend bool operator==(const MapKey&, const MapKey&) = default;
  };

  Problem problem_;
  Answer known_;
  std::optional<Drawn> drawn_;
  ShownAxes axes_;
  bool axes_are_shown_ = false;
  std::optional<MapKey> mapped_;  ///< what map_ shows of the present task
  ColouredMap map_;
  RegionMap strip_, cell_;  ///< a row or a column, and a single cell

  SynthesisOptions analyzed_;            ///< of the problem; tolerances with their turning length
  AddedMeasures added_;                  ///< of analyzed_
  bool added_measured_ = false;          ///< map_ holds them
  std::unique_ptr<YieldMap> yields_;     ///< of map_, as far as it is sampled
  std::vector<std::uint8_t> yields_of_;  ///< the cells that are to be
};

}  // namespace linkwright
