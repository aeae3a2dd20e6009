#include "four_bar_session.hpp"

#include <algorithm>
#include <cmath>

#include "function_reply.hpp"
#include "linkage_reply.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/missed_box.hpp"
#include "linkwright/region/improved_linkage.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

// With a free parameter the curve is another at each value of it.
bool lies_along_its_curve(const TaskFamily& task, Side side) {
  if (!task.curve || !task.family) return task.curve != nullptr;
  const MapAxis& axis = task.family->axis(side);
  return axis.quantity == AxisQuantity::curve_coordinate && axis.branches.size() == task.curve->branches().size();
}

// Those of the usual map, so that its cells are solve()'s.
constexpr int samples_of_an_order = 400;

// Of a map with a curve of its own to each column.
constexpr int max_samples_over_a_free_parameter = 500;

const std::vector<PrescribedPose> no_poses;

}  // namespace

const Notice& FourBarSession::no_map() const {
  static const Notice none{"no_map", "There is no map of this task.", {}};
  return given_.degeneracy ? *given_.degeneracy : none;
}

const Notice& FourBarSession::nothing_on_map() const {
  static const Notice no_pair{
      "no_pair",
      "No pair of dyads makes a four-bar: in every pair a pivot is at infinity or a link has no length.",
      {}};
  return no_pair;
}

Requirements FourBarSession::with_defaults(Requirements wanted) const {
  return linkwright::with_defaults(std::move(wanted), given_);
}

TaskReply FourBarSession::about() const {
  TaskReply reply{given_.pattern, given_.conditions.condition(), given_.frame().scale, given_.warnings, {}, {}};
  reply.write_curves = [this](JsonWriter& json) { write_curves(json, given_); };
  return reply;
}

Drawn FourBarSession::drawn() const {
  Drawn drawn{drawn_curves(poses(), given_, Side::input), {}};
  if (given_.family && !given_.family->is_symmetric()) drawn.output = drawn_curves(poses(), given_, Side::output);
  return drawn;
}

ShownAxis FourBarSession::ordered(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown,
                                  Side side) const {
  ShownAxis ordered;
  if (given_.family) {
    ordered.axis = given_.family->axis(side);
    ordered.ticks = axis_ticks(*given_.family, side);
  } else if (given_.curve) {
    ordered.axis.branches = given_.curve->branches();
  }
  if (!lies_along_its_curve(given_, side))
    ordered.order =
        given_.family && !ordered.axis.is_discrete()
            ? DisplayOrder(ordered.axis.branches, given_.family->samples(side, samples_of_an_order, spacing))
            : DisplayOrder(ordered.axis.branches);
  else if (request.order == ExploreRequest::nearest_order && shown)
    ordered.order = DisplayOrder::nearest(*given_.curve, spacing, given_.frame(), shown->of(side).order);
  else
    ordered.order = DisplayOrder(*given_.curve, spacing, given_.frame(), std::max(request.order, 0));
  return ordered;
}

ShownAxes FourBarSession::axes(const ExploreRequest& request, Spacing spacing, const ShownAxes* shown) const {
  ShownAxis input = ordered(request, spacing, shown, Side::input);
  const bool same = !given_.family || given_.family->is_symmetric();
  ShownAxis output = same ? input : ordered(request, spacing, shown, Side::output);
  return {std::move(input), std::move(output), same};
}

std::vector<double> FourBarSession::coordinates(const ExploreRequest& request, const ShownAxis& axis, Side side) const {
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  const int samples = map_samples(request.samples);
  if (axis.axis.is_discrete()) return given_.family->samples(side, samples, Spacing::coordinate);
  if (lies_along_its_curve(given_, side) && from == ExploreRequest::whole[0] && to == ExploreRequest::whole[1])
    return axis.order.samples(*given_.curve, samples);
  return axis.order.samples(samples, from, to);
}

std::vector<MissedBox> FourBarSession::missed_boxes(const Requirements& wanted) const {
  return linkwright::missed_boxes(*given_.family, wanted);
}

LinkageReply FourBarSession::linkage(MapPoint place, FailureBits fails, bool respect_direction) const {
  PickedLinkage picked = picked_linkage(given_, place, respect_direction);
  picked.fails = fails;
  LinkageReply reply{linkage_json(picked, given_.frame()), {}};
  append_states(picked, reply.states);
  return reply;
}

Verification FourBarSession::verify(MapPoint place, bool respect_direction) const {
  constexpr bool by_driving = true;
  const auto driven = make_four_bar(given_, place, respect_direction, by_driving);
  if (!driven) return {};
  return {driven->verified_by_driving,
          std::max(driven->input_residual * driven->lengths.input, driven->output_residual * driven->lengths.output)};
}

