#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/planar/display_order.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "map_reply.hpp"
#include "six_bar_map.hpp"
#include "task_reply.hpp"

namespace linkwright::wasm {

/// What the page asks for with a map.
struct ExploreRequest {
  static constexpr int nearest_order = -1;

  int samples = 400;
  std::array<double, 2> input = {0, 1}, output = {0, 1};             ///< places
  std::string_view property = measures::min_transmission_angle.key;  ///< key of a measure
  bool pose_miss = false;                                            ///< instead of the property, where a pose is freed
  bool structural_error = false;  ///< instead of the property, where a named function leaves no number free
  int order = 0;                  ///< code of a display order, or nearest_order: to the last one
};

/// Views are valid until the session is asked again.
struct ExploreReply {
  std::string task, census;  ///< JSON text; no census: there is no map
  const DrawnCurves* input_curves = nullptr;
  const DrawnCurves* output_curves = nullptr;  ///< none: the same
  const JudgedMap* map = nullptr;
  std::span<const double> input_tau, output_tau;
};
struct LinkageReply {
  std::string linkage;  ///< JSON text
  std::vector<double> states;
};
struct LiveReply {
  std::vector<std::uint8_t> input, output;
};
struct HaloRequest {
  int pose = 0;  ///< from 0
  bool turn = false;
  double reach = 0;  ///< user's unit, or radians
  int steps = 13, samples = 60;
};

/// The engine of the page: one problem at a time, kept with all that was computed from it, so that what follows a
/// dragged pose, a changed requirement or the pointer costs only what is new. The requests of
/// web/src/engine/protocol.ts, without the browser.
class Session {
 public:
  /// Reads a problem file; false where it has mistakes, and then the last good problem stays.
  bool set_problem(std::string_view text);
  /// Those of the last set_problem() or read(): JSON text of a list.
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// The normal form of a problem file; empty where it has mistakes.
  [[nodiscard]] std::string read(std::string_view text);

  [[nodiscard]] ExploreReply explore(const ExploreRequest& request);
  [[nodiscard]] LinkageReply linkage(double input_tau, double output_tau);
  [[nodiscard]] LiveReply live(double input_tau, double output_tau);
  /// Cells that pass, row-major [dy][dx], or by turn.
  [[nodiscard]] std::vector<std::uint32_t> halo(const HaloRequest& request) const;
  /// JSON text: the objects of `best`, `improve` and `verify`.
  [[nodiscard]] std::string best(int most) const;
  [[nodiscard]] std::string improve(double input_tau, double output_tau) const;
  [[nodiscard]] std::string verify(double input_tau, double output_tau);
  [[nodiscard]] std::vector<double> trace(double input_tau, double output_tau, Point traced);
  /// A file: svg, dxf, csv, json or result. Empty where there is no linkage to write.
  [[nodiscard]] std::string exported(double input_tau, double output_tau, std::string_view format) const;

 private:
  struct Drawn {
    DrawnCurves input;
    std::optional<DrawnCurves> output;  ///< nothing: the same
  };

  /// Null where there is no map.
  [[nodiscard]] const LinkageFamily* family() const;
  [[nodiscard]] bool has_map() const;
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const;
  [[nodiscard]] RequirementFilter filter(const RegionMap& map) const;
  void order_axes(const ExploreRequest& request);
  [[nodiscard]] ShownAxis ordered(const ExploreRequest& request, Side side) const;
  [[nodiscard]] std::vector<double> coordinates(const ExploreRequest& request, Side side) const;
  /// As many as are asked for, where so many are soon computed.
  [[nodiscard]] int map_samples(const ExploreRequest& request) const;
  void compute_map(const ExploreRequest& request);
  [[nodiscard]] const TaskFamily& given() const;
  /// Of a motion task; otherwise none.
  [[nodiscard]] const std::vector<PrescribedPose>& poses() const;
  [[nodiscard]] const ShownAxes& axes() const;
  [[nodiscard]] const Drawn& drawn();
  [[nodiscard]] std::optional<MapPoint> improved(MapPoint place) const;
  /// One that holds the linkage there, as a result does; nothing where there is none.
  [[nodiscard]] std::optional<Solution> solution_at(double input_tau, double output_tau) const;
  /// Requirements failed by each cell of a map.
  [[nodiscard]] std::vector<std::uint8_t> failures(RegionMap& map, std::span<const double> input,
                                                   std::span<const double> output) const;

  std::string text_, mistakes_ = "[]";
  Problem problem_;
  Requirements requirements_;  ///< the problem's, defaults filled in
  std::optional<TaskFamily> given_;
  std::optional<SixBarMap> six_bars_;  ///< of six-bar tasks, whose given_ has no family
  std::optional<Drawn> drawn_;
  std::optional<ShownAxes> axes_;

  struct MapKey {
    int samples = 0, order = 0;
    std::array<double, 2> input{}, output{};
    Spacing spacing = Spacing::coordinate;
    bool respect_direction = true;
    friend bool operator==(const MapKey&, const MapKey&) = default;
  };
  std::optional<MapKey> mapped_;  ///< what map_ shows of the present task
  JudgedMap map_;
  std::vector<double> input_tau_, output_tau_;
  RegionMap strip_, cell_;  ///< a row or a column, and a single cell
};

}  // namespace linkwright::wasm
