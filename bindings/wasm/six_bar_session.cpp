#include "six_bar_session.hpp"

#include <algorithm>
#include <cmath>

#include "files/six_bar/six_bar_kind.hpp"
#include "files/task_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/region/improved_linkage.hpp"
#include "reply_json.hpp"
#include "six_bar_reply.hpp"

namespace linkwright::wasm {
namespace {

// What a cell takes in the page (docs/performance.md), and how long maps may take: one that follows the pointer, one at
// rest, all those of a halo. What is asked for is meant for four-bars, of which solve() takes four times as many, too.
constexpr double cell_us = 3;
constexpr double live_ms = 150, rest_ms = 600, halo_ms = 150;
constexpr int four_bar_samples_to_one = 4, least_samples = 20, least_of_halo = 10;
constexpr int samples_of_the_usual_map = 400;

int samples_within(double ms, std::size_t maps = 1) {
  return static_cast<int>(std::sqrt(1000 * ms / (cell_us * static_cast<double>(maps))));
}

DrawnCurves drawn_links(const AddedLinks& links) {
  if (links.curve->coordinate_length() == 0) return {};
  return drawn_dyads(links.curve->polygon(drawn_side), links.curve->branches(), links.conditions.frame);
}

SixBarTask with_chain(SixBarTask task, const ThreeLinkChain& chain) {
  task.chain = chain;
  return task;
}

}  // namespace

SixBarSession::SixBarSession(const SixBarTask& task) : task_(task), family_(ChainFamily::of(task_)) {}

bool SixBarSession::serves(const Problem& problem) const {
  const auto* six_bar = std::get_if<SixBarTask>(&problem.task);
  return six_bar && *six_bar == task_;
}

const Notice& SixBarSession::no_map() const {
  static const Notice chain_wanted{
      "chain_wanted", "No chain is given: place its three hinges, or let one be searched for.", {}};
  return chain_wanted;
}

const Notice& SixBarSession::nothing_on_map() const {
  static const Notice no_pair{
      "no_pair",
      "No two added links make a six-bar of this chain: in every pair a hinge is at infinity or a link has no length.",
      {}};
  return no_pair;
}

Requirements SixBarSession::with_defaults(Requirements wanted) const {
  const double size = task_.chain ? task_.chain->size() : pose_conditions(task_.poses).frame.scale;
  return with_default_lengths(std::move(wanted), size);
}

TaskReply SixBarSession::about() const {
  const PoseConditions conditions = pose_conditions(task_.poses);
  TaskReply reply{pattern(task_.poses), conditions.condition(), conditions.frame.scale, {}, {}, {}};
  if (auto notice = points_notice(task_.points)) reply.warnings.push_back(*std::move(notice));
  reply.write_curves = [](JsonWriter& json) { write_no_curves(json); };
  return reply;
}

Drawn SixBarSession::drawn() const {
  const auto of = [&](Side side) {
    const AddedLinks* links = family_ ? family_->links(side) : nullptr;
    return links ? drawn_links(*links) : DrawnCurves{};
  };
  return {of(Side::input), of(Side::output)};
}

ShownAxes SixBarSession::axes(const ExploreRequest& /*request*/, Spacing /*spacing*/,
                              const ShownAxes* /*shown*/) const {
  ShownAxes axes;
  axes.symmetric = false;
  if (!family_) return axes;
  axes.input.axis = family_->axis(Side::input);
  axes.output.axis = family_->axis(Side::output);
  axes.input.order = DisplayOrder(axes.input.axis.branches);
  axes.output.order = DisplayOrder(axes.output.axis.branches);
  return axes;
}

std::vector<double> SixBarSession::coordinates(const ExploreRequest& request, const ShownAxis& axis, Side side) const {
  const auto& [from, to] = side == Side::input ? request.input : request.output;
  return axis.order.samples(map_samples(request.samples), from, to);
}

int SixBarSession::map_samples(int asked) const {
  const double ms = asked > samples_of_the_usual_map ? rest_ms : live_ms;
  return std::clamp(asked / four_bar_samples_to_one, least_samples, samples_within(ms));
}

int SixBarSession::halo_samples(int asked, std::size_t places) const {
  return std::max(least_of_halo, std::min(asked, samples_within(halo_ms, places)));
}

std::optional<SixBarSolution> SixBarSession::at(MapPoint place) const {
  const auto member = family_ ? family_->member(place) : std::nullopt;
  const auto row = six_bar_row(task_.added);
  if (!member || !row) return std::nullopt;
  return solution_of(task_.poses, *task_.chain, *row, *member);
}

LinkageReply SixBarSession::linkage(MapPoint place, FailureBits fails, bool /*respect_direction*/) const {
  return six_bar_reply(task_.poses, at(place), place, fails);
}

Verification SixBarSession::verify(MapPoint place, bool /*respect_direction*/) const {
  const auto found = at(place);
  if (!found) return {};
  return {found->verified_by_driving, found->residual * found->rating.shape.longest};
}

std::vector<double> SixBarSession::trace(MapPoint place, Point traced, bool /*respect_direction*/) const {
  return six_bar_trace(task_.poses, at(place), traced);
}

std::optional<MapPoint> SixBarSession::improved(MapPoint place, const Wish& wish) const {
  return family_ ? improved_linkage(*family_, wish.requirements, wish.objective, place, wish.added) : std::nullopt;
}

int SixBarSession::samples_for_best() const { return four_bar_samples_to_one * map_samples(samples_of_the_usual_map); }

std::optional<Answer> SixBarSession::answer_at(MapPoint place, bool /*respect_direction*/) const {
  auto found = at(place);
  if (!found) return std::nullopt;
  const TaskReply task = about();
  SixBarAnswer answer;
  answer.task = task_;
  answer.pattern = task.pattern;
  answer.condition = task.condition;
  answer.characteristic_length = task.characteristic_length;
  answer.chain = family_;
  answer.linkages = {*std::move(found)};
  return Answer(std::move(answer));
}

// With their chains: of a search each has one of its own.
void write_best_linkages(JsonWriter& json, const SixBarAnswer& answer) {
  for (const SixBarSolution& found : answer.linkages) {
    json.begin_object(JsonWriter::Layout::one_line);
    json.key("tau");
    const auto family = ChainFamily::of(with_chain(answer.task, found.chain));
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

}  // namespace linkwright::wasm
