#include "linkwright/synthesis/tolerance_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "four_bar_errors.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/robust/tolerance_error.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "spherical_errors.hpp"

namespace linkwright {
namespace {

// Places of a straight line at which its error is looked at, of those listed and of those of a map: the ends are worst.
constexpr int places_of_line = 41, places_of_cell = 9;

PlanarOutput planar_output(const FourBar& bars, const std::vector<PrescribedPose>& poses, bool is_function,
                           double turning_length) {
  std::vector<TracingFourBar> positions;
  for (const PrescribedPose& there : poses) {
    const auto moved = [&](Point p) { return displaced(p, poses.front().pose, there.pose); };
    positions.push_back({{bars.input_center, moved(bars.input_circle), bars.output_center, moved(bars.output_circle)},
                         there.pose.origin});
  }
  if (!is_function) return pose_output(std::move(positions), turning_length);
  std::vector<FourBar> all;
  for (const TracingFourBar& linkage : positions) all.push_back(linkage.bars);
  return angle_output(all);
}

SphericalOutput spherical_output(const SphericalFourBar& bars, const std::vector<PrescribedOrientation>& orientations,
                                 bool is_function) {
  SphericalOutput output{is_function ? SphericalOutput::Kind::angle : SphericalOutput::Kind::orientation, {}};
  const UnitQuaternion first = orientations.front().orientation;
  for (const PrescribedOrientation& there : orientations) {
    const auto moved = [&](Vector3 axis) { return turned(axis, first, there.orientation); };
    output.positions.push_back(
        {bars.input_fixed, moved(bars.input_moving), moved(bars.output_moving), bars.output_fixed});
  }
  return output;
}

SixBarOutput six_bar_output(const SixBarTask& task, const SixBarMember& member, double turning_length) {
  return {member.six_bar, {member.turns.begin(), member.turns.end()}, task.poses.front().pose, turning_length};
}

LinkageOutput line_output_over(const StraightPath& path, double from, double to, const DirectedLine& line, int places) {
  std::vector<TracingFourBar> positions;
  for (const StraightPath::State& state : path.states(from, to, places)) positions.push_back(state.linkage);
  constexpr bool realigned = false;
  return line_output(std::move(positions), line, realigned);
}

// Over the stroke that is asked for; where there is none, or the point does not go so far, over the usable length.
std::optional<LinkageOutput> line_output_of(const TracingFourBar& linkage, const StraightLineFamily& family,
                                            int places) {
  const DirectedLine& line = family.task().line;
  if (const auto asked = family.stroke()) {
    const auto [from, to] = *asked;
    const double room = 1e-6 * (to - from);  // a path is traced both ways from where the linkage lies
    const auto path =
        StraightPath::of(linkage, line.direction, {.from = std::min(from, -room), .to = std::max(to, room)});
    if (path && path->reaches(from, to)) return line_output_over(*path, from, to, line, places);
  }
  const LineMeasuring& by = family.measuring();
  const double deviation = by.deviation_of(linkage);
  const bool is_strip = by.measure == LineMeasure::strip;
  const auto path = StraightPath::of(linkage, line.direction, {.max_deviation = (is_strip ? 2.1 : 1.1) * deviation});
  if (!path) return std::nullopt;
  const UsableLine usable = is_strip ? path->usable_strip(deviation) : path->usable(deviation);
  return line_output_over(*path, usable.from, usable.to, line, places);
}

OutputAt outputs_of_four_bars(const FourBarFamily& family, bool is_function, double turning_length) {
  return [&family, is_function, turning_length](MapPoint place) -> std::optional<LinkageOutput> {
    const auto links = family.dyad_pair(place);
    const auto bars = links ? four_bar_of(*links) : std::nullopt;
    if (!bars) return std::nullopt;
    const WorkingFrame& frame = family.frame();
    const FourBar user = {frame.to_user(bars->input_center), frame.to_user(bars->input_circle),
                          frame.to_user(bars->output_center), frame.to_user(bars->output_circle)};
    return planar_output(user, family.user_poses(place, user), is_function, turning_length);
  };
}

OutputAt outputs_of_spherical(const SphericalFamily& family, bool is_function) {
  return [&family, is_function](MapPoint place) -> std::optional<LinkageOutput> {
    const auto links = family.dyad_pair(place);
    if (!links) return std::nullopt;
    const SphericalFourBar bars = family.four_bar(*links);
    return spherical_output(bars, family.orientations(place, bars), is_function);
  };
}

OutputAt outputs_of_kind(const MotionTask& /*task*/, const LinkageFamily& family, double turning_length) {
  constexpr bool is_function = false;
  return outputs_of_four_bars(static_cast<const FourBarFamily&>(family), is_function, turning_length);
}
OutputAt outputs_of_kind(const FunctionTask& /*task*/, const LinkageFamily& family, double turning_length) {
  constexpr bool is_function = true;
  return outputs_of_four_bars(static_cast<const FourBarFamily&>(family), is_function, turning_length);
}
OutputAt outputs_of_kind(const SphericalMotionTask& /*task*/, const LinkageFamily& family, double /*turning_length*/) {
  constexpr bool is_function = false;
  return outputs_of_spherical(static_cast<const SphericalFamily&>(family), is_function);
}
OutputAt outputs_of_kind(const SphericalFunctionTask& /*task*/, const LinkageFamily& family,
                         double /*turning_length*/) {
  constexpr bool is_function = true;
  return outputs_of_spherical(static_cast<const SphericalFamily&>(family), is_function);
}
OutputAt outputs_of_kind(const SixBarTask& task, const LinkageFamily& family, double turning_length) {
  return [&chain = static_cast<const ChainFamily&>(family), task,
          turning_length](MapPoint place) -> std::optional<LinkageOutput> {
    const auto member = chain.member(place);
    if (!member) return std::nullopt;
    return six_bar_output(task, *member, turning_length);
  };
}
OutputAt outputs_of_kind(const StraightLineTask& /*task*/, const LinkageFamily& family, double /*turning_length*/) {
  return [&lines = static_cast<const StraightLineFamily&>(family)](MapPoint place) -> std::optional<LinkageOutput> {
    const LineDesign design = lines.design(place);
    if (design.kind != DesignKind::four_bar) return std::nullopt;
    return line_output_of(design.linkage, lines, places_of_cell);
  };
}

/// The error of a linkage, infinite at a dead point.
class OutputError : public CellMeasure {
 public:
  OutputError(OutputAt output_at, const Tolerances& tolerances)
      : CellMeasure(measures::tolerance_error), output_at_(std::move(output_at)), tolerances_(tolerances) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    const auto output = output_at_(place);
    if (!output) return std::nullopt;
    const auto error = first_order_error(*output, tolerances_);
    return error ? readable_error(*output, *error) : std::numeric_limits<double>::infinity();
  }

