#include "session.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "files/task_writer.hpp"
#include "function_reply.hpp"
#include "linkage_reply.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/planar/function_family.hpp"
#include "linkwright/planar/function_search.hpp"
#include "linkwright/planar/improved_linkage.hpp"
#include "linkwright/planar/missed_box.hpp"
#include "linkwright/planar/pose_halo.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

std::string task_text(const Task& task) {
  return json_of([&](JsonWriter& json) { write_task(json, task); });
}

// The engine chooses a length of such a task by the requirements.
bool depends_on_requirements(const Task& task) {
  const auto* motion = std::get_if<MotionTask>(&task);
  return motion && motion->given;
}

TaskFamily family_of(const Problem& problem) {
  if (const auto* motion = std::get_if<MotionTask>(&problem.task))
    return task_family(*motion, problem.requirements, problem.options.objective);
  if (const auto* function = std::get_if<FunctionTask>(&problem.task)) return task_family(*function);
  return {};
}

// With a free number the curve is another at each value of it.
bool lies_along_its_curve(const TaskFamily& task, Side side) {
  if (!task.curve || !task.family) return task.curve != nullptr;
  const MapAxis& axis = task.family->axis(side);
  return axis.quantity == AxisQuantity::curve_coordinate && axis.branches.size() == task.curve->branches().size();
}

// Those of the usual map, so that its cells are solve()'s.
constexpr int samples_of_an_order = 400;

// Each cell of such a map is driven through.
int six_bar_samples(int samples) { return std::clamp(samples / 5, 20, 60); }

// Of a map with a curve of its own to each column.
constexpr int most_samples_over_a_free_number = 500;

constexpr std::array<double, 2> whole = {0, 1};

const Notice no_pair = {
    "no_pair",
    "No pair of side links makes a four-bar: in every pair a pivot is at infinity or a link has no length.",
    {}};

const Notice no_map = {"no_map", "There is no map of this task yet: a six-bar needs a chain first.", {}};

}  // namespace

bool Session::set_problem(std::string_view text) {
  if (given_ && text == text_) return true;
  auto read = read_problem(text);
  mistakes_ = read ? "[]" : mistakes_json(read.errors());
  if (!read) return false;
  text_ = text;
  const bool unchanged =
      given_ && task_text(problem_.task) == task_text(read->task) && !depends_on_requirements(read->task);
  problem_ = std::move(*read);
  if (!unchanged) {
    const auto* six_bar = std::get_if<SixBarTask>(&problem_.task);
    six_bars_ = six_bar ? std::optional<SixBarMap>(*six_bar) : std::nullopt;
    given_ = six_bars_ ? six_bars_->given() : family_of(problem_);
    drawn_.reset();
    mapped_.reset();
  }
  requirements_ = with_defaults(problem_.requirements, given());
  return true;
}

std::string Session::read(std::string_view text) {
  const auto problem = read_problem(text);
  mistakes_ = problem ? "[]" : mistakes_json(problem.errors());
  return problem ? write_problem(*problem) : "";
}

const TaskFamily& Session::given() const {
  if (!given_) std::abort();  // a problem is set before anything is asked
  return *given_;
}

const std::vector<PrescribedPose>& Session::poses() const {
  static const std::vector<PrescribedPose> none;
  if (const auto* six_bar = std::get_if<SixBarTask>(&problem_.task)) return six_bar->poses;
  const auto* motion = std::get_if<MotionTask>(&problem_.task);
  return motion ? motion->poses : none;
}

const LinkageFamily* Session::family() const {
  return six_bars_ ? static_cast<const LinkageFamily*>(six_bars_->family().get()) : given().family.get();
}

bool Session::has_map() const { return family() != nullptr; }

void Session::classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const {
  family()->classify(map, input, output, requirements_.respect_direction);
}

RequirementFilter Session::filter(const RegionMap& map) const { return filter_of(*family(), map, requirements_); }

const ShownAxes& Session::axes() const {
  if (!axes_) std::abort();  // the axes are ordered before a map is made
  return *axes_;
}

const Session::Drawn& Session::drawn() {
  if (!drawn_ && six_bars_) drawn_ = {six_bars_->drawn(Side::input), six_bars_->drawn(Side::output)};
  if (!drawn_) {
    drawn_ = {drawn_curves(poses(), given(), Side::input), {}};
    if (given().family && !given().family->is_symmetric())
      drawn_->output = drawn_curves(poses(), given(), Side::output);
  }
  return *drawn_;
}

