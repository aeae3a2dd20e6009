#include "linkwright/solve/session.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/analyses.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "region/improved_linkage.hpp"
#include "region/window_look.hpp"
#include "solve/yield_map.hpp"

namespace linkwright {
namespace {

constexpr bool without_sampled = false;  // it comes coarse to fine

Answer begin(const Problem& problem) {
  return std::visit([&](const auto& task) { return Answer(begin_answer(task, problem.requirements, problem.options)); },
                    problem.task);
}

/// An answer that lists one linkage of the task alone.
template <class KindAnswer, class Solution>
KindAnswer listing(const KindAnswer& known, Solution found) {
  KindAnswer answer;
  answer.task = known.task;
  if constexpr (requires { known.given; }) answer.given = known.given;
  if constexpr (requires { known.chain; }) answer.chain = known.chain;
  if constexpr (requires { known.lines; }) answer.lines = known.lines;
  answer.pattern = known.pattern;
  answer.condition = known.condition;
  answer.characteristic_length = known.characteristic_length;
  answer.warnings = known.warnings;
  answer.requirements = known.requirements;
  answer.options = known.options;
  answer.reason = {"picked", "One linkage, picked on the map.", {}};
  answer.linkages.push_back(std::move(found));
  return answer;
}

/// One of the map's measures, or the first where it has no such.
Measure shown_measure(const RegionMap& map, std::string_view key) {
  const std::vector<Measure> known = map.reported_measures();
  const auto named = std::find(known.begin(), known.end(), Measure{key});
  return named == known.end() ? known.front() : *named;
}

}  // namespace

Session::Session(Problem problem) : problem_(std::move(problem)), known_(begin(problem_)) { set_options(true); }
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

void Session::set(Problem problem) {
  const bool unchanged = problem.task == problem_.task &&
                         std::visit([&](const auto& known) { return serves(known, problem_, problem); }, known_);
  std::optional<Answer> known;
  if (!unchanged) known = begin(problem);  // before anything is replaced: it may throw
  problem_ = std::move(problem);
  if (known) {
    known_ = *std::move(known);
    drawn_.reset();
    mapped_.reset();
  }
  set_options(!unchanged);
}

// Requirements and options with their defaults, and what is to be measured of the errors of dimensions.
void Session::set_options(bool task_is_new) {
  std::visit(
      [&](auto& known) {
        known.requirements = with_defaults(problem_.requirements, known);
        known.options = with_task_defaults(problem_.options, known.characteristic_length);
        known.options.at.reset();
      },
      known_);
  const SynthesisOptions& options = findings(known_).options;
  if (!task_is_new && analyze_alike(options, analyzed_)) return;
  analyzed_ = options;
  const AddedMeasures before = std::move(added_);
  added_ = family() ? added_measures(*family(), options, findings(known_).of_task) : AddedMeasures{};
  if (std::any_of(before.all.begin(), before.all.end(),
                  [&](const AddedMeasure& added) { return !added_.find(added.measure->measure()); }))
    mapped_.reset();  // its map has columns that nothing asks for any more
  added_measured_ = false;
  yields_.reset();
}

const LinkageFamily* Session::family() const {
  return std::visit([](const auto& known) -> const LinkageFamily* { return known.family(); }, known_);
}

// ---- the task, drawn ------------------------------------------------------------------------------------------------

void Session::draw() {
  if (drawn_) return;
  drawn_ = std::visit(
      [&](const auto& known) {
        Drawn drawn{links_along(known, Side::input), {}, marks_of(known)};
        drawn.output =
            known.family() && !known.family()->is_symmetric() ? links_along(known, Side::output) : drawn.input;
        return drawn;
      },
      known_);
}

const LinkPolygon& Session::links(Side side) {
  draw();
  return side == Side::input ? drawn_->input : drawn_->output;
}

const std::vector<CurveMark>& Session::marks() {
  draw();
  return drawn_->marks;
}

// ---- the map --------------------------------------------------------------------------------------------------------

void Session::classify(RegionMap& map, std::span<const double> input, std::span<const double> output) const {
  family()->classify(map, input, output, requirements().respect_direction);
  added_.add_to(map, *family(), requirements(), without_sampled);
}

RequirementFilter Session::filter(const RegionMap& map) const { return filter_of(*family(), map, requirements()); }

// The map stays where only tolerances change; yields go by the cells that meet all else.
void Session::measure_added(bool map_is_new) {
  RegionMap& region = map_.region;
  const bool go_by_others = std::any_of(added_.all.begin(), added_.all.end(), [](const AddedMeasure& added) {
    return added.cost == AddedMeasure::Cost::heavy;
  });
  if (!map_is_new && (!added_measured_ || go_by_others))
    added_.add_to(region, *family(), requirements(), without_sampled);
  added_measured_ = true;
  const AddedMeasure* sampled = added_.sampled();
  if (!sampled) return yields_.reset();
  std::vector<FailureBits> failed(region.rows() * region.columns());
  filter_of(*family(), region, added_.all_else(*sampled, requirements())).failures_of_all(failed);
  std::vector<std::uint8_t> wanted(failed.size());
  std::transform(failed.begin(), failed.end(), wanted.begin(), [](FailureBits bits) { return bits == 0; });
  if (map_is_new || !yields_ || wanted != yields_of_)
    yields_ = std::make_unique<YieldMap>(region.rows(), region.columns(), wanted);
  yields_of_ = std::move(wanted);
  region.add(KnownYields(yields_->values()));
}

void Session::evaluate(const RequirementFilter& passing) {
  map_.fails.resize(map_.region.rows() * map_.region.columns());
  passing.failures_of_all(map_.fails);
  map_.census = passing.census(map_.fails);
  map_.relax.clear();
  map_.relax_together.reset();
  map_.missed_boxes.clear();
  map_.inside = {};
  if (map_.census.meeting == 0) look_closer(passing);
}

// Nothing of the map is left: there may be something between its cells, where windows are small.
void Session::look_closer(const RequirementFilter& passing) {
  const RegionMap& map = map_.region;
  const MapMaking making{[&](RegionMap& part, std::span<const double> input, std::span<const double> output) {
                           classify(part, input, output);
                         },
                         static_cast<int>(std::max(map.rows(), map.columns())), std::nullopt};
  const auto apart = [&](Side side, std::size_t count) {
    return family()->axis(side).coordinate_length() / static_cast<double>(std::max<std::size_t>(count, 1));
  };
  const SearchMap seen{&map, &passing, {apart(Side::input, map.rows()), apart(Side::output, map.columns())}};
  const WindowLook look = look_into_windows(*family(), seen, requirements(), making);
  std::vector<SearchMap> maps = {seen};
  for (const auto& closer : look.maps) maps.push_back(closer->view());
  map_.missed_boxes = std::visit([](const auto& known) { return boxes_missed(known); }, known_);
  map_.inside = {look.looked_at, look.meeting, look.is_empty};
  if (look.meeting > 0) return;
  map_.relax = relaxations(*family(), maps, requirements(), making);
  if (map_.relax.empty()) map_.relax_together = map_.census.joint_relaxation();
}

void Session::colour(std::string_view property) {
  const RegionMap& region = map_.region;
  map_.values.assign(region.rows() * region.columns(), 0);
  bool larger_is_better = false;
  if (yields_ && property == measures::yield.key) {
    map_.values = yields_->shown();
    larger_is_better = true;
  } else if (!std::visit([&](const auto& known) { return write_property(known, map_, property, map_.values); },
                         known_)) {
    const Measure shown = shown_measure(region, property);
    for (std::size_t row = 0; row < region.rows(); ++row)
      row_values(region, shown, row, std::span(map_.values).subspan(region.index(row, 0), region.columns()));
    larger_is_better = shown.larger_is_better;
  }
  map_.ridges = ridges(map_.values, map_.fails, region.columns(), larger_is_better);
}

const ColouredMap* Session::explore(const MapRequest& request) {
  const auto shown = [&](Side side) {
    const ShownAxis* before = axes_are_shown_ ? &axes_.of(side) : nullptr;
    return std::visit([&](const auto& known) { return shown_axis(known, side, request.order, before); }, known_);
  };
  const bool symmetric = family() == nullptr || family()->is_symmetric();
  ShownAxis input = shown(Side::input);
  ShownAxis output = symmetric ? input : shown(Side::output);
  axes_ = {std::move(input), std::move(output), symmetric};
  axes_are_shown_ = true;
  if (family() == nullptr) return nullptr;
  MapRequest part = request;
  part.samples = std::visit([&](const auto& known) { return live_samples(known, request.samples); }, known_);
  const MapKey wanted{part.samples, axes_.input.order.code(), part.input,
                      part.output,  problem_.options.spacing, requirements().respect_direction};
  const bool is_new = mapped_ != wanted;
  if (is_new) {
    mapped_.reset();  // nothing is shown of the last one should memory run out half way
    const auto coordinates = [&](Side side) {
      return std::visit([&](const auto& known) { return coordinates_of(known, *family(), part, axes_.of(side), side); },
                        known_);
    };
    classify(map_.region, coordinates(Side::input), coordinates(Side::output));
    map_.counts = map_.region.counts();
    mapped_ = wanted;
  }
  measure_added(is_new);
  evaluate(filter(map_.region));
  colour(request.property);
  return &map_;
}

std::optional<Notice> Session::why_nothing() const {
  return std::visit(
      [&](const auto& known) -> std::optional<Notice> {
        if (known.family() == nullptr) return no_map(known);
        const bool is_whole = mapped_ && mapped_->input == MapRequest::whole && mapped_->output == MapRequest::whole;
        const RegionCounts& counts = map_.counts;
        if (!is_whole || counts.pairs != counts.types[static_cast<std::size_t>(LinkageType::degenerate)])
          return std::nullopt;
        return nothing_on_map(known, map_.region);
      },
      known_);
}

SampledYields Session::sample_yields(int cells) {
  if (!yields_) return {};
  yields_->advance(static_cast<std::size_t>(std::max(cells, 0)), *added_.sampled()->measure,
                   map_.region.input_coordinates(), map_.region.output_coordinates());
  return {static_cast<std::int64_t>(yields_->done()), static_cast<std::int64_t>(yields_->total())};
}

std::vector<ParetoCell> Session::front(Objective first, Objective second) const {
  const RegionMap& map = map_.region;
  const bool is_known = mapped_ && !map.values(measure_of(first)).empty() && !map.values(measure_of(second)).empty();
  return is_known ? pareto_front(map, filter(map), {first, second}) : std::vector<ParetoCell>{};
}

// ---- one linkage ----------------------------------------------------------------------------------------------------

std::vector<FailureBits> Session::failures(RegionMap& map, std::span<const double> input,
                                           std::span<const double> output) const {
  if (input.empty() || output.empty()) return {};
  classify(map, input, output);
  std::vector<FailureBits> found(map.rows() * map.columns());
  filter(map).failures_of_all(found);
  return found;
}

// By the map's own kernel, so that the linkage and its cell agree to the last bit; but where a map only estimates what
// is asked of a linkage, by the closer look of searches and lists.
FailureBits Session::failures_at(MapPoint place) {
  FailureBits failed = failures(cell_, std::array{place.input}, std::array{place.output}).front();
  AddedMeasures closer;
  for (const AddedMeasure& added : added_.all) {
    if (added.cost != AddedMeasure::Cost::sampled && !added.margin_of) continue;
    closer.all.push_back(added);
    for (const Criterion* criterion : AddedMeasures::criteria_on(added))
      failed = static_cast<FailureBits>(failed & ~bit_of(criterion->kind));
  }
  if (failed != 0 && !std::visit([&](const auto& known) { return meets_exactly(known, place); }, known_)) return failed;
  const auto fails = closer.failures_at(place, requirements());
  return fails.empty() ? FailureBits{0} : bit_of(fails.front());
}

FailureBits Session::bit_of(RequirementKind kind) const {
  return static_cast<FailureBits>(1u << place_among(linkages(problem_.task).requirements, kind));
}

PickedLinkage Session::linkage(MapPoint place) {
  PickedLinkage picked{place, failures_at(place), {}, {}, {}, {}};
  std::visit(
      [&](const auto& known) {
        constexpr bool verify = false;
        auto found = solution_at(known, place, verify);
        describe(picked, known, found ? &*found : nullptr);
        for (int number = 1; std::size(picked.positions) < std::size(picked.travel.state_of_position); ++number)
          picked.positions.push_back(number);
        if (found) picked.answer = listing(known, *std::move(found));
      },
      known_);
  return picked;
}

LiveLinks Session::live(MapPoint place) {
  if (!family()) return {};
  LiveLinks live;
  live.input = failures(strip_, links(Side::input).coordinate, std::array{place.output});
  // Where nothing is left to choose of the output, it moves with the input.
  live.output = family()->axis(Side::output).quantity == AxisQuantity::nothing
                    ? live.input
                    : failures(strip_, std::array{place.input}, links(Side::output).coordinate);
  return live;
}

std::vector<Point> Session::trace(MapPoint place, Point traced) const {
  return std::visit(
      [&](const auto& known) {
        constexpr bool verify = false;
        PickedLinkage picked{place, 0, {}, {}, {}, {}};
        if (const auto found = solution_at(known, place, verify)) describe(picked, known, &*found);
        return path_of(picked.travel, traced);
      },
      known_);
}

Verification Session::verify(MapPoint place) const {
  return std::visit(
      [&](const auto& known) {
        constexpr bool by_driving = true;
        const auto found = solution_at(known, place, by_driving);
        return found ? Verification{found->verified_by_driving, residual_of(*found)} : Verification{};
      },
      known_);
}

std::optional<MapPoint> Session::improved(MapPoint place) const {
  if (!family()) return std::nullopt;
  const Objective objective = problem_.options.objective;
  const GeneratorFamily* generators = std::visit([](const auto& known) { return generators_of(known); }, known_);
  return objective == Objective::structural_error && generators
             ? improved_generator(*generators, requirements(), place, added_)
             : improved_linkage(*family(), requirements(), objective, place, added_);
}

std::optional<Answer> Session::answer_at(MapPoint place) const {
  return std::visit(
      [&](const auto& known) -> std::optional<Answer> {
        constexpr bool verify = true;
        auto found = solution_at(known, place, verify);
        if (!found) return std::nullopt;
        return listing(known, *std::move(found));
      },
      known_);
}

std::optional<Answer> Session::result_at(MapPoint place) const {
  auto answer = answer_at(place);
  if (!answer) return std::nullopt;
  std::optional<MapPoint>& at = findings(*answer).options.at;
  at = place;  // what is picked is not left out
  report_analyses(*answer);
  at.reset();
  return answer;
}

std::optional<LinkageOutput> Session::output_at(MapPoint place) const {
  auto output = family() ? family()->output(place) : std::nullopt;
  const auto& tolerances = analyzed_.tolerances;
  if (!output || !tolerances) return output;
  return with_turning_length(*std::move(output), tolerances->turning_length.value_or(0));
}

Result<Answer> Session::best(int most) const {
  Problem usual = problem_;
  SynthesisOptions& options = usual.options;
  std::visit(
      [&](const auto& known) {
        options.region_samples = samples_for_best(known);
        if (!window_sets_axes(known)) options.window.reset();
      },
      known_);
  options.at.reset();
  options.best = most;
  options.measure_yields = false;
  options = reported_soon(options);
  return solve(usual);
}

}  // namespace linkwright
