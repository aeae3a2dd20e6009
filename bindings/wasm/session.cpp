#include "session.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>

#include "four_bar_session.hpp"
#include "halo.hpp"
#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/machine/print_file.hpp"
#include "linkwright/machine/simulator_file.hpp"
#include "linkwright/region/pareto_front.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "linkwright/synthesis/tolerance_measures.hpp"
#include "machine_reply.hpp"
#include "opened_linkage.hpp"
#include "region/window_look.hpp"
#include "reply_json.hpp"
#include "six_bar_session.hpp"
#include "spherical_function_session.hpp"
#include "spherical_session.hpp"
#include "straight_line_session.hpp"

namespace linkwright::wasm {
namespace {

constexpr bool no_yields = false;  // they come coarse to fine

std::unique_ptr<TaskSession> session_of(const MotionTask& task, const Problem& problem) {
  return std::make_unique<MotionSession>(task, problem);
}
std::unique_ptr<TaskSession> session_of(const FunctionTask& task, const Problem& /*problem*/) {
  return std::make_unique<FunctionSession>(task);
}
std::unique_ptr<TaskSession> session_of(const SixBarTask& task, const Problem& /*problem*/) {
  return std::make_unique<SixBarSession>(task);
}
std::unique_ptr<TaskSession> session_of(const SphericalMotionTask& task, const Problem& /*problem*/) {
  return std::make_unique<SphericalSession>(task);
}

std::unique_ptr<TaskSession> session_of(const SphericalFunctionTask& task, const Problem& /*problem*/) {
  return std::make_unique<SphericalFunctionSession>(task);
}
std::unique_ptr<TaskSession> session_of(const StraightLineTask& task, const Problem& problem) {
  return std::make_unique<StraightLineSession>(task, problem.options);
}

}  // namespace

std::unique_ptr<TaskSession> task_session(const Problem& problem) {
  return std::visit([&](const auto& task) { return session_of(task, problem); }, problem.task);
}

bool Session::set_problem(std::string_view text) {
  if ((task_ || opened_) && text == text_) return true;
  if (auto opened = opened_linkage(text)) {
    mistakes_ = *opened ? "[]" : mistakes_json(opened->errors());
    if (!*opened) return false;
    text_ = text;
    opened_ = std::move(**opened);
    return true;
  }
  auto read = read_problem(text);
  mistakes_ = read ? "[]" : mistakes_json(read.errors());
  if (!read) return false;
  text_ = text;
  opened_.reset();
  const bool unchanged = task_ && task_->serves(*read);
  problem_ = std::move(*read);
  if (!unchanged) {
    task_ = task_session(problem_);
    drawn_.reset();
    mapped_.reset();
  }
  requirements_ = task().with_defaults(problem_.requirements);
  set_tolerances(!unchanged);
  return true;
}

void Session::set_tolerances(bool task_is_new) {
  const SynthesisOptions options = with_turning_length(problem_.options, task().about().characteristic_length);
  if (!task_is_new && options.tolerances == tolerances_) return;
  tolerances_ = options.tolerances;
  const AddedMeasures before = std::move(added_);
  added_ = tolerances_ && family() ? tolerance_measures(*family(), *tolerances_) : AddedMeasures{};
  if ((before.tolerance_error && !added_.tolerance_error) || (before.yield && !added_.yield))
    mapped_.reset();  // its map has columns that nothing asks for any more
  tolerances_measured_ = false;
  yields_.reset();
}

std::string Session::read(std::string_view text) {
  notices_ = "[]";
  if (const auto opened = opened_linkage(text)) {
    mistakes_ = *opened ? "[]" : mistakes_json(opened->errors());
    return *opened ? std::string(text) : "";
  }
  const auto problem = read_problem(text);
  mistakes_ = problem ? "[]" : mistakes_json(problem.errors());
  if (!problem) return "";
  const auto notice = points_notice(points_of(problem->task));
  if (notice)
    notices_ = json_text_of([&](JsonWriter& json) {
      json.begin_list();
      write_notice(json, *notice);
      json.end_list();
    });
  return write_problem(*problem);
}

const TaskSession& Session::task() const {
  if (!task_) std::abort();  // a problem is set before anything is asked
  return *task_;
}

void Session::classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const {
  family()->classify(map, input, output, requirements_.respect_direction);
  added_.add_to(map, *family(), requirements_, no_yields);
}

// The map stays where only tolerances change; yields go by the cells that meet all else.
void Session::measure_tolerances(bool map_is_new) {
  if (!map_is_new && (!tolerances_measured_ || added_.of_passing))
    map_.classify([&](RegionMap& map) { added_.add_to(map, *family(), requirements_, no_yields); });
  tolerances_measured_ = true;
  if (!added_.yield) return yields_.reset();
  Requirements all_else = requirements_;
  all_else.min_yield = 0;
  const RequirementFilter passing = filter_of(*family(), map_.map(), all_else);
  std::vector<FailureBits> failures(map_.map().rows() * map_.map().columns());
  passing.failures_of_all(failures);
  std::vector<std::uint8_t> wanted(failures.size());
  std::transform(failures.begin(), failures.end(), wanted.begin(), [](FailureBits failed) { return failed == 0; });
  if (map_is_new || !yields_ || wanted != yields_of_) yields_.emplace(map_.map().rows(), map_.map().columns(), wanted);
  yields_of_ = std::move(wanted);
  map_.add(KnownYields(yields_->values()));
}

RequirementFilter Session::filter(const RegionMap& map) const { return filter_of(*family(), map, requirements_); }

const Drawn& Session::drawn() {
  if (!drawn_) drawn_ = task().drawn();
  return *drawn_;
}

void Session::compute_map(const ExploreRequest& request) {
  const MapKey wanted{task().map_samples(request.samples),
                      axes_->input.order.code(),
                      request.input,
                      request.output,
                      problem_.options.spacing,
                      requirements_.respect_direction};
  const bool is_new = mapped_ != wanted;
  if (is_new) {
    mapped_.reset();  // nothing is shown of the last one should memory run out half way
    input_tau_ = task().coordinates(request, axes_->input, Side::input);
    output_tau_ = task().coordinates(request, axes_->output, Side::output);
    map_.classify([&](RegionMap& map) { classify(map, input_tau_, output_tau_); });
    mapped_ = wanted;
  }
  measure_tolerances(is_new);
  const RequirementFilter passing = filter(map_.map());
  map_.evaluate(passing);
  if (map_.census().meeting == 0) look_closer(passing);
  if (yields_ && request.property == measures::yield.key) {
    const std::vector<float> shown = yields_->shown();
    map_.show([&](std::span<float> values) { std::copy(shown.begin(), shown.end(), values.begin()); }, true);
  } else if (!task().measure(map_, request.property)) {
    map_.measure(request.property);
  }
}

// Nothing of the map is left: there may be something between its cells, where windows are small.
void Session::look_closer(const RequirementFilter& passing) {
  const RegionMap& map = map_.map();
  const MapMaking making{[&](RegionMap& part, std::span<const double> input, std::span<const double> output) {
                           classify(part, input, output);
                         },
                         static_cast<int>(std::max(map.rows(), map.columns())), std::nullopt};
  const auto apart = [&](Side side, std::size_t count) {
    return family()->axis(side).coordinate_length() / static_cast<double>(std::max<std::size_t>(count, 1));
  };
  const SearchMap seen{&map, &passing, {apart(Side::input, map.rows()), apart(Side::output, map.columns())}};
  const WindowLook look = look_into_windows(*family(), seen, requirements_, making);
  std::vector<SearchMap> maps = {seen};
  for (const auto& closer : look.maps) maps.push_back(closer->view());
  map_.note_nothing_left(
      task().missed_boxes(requirements_), {look.looked_at, look.meeting, look.is_empty},
      look.meeting == 0 ? relaxations(*family(), maps, requirements_, making) : std::vector<Relaxation>{});
}

ExploreReply Session::explore(const ExploreRequest& request) {
  axes_ = task().axes(request, problem_.options.spacing, axes_ ? &*axes_ : nullptr);
  ExploreReply reply;
  reply.input_curves = &drawn().input;
  reply.output_curves = drawn().output ? &*drawn().output : nullptr;
  std::string_view status = "solved";
  const Notice* reason = nullptr;
  if (!family()) {
    status = "degenerate";
    reason = &task().no_map();
  } else {
    compute_map(request);
    reply.map = &map_;
    reply.census = map_.census_json();
    reply.input_tau = input_tau_;
    reply.output_tau = output_tau_;
    const RegionCounts& counts = map_.counts();
    if (counts.pairs == counts.types[static_cast<std::size_t>(LinkageType::degenerate)] &&
        request.input == ExploreRequest::whole && request.output == ExploreRequest::whole) {
      status = "no_solution";
      reason = &task().nothing_on_map();
    }
  }
  reply.task =
      task_json(task().about(), drawn().input.marks, *axes_, requirements_, linkages(problem_.task), status, reason);
  return reply;
}

LinkageReply Session::linkage(double input_tau, double output_tau) {
  if (opened_) return opened_reply(*opened_);
  if (!family()) return {};
  // By the map's own kernel, so that the card and the cell agree to the last bit.
  FailureBits fails = failures(cell_, std::array{input_tau}, std::array{output_tau}).front();
  if (fails != 0 && task().meets_exactly({input_tau, output_tau}, requirements_)) fails = 0;
  if (fails == 0 && fails_yield({input_tau, output_tau}))
    fails =
        static_cast<FailureBits>(1u << place_among(linkages(problem_.task).requirements, RequirementKind::min_yield));
  LinkageReply reply = task().linkage({input_tau, output_tau}, fails, requirements_.respect_direction);
  if (const auto output = tolerances_ ? output_at({input_tau, output_tau}) : std::nullopt)
    reply.tolerance = tolerance_at_a_glance(*output, *tolerances_);
  return reply;
}

std::vector<FailureBits> Session::failures(RegionMap& map, std::span<const double> input,
                                           std::span<const double> output) const {
  classify(map, input, output);
  std::vector<FailureBits> found(map.rows() * map.columns());
  filter(map).failures_of_all(found);
  return found;
}

LiveReply Session::live(double input_tau, double output_tau) {
  LiveReply reply;
  if (!family()) return reply;
  const Drawn& curves = drawn();
  reply.input = failures(strip_, curves.input.tau, std::array{output_tau});
  // Where nothing is left to choose of the output, it moves with the input.
  if (family()->axis(Side::output).quantity == AxisQuantity::nothing)
    reply.output = reply.input;
  else
    reply.output = failures(strip_, std::array{input_tau}, (curves.output ? *curves.output : curves.input).tau);
  return reply;
}

std::vector<std::uint32_t> Session::halo(const HaloRequest& request) const { return wasm::halo(problem_, request); }

std::optional<LinkageOutput> Session::output_at(MapPoint place) const {
  auto output = family() ? family()->output(place) : std::nullopt;
  if (!output) return std::nullopt;
  return with_turning_length(*std::move(output), tolerances_->turning_length.value_or(0));
}

bool Session::fails_yield(MapPoint place) const {
  if (!added_.yield || !(requirements_.min_yield > 0)) return false;
  return !(added_.yield->at(place).value_or(0) >= requirements_.min_yield);
}

ToleranceReply Session::tolerance(double input_tau, double output_tau, int bins, int drawn) const {
  const auto output = tolerances_ ? output_at({input_tau, output_tau}) : std::nullopt;
  return output ? tolerance_reply(*output, *tolerances_, bins, drawn) : ToleranceReply{};
}

std::string Session::sample_yields(int cells) {
  if (yields_) yields_->advance(static_cast<std::size_t>(std::max(cells, 0)), *added_.yield, input_tau_, output_tau_);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("done", static_cast<std::int64_t>(yields_ ? yields_->done() : 0));
    json.member("total", static_cast<std::int64_t>(yields_ ? yields_->total() : 0));
    json.end_object();
  });
}

