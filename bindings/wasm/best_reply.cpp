#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

std::optional<double> near_error(const FourBarAnswer& answer, const FourBarSolution& found) {
  if (found.near) return found.near->error.rms;
  if (!found.fit) return std::nullopt;
  const CurveError& error = found.fit->error;
  return answer.options.fit.measure == FitMeasure::least_largest ? error.max : error.rms;
}

RankedLinkage ranked(const FourBarAnswer& answer, const FourBarSolution& found) {
  constexpr int samples = 49;
  RankedLinkage ranked{answer.point_of(found)};
  ranked.near_error = near_error(answer, found);
  if (found.path)
    for (const MotionState& state : motion_cycle(found.four_bar, found.path->point, samples))
      ranked.path.push_back(state.coupler_point);
  return ranked;
}

RankedLinkage ranked(const SphericalAnswer& answer, const SphericalSolution& found) {
  RankedLinkage ranked{answer.point_of(found)};
  ranked.min_link_angle_deg = degrees(found.angles.shortest());
  return ranked;
}

// With their chains: of a search each has one of its own.
RankedLinkage ranked(const SixBarAnswer& answer, const SixBarSolution& found) {
  SixBarTask task = answer.task;
  task.chain = found.chain;
  RankedLinkage ranked{ChainFamily::of(task)->point_of(found.member)};
  ranked.chain = found.chain;
  return ranked;
}

// The map of a linkage's own case, which is wide enough for it.
std::optional<MapWindow> own_window(const StraightLineSolution& found, const StraightLineFamily& usual) {
  if (usual.point_of(found.place)) return std::nullopt;
  constexpr double beyond = 0.1;
  MapWindow window{usual.range(Side::input), usual.range(Side::output)};
  for (std::size_t i = 0; i < 2; ++i) {
    auto& [low, high] = i == 0 ? window.input : window.output;
    const double at = found.place.at[i], more = beyond * std::abs(at);
    low = std::min(low, at - more);
    high = std::max(high, at + more);
  }
  return window;
}

RankedLinkage ranked(const StraightLineAnswer& answer, const StraightLineSolution& found) {
  const LineMeasuring& measuring = answer.options.line;
  const auto window = answer.search ? own_window(found, StraightLineFamily(found.task, measuring)) : std::nullopt;
  const auto place =
      answer.search ? StraightLineFamily(found.task, measuring, window).point_of(found.place) : answer.point_of(found);
  RankedLinkage ranked{place.value_or(MapPoint{})};
  ranked.deviation = found.worth().deviation;
  ranked.window = window;
  return ranked;
}

std::vector<RankedLinkage> all_ranked(const Problem& problem, const Answer& answer) {
  const auto records = stored_linkages(problem, answer);
  std::vector<RankedLinkage> all;
  std::visit(
      [&](const auto& of_kind) {
        for (std::size_t i = 0; i < records.size(); ++i) {
          all.push_back(ranked(of_kind, of_kind.linkages[i]));
          all.back().record = std::visit([](const auto& stored) { return stored.record; }, records[i]);
        }
      },
      answer);
  return all;
}

// Why the list is empty, and what was not known of the task before.
std::vector<WordedNotice> notices_on(const Answer& answer, const std::vector<Notice>& known) {
  std::vector<WordedNotice> notices;
  if (linkage_count(answer) == 0) notices.push_back({findings(answer).reason});
  for (const Notice& warning : findings(answer).warnings)
    if (std::none_of(known.begin(), known.end(), [&](const Notice& notice) { return notice.code == warning.code; }))
      notices.push_back({warning});
  return notices;
}

}  // namespace

std::string best_reply(const Session& session, int most) {
  const auto answer = session.best(most);
  if (!answer) return text_of(BestReply{});
  return text_of(
      BestReply{all_ranked(session.problem(), *answer), notices_on(*answer, findings(session.known()).warnings)});
}

}  // namespace linkwright::wasm