ShownAxis Session::ordered(const ExploreRequest& request, Side side) const {
  const TaskFamily& task = given();
  ShownAxis ordered;
  if (task.family) {
    ordered.axis = task.family->axis(side);
    ordered.ticks = axis_ticks(*task.family, side);
  } else if (task.curve) {
    ordered.axis.branches = task.curve->branches();
  }
  const Spacing spacing = problem_.options.spacing;
  if (!lies_along_its_curve(task, side))
    ordered.order = task.family && !ordered.axis.is_discrete()
                        ? DisplayOrder(ordered.axis.branches, task.family->samples(side, samples_of_an_order, spacing))
                        : DisplayOrder(ordered.axis.branches);
  else if (request.order == ExploreRequest::nearest_order && axes_)
    ordered.order = DisplayOrder::nearest(*task.curve, spacing, task.frame(), axes_->of(side).order);
  else
    ordered.order = DisplayOrder(*task.curve, spacing, task.frame(), std::max(request.order, 0));
  return ordered;
}

void Session::order_axes(const ExploreRequest& request) {
  if (six_bars_) {
    axes_ = six_bars_->axes();
    return;
  }
  ShownAxis input = ordered(request, Side::input);
  const bool same = !given().family || given().family->is_symmetric();
  ShownAxis output = same ? input : ordered(request, Side::output);
  axes_ = ShownAxes{std::move(input), std::move(output), same};
}

std::vector<double> Session::coordinates(const ExploreRequest& request, Side side) const {
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  const ShownAxis& axis = axes().of(side);
  const DisplayOrder& order = axis.order;
  const int samples = map_samples(request);
  if (six_bars_) return order.samples(samples, from, to);
  if (axis.axis.is_discrete()) return given().family->samples(side, samples, Spacing::coordinate);
  if (lies_along_its_curve(given(), side) && from == whole[0] && to == whole[1])
    return order.samples(*given().curve, samples);
  return order.samples(samples, from, to);
}

int Session::map_samples(const ExploreRequest& request) const {
  if (six_bars_) return six_bar_samples(request.samples);
  const auto* function = std::get_if<FunctionTask>(&problem_.task);
  return function && function->free ? std::min(request.samples, most_samples_over_a_free_number) : request.samples;
}

void Session::compute_map(const ExploreRequest& request) {
  const MapKey wanted{map_samples(request), axes().input.order.code(), request.input,
                      request.output,       problem_.options.spacing,  requirements_.respect_direction};
  if (mapped_ != wanted) {
    mapped_.reset();  // nothing is shown of the last one should memory run out half way
    input_tau_ = coordinates(request, Side::input);
    output_tau_ = coordinates(request, Side::output);
    map_.classify([&](RegionMap& map) { classify(map, input_tau_, output_tau_); });
    mapped_ = wanted;
  }
  map_.judge(filter(map_.map()));
  if (map_.census().meeting == 0 && given().family)
    map_.note_missed_boxes(missed_boxes(*given().family, requirements_));
  if (request.pose_miss && given().freed)
    map_.measure_miss(*given().family, *given().freed);
  else if (const auto* function = std::get_if<FunctionTask>(&problem_.task);
           request.structural_error && function && function->function && !function->free)
    map_.measure_error(*function_family(given()));
  else
    map_.measure(request.property);
}

ExploreReply Session::explore(const ExploreRequest& request) {
  order_axes(request);
  ExploreReply reply;
  reply.input_curves = &drawn().input;
  reply.output_curves = drawn().output ? &*drawn().output : nullptr;
  std::string_view status = "solved";
  const Notice* reason = nullptr;
  if (!has_map()) {
    status = "degenerate";
    reason = given().degeneracy ? &*given().degeneracy : &no_map;
  } else {
    compute_map(request);
    reply.map = &map_;
    reply.census = map_.census_json();
    reply.input_tau = input_tau_;
    reply.output_tau = output_tau_;
    const RegionCounts& counts = map_.counts();
    if (counts.pairs == counts.types[static_cast<std::size_t>(LinkageType::degenerate)] && request.input == whole &&
        request.output == whole) {
      status = "no_solution";
      reason = &no_pair;
    }
  }
  reply.task = task_json(given(), drawn().input.marks, axes(), requirements_, status, reason,
                         std::get_if<FunctionTask>(&problem_.task));
  return reply;
}