namespace {

std::optional<Objective> objective_named(const LinkageClass& of, std::string_view wanted) {
  for (const Objective objective : of.objectives)
    if (name(objective) == wanted) return objective;
  return std::nullopt;
}

}  // namespace

std::string Session::front(std::string_view first, std::string_view second) const {
  const LinkageClass& asked = linkages(problem_.task);
  const auto one = objective_named(asked, first), other = objective_named(asked, second);
  const bool is_known = one && other && mapped_ && family() && !map_.map().values(measure_of(*one)).empty() &&
                        !map_.map().values(measure_of(*other)).empty();
  std::vector<ParetoCell> cells;
  if (is_known) cells = pareto_front(map_.map(), filter(map_.map()), {*one, *other});
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("front");
    json.begin_list();
    for (const ParetoCell& cell : cells)
      write_numbers(json, std::array{static_cast<double>(cell.row), static_cast<double>(cell.column),
                                     readable_value(measure_of(*one), cell.values[0]),
                                     readable_value(measure_of(*other), cell.values[1])});
    json.end_list();
    json.end_object();
  });
}

namespace {

// What the list of the best is to be read with: why it is empty, and what was not known of the task before.
void write_notices(JsonWriter& json, const Answer& answer, const std::vector<Notice>& known) {
  if (linkage_count(answer) == 0) write_notice(json, findings(answer).reason);
  for (const Notice& warning : findings(answer).warnings)
    if (std::none_of(known.begin(), known.end(), [&](const Notice& notice) { return notice.code == warning.code; }))
      write_notice(json, warning);
}

}  // namespace