std::vector<double> FourBarSession::trace(MapPoint place, Point traced, bool respect_direction) const {
  std::vector<double> path;
  if (!given_.family) return path;
  const PickedLinkage picked = picked_linkage(given_, place, respect_direction);
  if (!picked.bars) return path;
  const Pose first = given_.family->user_poses(place, picked.bars->four_bar).front().pose;
  for (const DriveState& state : picked.drive.states) {
    const Point p = displaced(traced, first, state.body);
    path.insert(path.end(), {p.real(), p.imag()});
  }
  return path;
}

std::optional<MapPoint> FourBarSession::improved(MapPoint place, const Wish& wish) const {
  return given_.family ? improved_linkage(*given_.family, wish.requirements, wish.objective, place, wish.added)
                       : std::nullopt;
}

int FourBarSession::samples_for_best() const { return samples_of_an_order; }

MotionSession::MotionSession(const MotionTask& task, const Problem& problem)
    : FourBarSession(task_family(task, problem.requirements, problem.options.objective)), task_(task) {}

bool MotionSession::serves(const Problem& problem) const {
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  return motion && *motion == task_ && !task_.given;  // of what is given a length is chosen by the requirements
}

bool MotionSession::measure(EvaluatedMap& map, std::string_view property) const {
  if (property != "pose_miss" || !given().relaxed) return false;
  map.show([&](std::span<float> values) {
    pose_errors(*given().family, map.map(), map.fails(), *given().relaxed, values);
    for (float& value : values) value = std::max(value, 0.0F);
  });
  return true;
}

std::optional<Answer> MotionSession::answer_at(MapPoint place, bool respect_direction) const {
  constexpr bool verify = true;
  MotionAnswer answer;
  answer.task = task_;
  return answer_with(std::move(answer), make_four_bar(given(), place, respect_direction, verify));
}

FunctionSession::FunctionSession(const FunctionTask& task)
    : FourBarSession(task_family(task)), task_(task), family_(given().functions) {}

const std::vector<PrescribedPose>& FunctionSession::poses() const { return no_poses; }

bool FunctionSession::serves(const Problem& problem) const {
  const auto* function = std::get_if<FunctionTask>(&problem.task);
  return function && *function == task_;
}

TaskReply FunctionSession::about() const {
  TaskReply reply = FourBarSession::about();
  reply.write_function = [this](JsonWriter& json) { write_wanted_function(json, task_); };
  return reply;
}

int FunctionSession::map_samples(int asked) const {
  return task_.free ? std::min(asked, max_samples_over_a_free_parameter) : asked;
}

bool FunctionSession::measure(EvaluatedMap& map, std::string_view property) const {
  if (property != "max_structural_error_deg" || !task_.function || task_.free) return false;
  map.show([&](std::span<float> values) { structural_errors_deg(*family_, map.map(), values); });
  return true;
}

std::optional<MapPoint> FunctionSession::improved(MapPoint place, const Wish& wish) const {
  if (family_ && wish.objective == Objective::structural_error)
    return improved_generator(*family_, wish.requirements, place, wish.added);
  return FourBarSession::improved(place, wish);
}

std::optional<Answer> FunctionSession::answer_at(MapPoint place, bool respect_direction) const {
  constexpr bool verify = true;
  auto found = make_four_bar(given(), place, respect_direction, verify);
  if (found && family_) found->function = family_->error_of(found->four_bar, place);
  FunctionAnswer answer;
  answer.task = task_;
  return answer_with(std::move(answer), std::move(found));
}

void write_best_linkages(JsonWriter& json, const FourBarAnswer& answer) {
  for (const FourBarSolution& found : answer.linkages) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.key("tau");
    write_numbers(json, std::array{found.input.coordinate, found.output.coordinate});
    json.member("type", name(found.report.type));
    json.member("min_transmission_angle_deg", degrees(found.report.min_transmission_angle));
    json.member("link_ratio", found.lengths.longest() / found.lengths.shortest());
    json.member("longest", found.lengths.longest());
    json.key("max_structural_error_deg");
    const bool known = found.function && found.function->max_structural_error;
    known ? json.value(degrees(*found.function->max_structural_error)) : json.null();
    json.key("pivots");
    const FourBar& bars = found.four_bar;
    write_points(json, std::array{bars.input_center, bars.input_circle, bars.output_center, bars.output_circle});
    json.end_object();
  }
}

}  // namespace linkwright::wasm