LinkageReply Session::linkage(double input_tau, double output_tau) {
  LinkageReply reply;
  if (!has_map()) return reply;
  if (six_bars_) {
    const std::uint8_t fails = failures(cell_, std::array{input_tau}, std::array{output_tau}).front();
    SixBarReply six_bar =
        six_bar_reply(poses(), six_bars_->at({input_tau, output_tau}), {input_tau, output_tau}, fails);
    return {std::move(six_bar.linkage), std::move(six_bar.states)};
  }
  PickedLinkage picked = picked_linkage(given(), {input_tau, output_tau}, requirements_.respect_direction);
  // By the map's own kernel, so that the card and the cell agree to the last bit.
  picked.fails = failures(cell_, std::array{input_tau}, std::array{output_tau}).front();
  reply.linkage = linkage_json(picked, given().frame());
  append_states(picked, reply.states);
  return reply;
}

std::vector<std::uint8_t> Session::failures(RegionMap& map, std::span<const double> input,
                                            std::span<const double> output) const {
  classify(map, input, output);
  std::vector<std::uint8_t> found(map.rows() * map.columns());
  filter(map).failures_of_all(found);
  return found;
}

LiveReply Session::live(double input_tau, double output_tau) {
  LiveReply reply;
  if (!has_map()) return reply;
  const Drawn& curves = drawn();
  reply.input = failures(strip_, curves.input.tau, std::array{output_tau});
  // Where nothing is left to choose of the output, it moves with the input.
  if (given().family && given().family->axis(Side::output).quantity == AxisQuantity::nothing)
    reply.output = reply.input;
  else
    reply.output = failures(strip_, std::array{input_tau}, (curves.output ? *curves.output : curves.input).tau);
  return reply;
}

std::vector<std::uint32_t> Session::halo(const HaloRequest& request) const {
  const auto* motion = std::get_if<MotionTask>(&problem_.task);
  if (!motion) return {};
  const PoseHalo halo(*motion, problem_.requirements, problem_.options.spacing, request.samples);
  const auto pose = static_cast<std::size_t>(request.pose);
  return request.turn ? halo.turned(pose, request.reach, request.steps)
                      : halo.moved(pose, request.reach, request.steps);
}

namespace {

SixBarTask with_chain(SixBarTask task, const ThreeLinkChain& chain) {
  task.chain = chain;
  return task;
}

template <class Points, class PointOf = std::identity>
void write_points(JsonWriter& json, const Points& points, PointOf point_of = {}) {
  json.begin_list(JsonWriter::Layout::one_line);
  for (const auto& item : points) write_point(json, point_of(item));
  json.end_list();
}

// With their chains: of a search each has one of its own.
void write_six_bars(JsonWriter& json, const SixBarTask& task, const Solution& solution) {
  for (const SixBarSolution& found : solution.six_bars) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.key("tau");
    const auto family = ChainFamily::of(with_chain(task, found.chain));
    const MapPoint point = family->point_of(found.member);
    write_numbers(json, std::array{point.input, point.output});
    json.member("type", name(found.rating.shape.type));
    json.member("min_transmission_angle_deg", degrees(found.rating.min_transmission_angle()));
    json.member("link_ratio", found.rating.shape.link_ratio);
    json.member("longest", found.rating.shape.longest);
    json.key("pivots");
    write_points(json, found.member.six_bar.joints, [](const SixBarJoint& joint) { return joint.point; });
    json.key("chain");
    write_chain(json, found.chain);
    json.end_object();
  }
}