 private:
  OutputAt output_at_;
  Tolerances tolerances_;
};

/// The same of a chain's six-bars: those of a row have their link 4 in common.
class SixBarOutputError : public OutputError {
 public:
  SixBarOutputError(OutputAt output_at, SixBarTask task, const ChainFamily& family, const Tolerances& tolerances)
      : OutputError(std::move(output_at), tolerances),
        task_(std::move(task)),
        family_(family.six_bars()),
        tolerances_(tolerances) {}

  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    return [this, &map](std::size_t row, std::span<float> values) {
      std::fill(values.begin(), values.end(), 0.0F);
      const auto first = family_.with_first(map.input_coordinates()[row]);
      if (!first) return;
      for (std::size_t column = 0; column < values.size(); ++column) {
        if (map.type(map.index(row, column)) == LinkageType::degenerate) continue;
        const auto six_bar = family_.member(*first, family_.second_tau(*first, map.output_coordinates()[column]));
        if (!six_bar) continue;
        const auto error =
            first_order_error(six_bar_output(task_, *six_bar, tolerances_.turning_length.value_or(0)), tolerances_);
        values[column] = static_cast<float>(error.value_or(std::numeric_limits<double>::infinity()));
      }
    };
  }

 private:
  SixBarTask task_;
  const SixBarFamily& family_;
  Tolerances tolerances_;
};

/// The same of planar four-bars, whole rows at once.
class FourBarOutputError : public OutputError {
 public:
  FourBarOutputError(OutputAt output_at, const FourBarFamily& family, const Tolerances& tolerances)
      : OutputError(std::move(output_at), tolerances), family_(family), tolerances_(tolerances) {}

  [[nodiscard]] Rows rows_of(const RegionMap& map) const override { return four_bar_errors(family_, map, tolerances_); }

 private:
  const FourBarFamily& family_;
  Tolerances tolerances_;
};

/// The same of spherical four-bars that visit the same orientations.
class SphericalOutputError : public OutputError {
 public:
  SphericalOutputError(OutputAt output_at, const SphericalProductFamily& family, const Tolerances& tolerances)
      : OutputError(std::move(output_at), tolerances), family_(family), tolerances_(tolerances) {}

  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    return spherical_errors(family_, map, tolerances_);
  }

 private:
  const SphericalProductFamily& family_;
  Tolerances tolerances_;
};

class OutputYield : public CellMeasure {
 public:
  /// `like`: with the same parameters as all outputs; nothing where they differ in these.
  OutputYield(OutputAt output_at, const std::optional<LinkageOutput>& like, const Tolerances& tolerances)
      : CellMeasure(measures::yield), output_at_(std::move(output_at)), tolerances_(tolerances) {
    if (like) sampler_.emplace(*like, tolerances);
  }

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    const auto output = output_at_(place);
    if (!output) return std::nullopt;
    constexpr int one_thread = 1;
    const SampledErrors errors =
        sampler_ ? sampler_->errors_of(*output) : sample_errors(*output, tolerances_, one_thread);
    return errors.yield ? std::optional(errors.yield->share) : std::nullopt;
  }

 private:
  OutputAt output_at_;
  Tolerances tolerances_;
  std::optional<ToleranceSampler> sampler_;
};

