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
#include "map_reply.hpp"
#include "task_session.hpp"

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
  [[nodiscard]] const TaskSession& task() const;
  /// Null where there is no map.
  [[nodiscard]] const LinkageFamily* family() const { return task().family(); }
  void classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const;
  [[nodiscard]] RequirementFilter filter(const RegionMap& map) const;
  void compute_map(const ExploreRequest& request);
  [[nodiscard]] const Drawn& drawn();
  /// Requirements failed by each cell of a map.
  [[nodiscard]] std::vector<FailureBits> failures(RegionMap& map, std::span<const double> input,
                                                  std::span<const double> output) const;

  std::string text_, mistakes_ = "[]";
  Problem problem_;
  Requirements requirements_;          ///< the problem's, defaults filled in
  std::unique_ptr<TaskSession> task_;  ///< none before the first problem
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
};

}  // namespace linkwright::wasm