std::string Session::best(int most) const {
  Problem usual = problem_;
  SynthesisOptions& options = usual.options;
  options.region_samples = task().samples_for_best();
  if (!task().window_sets_axes()) options.window.reset();
  options.at.reset();
  options.best = most;
  options.measure_yields = false;
  constexpr int samples_of_the_best = 10'000;
  if (options.tolerances) options.tolerances->samples = std::min(options.tolerances->samples, samples_of_the_best);
  const auto answer = solve(usual);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("linkages");
    json.begin_list();
    if (answer) std::visit([&](const auto& of_kind) { write_best_linkages(json, of_kind); }, *answer);
    json.end_list();
    json.key("notices");
    json.begin_list();
    if (answer) write_notices(json, *answer, task().about().warnings);
    json.end_list();
    json.end_object();
  });
}

std::string Session::improve(double input_tau, double output_tau) const {
  const auto better = task().improved({input_tau, output_tau}, wish());
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("tau");
    write_numbers(json, better ? std::array{better->input, better->output} : std::array{input_tau, output_tau});
    json.member("improved", better.has_value());
    json.end_object();
  });
}

std::string Session::verify(double input_tau, double output_tau) {
  const Verification found = task().verify({input_tau, output_tau}, requirements_.respect_direction);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("verified", found.verified);
    json.member("residual", found.residual);
    json.end_object();
  });
}