// Six-bars differ in which of their bodies are ternary.
std::optional<LinkageOutput> output_like(const LinkageFamily& family) {
  if (dynamic_cast<const ChainFamily*>(&family) != nullptr) return std::nullopt;
  if (dynamic_cast<const SphericalFamily*>(&family) != nullptr) return SphericalOutput{};
  return PlanarOutput{};
}

}  // namespace

OutputAt outputs_of(const Task& task, const LinkageFamily& family, double turning_length) {
  return std::visit([&](const auto& of_kind) { return outputs_of_kind(of_kind, family, turning_length); }, task);
}

AddedMeasures tolerance_measures(const Task& task, const LinkageFamily& family, const Tolerances& tolerances) {
  const OutputAt output_at = outputs_of(task, family, tolerances.turning_length.value_or(0));
  AddedMeasures added;
  if (const auto* four_bars = dynamic_cast<const FourBarFamily*>(&family))
    added.tolerance_error = std::make_shared<FourBarOutputError>(output_at, *four_bars, tolerances);
  else if (const auto* spherical = dynamic_cast<const SphericalProductFamily*>(&family))
    added.tolerance_error = std::make_shared<SphericalOutputError>(output_at, *spherical, tolerances);
  else if (const auto* chain = dynamic_cast<const ChainFamily*>(&family))
    added.tolerance_error =
        std::make_shared<SixBarOutputError>(output_at, std::get<SixBarTask>(task), *chain, tolerances);
  else
    added.tolerance_error = std::make_shared<OutputError>(output_at, tolerances);
  added.of_passing = dynamic_cast<const StraightLineFamily*>(&family) != nullptr;
  if (!tolerances.limit) return added;
  Tolerances coarse = tolerances;
  coarse.samples = std::min(tolerances.samples, map_samples);
  added.yield = std::make_shared<OutputYield>(output_at, output_like(family), coarse);
  return added;
}

double margin_of_yield(double required, const Tolerances& tolerances) {
  constexpr double deviations = 2.5;
  if (!(required > 0) || tolerances.samples <= map_samples) return 0;
  return std::min(deviations * std::sqrt(required * (1 - required) / map_samples), 1 - required);
}

double readable_error(const LinkageOutput& output, double error) { return is_angle(output) ? degrees(error) : error; }

namespace {

std::optional<LinkageOutput> output_of(const MotionAnswer& answer, const FourBarSolution& found,
                                       double turning_length) {
  constexpr bool is_function = false;
  const auto poses = answer.family()->user_poses(answer.point_of(found), found.four_bar);
  return planar_output(found.four_bar, poses, is_function, turning_length);
}
std::optional<LinkageOutput> output_of(const FunctionAnswer& answer, const FourBarSolution& found,
                                       double turning_length) {
  constexpr bool is_function = true;
  const auto poses = answer.family()->user_poses(answer.point_of(found), found.four_bar);
  return planar_output(found.four_bar, poses, is_function, turning_length);
}
std::optional<LinkageOutput> output_of(const SphericalMotionAnswer& answer, const SphericalSolution& found,
                                       double /*turning_length*/) {
  constexpr bool is_function = false;
  return spherical_output(found.four_bar, answer.family()->orientations(answer.point_of(found), found.four_bar),
                          is_function);
}
std::optional<LinkageOutput> output_of(const SphericalFunctionAnswer& answer, const SphericalSolution& found,
                                       double /*turning_length*/) {
  constexpr bool is_function = true;
  return spherical_output(found.four_bar, answer.family()->orientations(answer.point_of(found), found.four_bar),
                          is_function);
}
std::optional<LinkageOutput> output_of(const SixBarAnswer& answer, const SixBarSolution& found, double turning_length) {
  return six_bar_output(answer.task, found.member, turning_length);
}
std::optional<LinkageOutput> output_of(const StraightLineAnswer& answer, const StraightLineSolution& found,
                                       double /*turning_length*/) {
  return line_output_of(found.linkage, StraightLineFamily(found.task, answer.options.line), places_of_line);
}

}  // namespace

std::vector<std::optional<LinkageOutput>> listed_outputs(const Answer& answer, double turning_length) {
  std::vector<std::optional<LinkageOutput>> outputs;
  std::visit(
      [&](const auto& of_kind) {
        for (const auto& found : of_kind.linkages) outputs.push_back(output_of(of_kind, found, turning_length));
      },
      answer);
  return outputs;
}

ToleranceStudy tolerance_study(const Problem& problem, const Answer& answer, std::size_t place) {
  const Findings& found = findings(answer);
  const Tolerances& tolerances = *found.options.tolerances;
  const auto outputs = listed_outputs(answer, tolerances.turning_length.value_or(0));
  return {problem.title, problem.length_unit, tolerances, *outputs[place], *found.tolerance[place]};
}

}  // namespace linkwright