void write_four_bars(JsonWriter& json, const std::vector<FourBarSolution>& list) {
  for (const FourBarSolution& found : list) {
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

// What the list of the best is to be read with: why it is empty, and what was not known of the task before.
void write_notices(JsonWriter& json, const Solution& solution, const std::vector<Notice>& known) {
  if (solution.linkages.empty() && solution.six_bars.empty()) write_notice(json, solution.reason);
  for (const Notice& warning : solution.given.warnings)
    if (std::none_of(known.begin(), known.end(), [&](const Notice& notice) { return notice.code == warning.code; }))
      write_notice(json, warning);
}

}  // namespace

std::string Session::best(int most) const {
  SynthesisOptions options = problem_.options;
  options.region_samples = samples_of_an_order;
  if (six_bars_) options.region_samples = 4 * six_bar_samples(samples_of_an_order);  // of which solve() takes a quarter
  options.window.reset();
  options.best = most;
  const auto solution = solve(problem_.task, problem_.requirements, options);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("linkages");
    json.begin_list();
    if (const auto* six_bar = std::get_if<SixBarTask>(&problem_.task); six_bar && solution)
      write_six_bars(json, *six_bar, *solution);
    if (solution) write_four_bars(json, solution->linkages);
    json.end_list();
    json.key("notices");
    json.begin_list();
    if (solution) write_notices(json, *solution, given().warnings);
    json.end_list();
    json.end_object();
  });
}

std::string Session::improve(double input_tau, double output_tau) const {
  const auto better = improved({input_tau, output_tau});
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("tau");
    write_numbers(json, better ? std::array{better->input, better->output} : std::array{input_tau, output_tau});
    json.member("improved", better.has_value());
    json.end_object();
  });
}

std::optional<MapPoint> Session::improved(MapPoint place) const {
  const Objective objective = problem_.options.objective;
  if (six_bars_)
    return six_bars_->has_chain() ? improved_six_bar(*six_bars_->family(), requirements_, objective, place)
                                  : std::nullopt;
  const FunctionFamily* family = function_family(given());
  if (family && objective == Objective::structural_error) return improved_generator(*family, requirements_, place);
  if (!given().family) return std::nullopt;
  return improved_linkage(*given().family, requirements_, objective, place);
}

std::string Session::verify(double input_tau, double output_tau) {
  if (six_bars_) {
    const auto found = six_bars_->at({input_tau, output_tau});
    return json_of([&](JsonWriter& json) {
      json.begin_object();
      json.member("verified", found && found->verified_by_driving);
      json.member("residual", found ? found->residual * found->rating.shape.longest : 0.0);
      json.end_object();
    });
  }
  constexpr bool by_driving = true;
  const auto driven = make_four_bar(given(), {input_tau, output_tau}, requirements_.respect_direction, by_driving);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("verified", driven && driven->verified_by_driving);
    json.member("residual", driven ? std::max(driven->input_residual * driven->lengths.input,
                                              driven->output_residual * driven->lengths.output)
                                   : 0.0);
    json.end_object();
  });
}

std::vector<double> Session::trace(double input_tau, double output_tau, Point traced) {
  std::vector<double> path;
  if (six_bars_) return six_bar_trace(poses(), six_bars_->at({input_tau, output_tau}), traced);
  if (!given().family) return path;
  const PickedLinkage picked = picked_linkage(given(), {input_tau, output_tau}, requirements_.respect_direction);
  if (!picked.bars) return path;
  const Pose first = given().family->user_poses({input_tau, output_tau}, picked.bars->four_bar).front().pose;
  for (const DriveState& state : picked.drive.states) {
    const Point p = displaced(traced, first, state.body);
    path.insert(path.end(), {p.real(), p.imag()});
  }
  return path;
}

std::optional<Solution> Session::solution_at(double input_tau, double output_tau) const {
  Solution solution;
  if (six_bars_) {
    const auto found = six_bars_->at({input_tau, output_tau});
    if (!found) return std::nullopt;
    solution.chain = six_bars_->family();
    solution.six_bars = {*found};
  } else {
    constexpr bool verify = true;
    auto found = make_four_bar(given(), {input_tau, output_tau}, requirements_.respect_direction, verify);
    if (!found) return std::nullopt;
    if (const FunctionFamily* family = function_family(given()))
      found->function = family->error_of(found->four_bar, {input_tau, output_tau});
    solution.linkages = {*found};
  }
  solution.reason = {"picked", "One linkage, picked on the map.", {}};
  solution.given = given();
  solution.requirements = requirements_;
  solution.options = problem_.options;
  return solution;
}

std::string Session::exported(double input_tau, double output_tau, std::string_view format) const {
  const auto solution = solution_at(input_tau, output_tau);
  if (!solution) return "";
  std::string result = write_result(problem_, *solution, false);
  if (format == "result") return result;
  const auto linkages = read_any_result_linkages(result);
  return linkages && !linkages->empty() ? linkwright::exported(linkages->front(), format) : "";
}

}  // namespace linkwright::wasm