std::vector<double> Session::trace(double input_tau, double output_tau, Point traced) {
  if (opened_) return opened_trace(*opened_, traced);
  return task().trace({input_tau, output_tau}, traced, requirements_.respect_direction);
}

std::string Session::exported(double input_tau, double output_tau, std::string_view format) const {
  if (opened_) return linkwright::exported(*opened_, format);
  auto answer = task().answer_at({input_tau, output_tau}, requirements_.respect_direction);
  if (!answer) return "";
  Findings& found = findings(*answer);
  found.reason = {"picked", "One linkage, picked on the map.", {}};
  found.requirements = requirements_;
  found.options = problem_.options;
  found.options.at.reset();
  found.options.tolerances = tolerances_;
  report_tolerances(*answer);
  constexpr bool with_region = false;
  if (format == "result") return write_result(problem_, *answer, with_region);
  return linkwright::exported(stored_linkages(problem_, *answer).front(), format);
}

Result<Machine> Session::machine_at(MapPoint place, const WantedSizes& sizes) const {
  if (opened_) return linkwright::machine(moving_linkage(*opened_), sizes);
  const auto answer = task().answer_at(place, requirements_.respect_direction);
  if (!answer) return Error{"no_four_bar", "", "a slider or zero link cannot be written as a four-bar", {}};
  return linkwright::machine(moving_linkage(stored_linkages(problem_, *answer).front()), sizes);
}

std::string Session::machine(double input_tau, double output_tau, const WantedSizes& sizes) const {
  return machine_reply(machine_at({input_tau, output_tau}, sizes));
}

Result<std::string> Session::machine_file(double input_tau, double output_tau, std::string_view format,
                                          const WantedSizes& sizes) const {
  const auto made = machine_at({input_tau, output_tau}, sizes);
  if (!made) return made.errors();
  const bool is_of_parts = format == "stl" || format == "3mf" || format == "plates";
  return is_of_parts ? write_parts(*made, format) : simulator_text(*made, format);
}

}  // namespace linkwright::wasm
