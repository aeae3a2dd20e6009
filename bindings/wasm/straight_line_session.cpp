#include "straight_line_session.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "files/straight_line/straight_line_kind.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/region/improved_linkage.hpp"
#include "reply_json.hpp"
#include "straight_line_reply.hpp"
#include "synthesis/straight_line_answer.hpp"

namespace linkwright::wasm {
namespace {

constexpr int samples_of_line_map = 200;  // the path of every cell is traced

ShownAxis shown_line_axis(const StraightLineFamily& family, Side side) {
  ShownAxis shown;
  shown.axis = family.axis(side);
  shown.order = DisplayOrder(shown.axis.branches);
  shown.ticks = axis_ticks(family, side);
  return shown;
}

// A linkage on the map of a family of its own, which is wide enough for it.
struct OnItsMap {
  MapPoint place;
  std::optional<MapWindow> window;
};
OnItsMap on_its_map(const StraightLineSolution& found, const LineMeasuring& measuring) {
  const StraightLineFamily usual(found.task, measuring);
  if (const auto place = usual.point_of(found.place)) return {*place, {}};
  constexpr double beyond = 0.1;
  MapWindow window{usual.range(Side::input), usual.range(Side::output)};
  for (std::size_t i = 0; i < 2; ++i) {
    auto& [low, high] = i == 0 ? window.input : window.output;
    const double at = found.place.at[i], more = beyond * std::abs(at);
    low = std::min(low, at - more);
    high = std::max(high, at + more);
  }
  return {StraightLineFamily(found.task, measuring, window).point_of(found.place).value_or(MapPoint{}), window};
}

void write_its_map(JsonWriter& json, const StraightLineSolution& found, const OnItsMap& map) {
  json.key("straight_line");
  json.begin_object();
  json.key("task");
  json.begin_object();
  write_of_kind(json, found.task);
  json.end_object();
  json.key("window");
  if (map.window) {
    json.begin_list(JsonWriter::Layout::one_line);
    write_numbers(json, map.window->input);
    write_numbers(json, map.window->output);
    json.end_list();
  } else {
    json.null();
  }
  json.end_object();
}

}  // namespace

StraightLineSession::StraightLineSession(const StraightLineTask& task, const SynthesisOptions& options)
    : task_(task), measuring_(options.line), window_(options.window), nothing_(no_straight_line(task_)) {
  if (!std::holds_alternative<straight_cases::Search>(task_.given))
    family_ = std::make_shared<StraightLineFamily>(task_, measuring_, window_);
}

bool StraightLineSession::serves(const Problem& problem) const {
  const auto* line = std::get_if<StraightLineTask>(&problem.task);
  const auto& window = problem.options.window;
  const bool same_window = window.has_value() == window_.has_value() &&
                           (!window || (window->input == window_->input && window->output == window_->output));
  return line && *line == task_ && problem.options.line == measuring_ && same_window;
}

Requirements StraightLineSession::with_defaults(Requirements wanted) const {
  return with_default_length(std::move(wanted), task_);
}

TaskReply StraightLineSession::about() const {
  TaskReply reply;
  reply.characteristic_length = size_of(task_);
  reply.write_curves = [](JsonWriter& json) { write_no_curves(json); };
  return reply;
}

Drawn StraightLineSession::drawn() const {
  Drawn drawn{{}, DrawnCurves{}};
  if (!family_ || !family_->axis(Side::input).is_discrete()) return drawn;
  std::vector<Dyad> input, output;
  for (int layer = 0; layer < family_->layers(); ++layer) {
    const LineDesign design = family_->design({static_cast<double>(layer), 0});
    if (design.kind != DesignKind::four_bar) continue;
    const FourBar& bars = design.linkage.bars;
    const auto homogeneous = [](Point p) { return Homogeneous{1, p.real(), p.imag()}; };
    const auto coordinate = static_cast<double>(layer);
    input.push_back({homogeneous(bars.input_center), homogeneous(bars.input_circle), coordinate});
    output.push_back({homogeneous(bars.output_center), homogeneous(bars.output_circle), coordinate});
  }
  const auto& branches = family_->axis(Side::input).branches;
  return {drawn_dyads(input, branches, {}), drawn_dyads(output, branches, {})};
}

ShownAxes StraightLineSession::axes(const ExploreRequest& /*request*/, Spacing /*spacing*/,
                                    const ShownAxes* /*shown*/) const {
  if (!family_) return {};
  return {shown_line_axis(*family_, Side::input), shown_line_axis(*family_, Side::output), false};
}

std::vector<double> StraightLineSession::coordinates(const ExploreRequest& request, const ShownAxis& axis,
                                                     Side side) const {
  // All layers together have about as many cells as one that is looked at alone.
  const int layers = request.input == ExploreRequest::whole ? family_->layers() : 1;
  const int samples = static_cast<int>(std::lround(map_samples(request.samples) / std::sqrt(layers)));
  if (axis.axis.is_discrete()) return family_->samples(side, samples, Spacing::coordinate);
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  return axis.order.samples(side == Side::input ? samples * layers : samples, from, to);
}

std::optional<StraightLineSolution> StraightLineSession::at(MapPoint place) const {
  return family_ ? make_straight_line(*family_, place) : std::nullopt;
}

int StraightLineSession::map_samples(int asked) const { return std::min(asked, samples_of_line_map); }

LinkageReply StraightLineSession::linkage(MapPoint place, FailureBits fails, bool /*respect_direction*/) const {
  return straight_line_reply(*family_, make_straight_line(*family_, place), place, fails);
}

bool StraightLineSession::meets_exactly(MapPoint place, const Requirements& wanted) const {
  const auto cell = family_->cell(place);
  return cell && CellJudge(wanted, family_->linkages(), family_->measures()).passes(*cell);
}

Verification StraightLineSession::verify(MapPoint place, bool /*respect_direction*/) const {
  const auto found = at(place);
  return found ? Verification{found->verified_by_driving, found->residual} : Verification{};
}

std::vector<double> StraightLineSession::trace(MapPoint place, Point traced, bool /*respect_direction*/) const {
  const auto found = at(place);
  return found ? straight_line_trace(*family_, *found, traced) : std::vector<double>{};
}

std::optional<MapPoint> StraightLineSession::improved(MapPoint place, const Wish& wish) const {
  return family_ ? improved_linkage(*family_, wish.requirements, wish.objective, place, wish.added) : std::nullopt;
}

int StraightLineSession::samples_for_best() const { return samples_of_line_map; }

std::optional<Answer> StraightLineSession::answer_at(MapPoint place, bool /*respect_direction*/) const {
  auto found = at(place);
  if (!found) return std::nullopt;
  StraightLineAnswer answer;
  answer.task = task_;
  answer.lines = family_;
  answer.characteristic_length = size_of(task_);
  answer.options.line = measuring_;
  answer.linkages = {*std::move(found)};
  return Answer(std::move(answer));
}

void write_best_linkages(JsonWriter& json, const StraightLineAnswer& answer) {
  for (const StraightLineSolution& found : answer.linkages) {
    const OnItsMap own = answer.search ? on_its_map(found, answer.options.line) : OnItsMap{answer.point_of(found), {}};
    const MapPoint place = own.place;
    const UsableLine& usable = found.counted(answer.options.line.measure);
    const StrokeReport& over = found.judged();
    json.begin_object(JsonWriter::Layout::one_line);
    json.key("tau");
    write_numbers(json, std::array{place.input, place.output});
    json.member("type", name(found.type));
    json.member("min_transmission_angle_deg", degrees(over.min_transmission_angle));
    json.member("link_ratio", found.linkage.longest() / found.linkage.shortest());
    json.member("longest", found.linkage.longest());
    json.member("usable_stroke", found.usable.length());
    json.member("usable_strip", found.usable_strip.length());
    json.member("stroke_over_longest", usable.length() / found.linkage.longest());
    json.member("deviation", found.worth().deviation);  // null where the point does not go as far as the stroke
    json.key("velocity_nonuniformity");
    over.drive ? json.value(over.drive->nonuniformity(over.to - over.from)) : json.null();
    if (answer.search) write_its_map(json, found, own);
    json.key("pivots");
    const FourBar& bars = found.linkage.bars;
    write_points(json, std::array{bars.input_center, bars.input_circle, bars.output_center, bars.output_circle,
                                  found.linkage.point});
    json.end_object();
  }
}

}  // namespace linkwright::wasm
