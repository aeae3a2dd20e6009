#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"
#include "map_reply.hpp"
#include "task_reply.hpp"

namespace linkwright::wasm {

/// What the page asks for with a map.
struct ExploreRequest {
  static constexpr int nearest_order = -1;
  static constexpr std::array<double, 2> whole = {0, 1};

  int samples = 400;
  std::array<double, 2> input = whole, output = whole;               ///< places
  std::string_view property = measures::min_transmission_angle.key;  ///< key of a measure, or of one of the task's own
  int order = 0;                                                     ///< code of a display order, or nearest_order
};
struct HaloRequest {
  int part = 0;  ///< a pose, from 0; of six-bars after them the chain's hinges a, b, d
  bool turn = false;
  double reach = 0;  ///< user's unit, or radians
  int steps = 13, samples = 60;
};
struct LinkageReply {
  std::string linkage;  ///< JSON text
  std::vector<double> states;
  std::string tolerance;  ///< JSON text; empty without tolerances and at a dead point
};
/// What is to be made better, and by what. Refers to all.
struct Wish {
  const Requirements& requirements;
  Objective objective;
  const AddedMeasures& added;
};
/// The curves of both axes; no output: the same.
struct Drawn {
  DrawnCurves input;
  std::optional<DrawnCurves> output;
};
struct Verification {
  bool verified = false;
  double residual = 0;  ///< user's unit
};

/// A task in the session's hand: what differs from one kind of task to another. Whatever is the same for all, a map and
/// its axes, requirements and their census, belongs to Session.
class TaskSession {
 public:
  TaskSession() = default;
  TaskSession(const TaskSession&) = delete;
  TaskSession& operator=(const TaskSession&) = delete;
  virtual ~TaskSession() = default;

  /// What was computed of this task serves for that problem too.
  [[nodiscard]] virtual bool serves(const Problem& problem) const = 0;
  /// Of the map; null where there is none, and then no_map() says why.
  [[nodiscard]] virtual const LinkageFamily* family() const = 0;
  [[nodiscard]] virtual const Notice& no_map() const = 0;
  /// Where every place of the map is degenerate.
  [[nodiscard]] virtual const Notice& nothing_on_map() const = 0;
  [[nodiscard]] virtual Requirements with_defaults(Requirements wanted) const = 0;
  /// What is said of the task before any linkage is looked for.
  [[nodiscard]] virtual TaskReply about() const = 0;

  [[nodiscard]] virtual Drawn drawn() const = 0;
  /// `shown`: as the axes were last shown, or null.
  [[nodiscard]] virtual ShownAxes axes(const ExploreRequest& request, Spacing spacing,
                                       const ShownAxes* shown) const = 0;
  [[nodiscard]] virtual std::vector<double> coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                        Side side) const = 0;
  /// As many as are asked for, where so many are soon computed.
  [[nodiscard]] virtual int map_samples(int asked) const = 0;
  /// The same of each map of a halo of so many places.
  [[nodiscard]] virtual int halo_samples(int asked, std::size_t /*places*/) const { return asked; }
  /// Where requirements leave nothing.
  [[nodiscard]] virtual std::vector<MissedBox> missed_boxes(const Requirements& /*wanted*/) const { return {}; }
  /// Colours the map by a property of the task's own; false where it has no such.
  virtual bool measure(EvaluatedMap& /*map*/, std::string_view /*property*/) const { return false; }

  [[nodiscard]] virtual LinkageReply linkage(MapPoint place, FailureBits fails, bool respect_direction) const = 0;
  /// Where the cells of the map are estimated: measured exactly the linkage meets what is required.
  [[nodiscard]] virtual bool meets_exactly(MapPoint /*place*/, const Requirements& /*wanted*/) const { return false; }
  [[nodiscard]] virtual Verification verify(MapPoint place, bool respect_direction) const = 0;
  /// The path of a point of the moving body (as it lies in position 1), x and y by turns.
  [[nodiscard]] virtual std::vector<double> trace(MapPoint place, Point traced, bool respect_direction) const = 0;
  [[nodiscard]] virtual std::optional<MapPoint> improved(MapPoint place, const Wish& wish) const = 0;
  /// SynthesisOptions::region_samples for solve() to find the best of the usual map.
  [[nodiscard]] virtual int samples_for_best() const = 0;
  /// SynthesisOptions::window says how far the axes run, rather than what of them is looked at.
  [[nodiscard]] virtual bool window_sets_axes() const { return false; }
  /// The answer that holds the linkage there alone; nothing where there is none.
  [[nodiscard]] virtual std::optional<Answer> answer_at(MapPoint place, bool respect_direction) const = 0;
};

/// `problem`: without mistakes.
[[nodiscard]] std::unique_ptr<TaskSession> task_session(const Problem& problem);

/// The elements of `best`.
void write_best_linkages(JsonWriter& json, const FourBarAnswer& answer);
void write_best_linkages(JsonWriter& json, const SixBarAnswer& answer);
void write_best_linkages(JsonWriter& json, const SphericalAnswer& answer);
void write_best_linkages(JsonWriter& json, const StraightLineAnswer& answer);

}  // namespace linkwright::wasm
