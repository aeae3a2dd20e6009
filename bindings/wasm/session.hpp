#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/machine/machine.hpp"
#include "map_reply.hpp"
#include "task_session.hpp"
#include "tolerance_reply.hpp"
#include "yield_map.hpp"

namespace linkwright::wasm {

/// Views are valid until the session is asked again.
struct ExploreReply {
  std::string task, census;  ///< JSON text; no census: there is no map
  const DrawnCurves* input_curves = nullptr;
  const DrawnCurves* output_curves = nullptr;  ///< none: the same
  const EvaluatedMap* map = nullptr;
  std::span<const double> input_tau, output_tau;
};
struct LiveReply {
  std::vector<FailureBits> input, output;
};
/// The engine of the page: one problem at a time, kept with all that was computed from it, so that what follows a
/// dragged pose, a changed requirement or the pointer costs only what is new. Where its task is a linkage
/// (opened_linkage()) only read(), linkage(), trace(), exported() and the machine are to be asked, at any place. The
/// requests of web/src/engine/protocol.ts, without the browser.
class Session {
 public:
  /// Reads a problem file; false where it has mistakes, and then the last good problem stays.
  bool set_problem(std::string_view text);
  /// Those of the last set_problem() or read(): JSON text of a list.
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// The normal form of a problem file, poses in numbers; empty where it has mistakes.
  [[nodiscard]] std::string read(std::string_view text);
  /// What to know of the file read last, as JSON text.
  [[nodiscard]] const std::string& notices() const { return notices_; }

  [[nodiscard]] ExploreReply explore(const ExploreRequest& request);
  [[nodiscard]] LinkageReply linkage(double input_tau, double output_tau);
  [[nodiscard]] LiveReply live(double input_tau, double output_tau);
  /// Cells that pass, row-major [dy][dx], or by turn.
  [[nodiscard]] std::vector<std::uint32_t> halo(const HaloRequest& request) const;
  /// JSON text: the objects of `best`, `improve` and `verify`.
  [[nodiscard]] std::string best(int most) const;
  [[nodiscard]] std::string improve(double input_tau, double output_tau) const;
  [[nodiscard]] std::string verify(double input_tau, double output_tau);
  /// What tolerances do to a linkage, by all samples, with histograms of so many bins and so many samples to be drawn;
  /// empty without tolerances and at a dead point.
  [[nodiscard]] ToleranceReply tolerance(double input_tau, double output_tau, int bins, int drawn) const;
  /// Samples the yields of so many more cells of the map shown last, coarse to fine. JSON text: `{"done", "total"}`;
  /// explore() then shows what is known.
  [[nodiscard]] std::string sample_yields(int cells);
  /// Of the map shown last the cells that no other beats in both objectives, by their names. JSON text: `{"front":
  /// [[row, column, value, value] …]}`, values as they are read.
  [[nodiscard]] std::string front(std::string_view first, std::string_view second) const;
  [[nodiscard]] std::vector<double> trace(double input_tau, double output_tau, Point traced);
  /// A file: svg, dxf, csv, json or result. Empty where there is no linkage to write.
  [[nodiscard]] std::string exported(double input_tau, double output_tau, std::string_view format) const;
  /// A linkage as plates and pins, to be looked at before it is made. JSON text: that of machine_reply().
  [[nodiscard]] std::string machine(double input_tau, double output_tau, const WantedSizes& sizes) const;
  /// The bytes of a file to make it from: stl, 3mf or plates, or for a simulator: urdf, sdf or mjcf. Errors:
  /// `no_four_bar`, those of machine(), write_parts() and simulator_text().
  [[nodiscard]] Result<std::string> machine_file(double input_tau, double output_tau, std::string_view format,
                                                 const WantedSizes& sizes) const;

 private:
  [[nodiscard]] const TaskSession& task() const;
  /// Requirements, objective and tolerances of the problem, after one is set.
  [[nodiscard]] Wish wish() const { return {requirements_, problem_.options.objective, added_}; }
  void set_tolerances(bool task_is_new);
  [[nodiscard]] std::optional<LinkageOutput> output_at(MapPoint place) const;
  [[nodiscard]] Result<Machine> machine_at(MapPoint place, const WantedSizes& sizes) const;
  void measure_tolerances(bool map_is_new);
  [[nodiscard]] bool fails_yield(MapPoint place) const;
  /// Null where there is no map.
  [[nodiscard]] const LinkageFamily* family() const { return opened_ ? nullptr : task().family(); }
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const;
  [[nodiscard]] RequirementFilter filter(const RegionMap& map) const;
  void compute_map(const ExploreRequest& request);
  void look_closer(const RequirementFilter& passing);
  [[nodiscard]] const Drawn& drawn();
  /// Requirements failed by each cell of a map.
  [[nodiscard]] std::vector<FailureBits> failures(RegionMap& map, std::span<const double> input,
                                                  std::span<const double> output) const;

  std::string text_, mistakes_ = "[]", notices_ = "[]";
  Problem problem_;
  Requirements requirements_;               ///< the problem's, defaults filled in
  std::unique_ptr<TaskSession> task_;       ///< none before the first problem
  std::optional<AnyStoredLinkage> opened_;  ///< the problem's task is this linkage; then nothing is asked of task_
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
  EvaluatedMap map_;
  std::vector<double> input_tau_, output_tau_;
  RegionMap strip_, cell_;  ///< a row or a column, and a single cell

  AddedMeasures added_;                   ///< of the problem's tolerances
  std::optional<Tolerances> tolerances_;  ///< with their turning length; of added_
  bool tolerances_measured_ = false;      ///< map_ holds the errors of tolerances_
  std::optional<YieldMap> yields_;        ///< of map_ and tolerances_, as far as they are sampled
  std::vector<std::uint8_t> yields_of_;   ///< the cells that are to be
};

}  // namespace linkwright::wasm
