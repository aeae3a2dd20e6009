#include "warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {
namespace {

// Grounded links of the map that rounding keeps from being any.
std::vector<Notice> left_out_warning(FourBarAnswer& answer) {
  const FourBarFamily& family = *answer.given.family;
  const std::span<const double> looked_at = answer.region.input_coordinates();
  if (!answer.given.curve || !family.is_symmetric()) return {};
  const auto count = std::count_if(looked_at.begin(), looked_at.end(), [&](double tau) {
    return !family.dyad_pair({tau, tau}).has_value();
  });
  if (count == 0) return {};
  answer.dyads_left_out = count;
  return {
      {"side_links_left_out",
       fmt::format("{} of the {} sampled dyads were discarded: so short or so far away that round-off changes their "
                   "lengths over the positions by more than a millionth. Choose positions further "
                   "from a rotation about one pole, or from a pure translation.",
                   grouped_text(count), grouped_text(static_cast<std::int64_t>(looked_at.size()))),
       {{"count", static_cast<double>(count)}, {"of", static_cast<double>(looked_at.size())}}}};
}

// Where the best by another measure stand at the edge of locking: what keeps them away from it, and what that leaves.
template <class KindAnswer>
std::vector<Notice> locking_warning(const KindAnswer& answer, const Progress& progress) {
  constexpr double edge = radians(1), best_of_all = radians(40), step = radians(5);
  const Requirements& asked = answer.requirements;
  if (answer.linkages.empty() || asked.min_transmission_angle > 0 || !asked.no_defects) return {};
  const auto is_discrete = [&](Side side) { return answer.given.family->axis(side).is_discrete(); };
  if (is_discrete(Side::input) && is_discrete(Side::output)) return {};
  const double angle = answer.linkages.front().report.min_transmission_angle;
  if (answer.options.objective == Objective::min_transmission_angle || angle >= edge) return {};
  Requirements wanted = asked;
  std::int64_t left = 0;
  for (wanted.min_transmission_angle = best_of_all; left == 0 && wanted.min_transmission_angle > edge;) {
    left = filter_of(*answer.given.family, answer.region, wanted).census(progress).meeting;
    if (progress.is_cancelled()) return {};
    if (left == 0) wanted.min_transmission_angle -= step;
  }
  Notice notice{
      "held_by_locking",
      fmt::format("The best linkage is next to a dead point: its transmission angle is {:.2g}°.", degrees(angle)),
      {{"angle", degrees(angle)}}};
  if (left > 0) {
    const double proposed = degrees(wanted.min_transmission_angle);
    notice.message += fmt::format(" Require a transmission angle of at least {:.0f}°: {} four-bars have it.", proposed,
                                  grouped_text(left));
    notice.values.push_back({"proposed", proposed});
    notice.values.push_back({"leaves", static_cast<double>(left)});
  }
  return {notice};
}

// The longest way along the curve from one of the rising coordinates to the next.
double longest_step(const BurmesterCurve::ArcLengthTable& run, std::span<const double> coordinates) {
  double longest = 0, before = 0;
  for (std::size_t i = 0, corner = 0; i < coordinates.size(); ++i) {
    while (corner + 1 < run.tau.size() && run.tau[corner] < coordinates[i]) ++corner;
    if (i > 0) longest = std::max(longest, run.length[corner] - before);
    before = run.length[corner];
  }
  return longest;
}

// What the map skips where a long stretch of the curve lies between two of its samples.
std::vector<Notice> skipped_stretch_warning(const FourBarAnswer& answer) {
  // Radians run by both points together: a whole way to infinity and back is π. Evenly drawn tasks stay below 2.4.
  constexpr double long_stretch = 3, long_beside_others = 20, short_side = 0.1;
  const BurmesterCurve* curve = answer.given.curve.get();
  const std::span<const double> looked_at = answer.region.input_coordinates();
  if (curve == nullptr || answer.options.window || answer.options.spacing == Spacing::arc_length) return {};
  const BurmesterCurve::ArcLengthTable run = curve->arc_length_table(short_side);
  if (run.tau.empty()) return {};
  const double usual = run.length.back() / static_cast<double>(looked_at.size());
  const double longest = longest_step(run, looked_at);
  if (!(longest > long_stretch && longest > long_beside_others * usual)) return {};
  return {
      {"stretch_between_samples",
       "A long part of the curve of dyads lies between two of its samples: the solution region does not show it, and "
       "good linkages may lie there. Choose \"spacing\": \"arc_length\" to see it.",
       {}}};
}

void warn_of_left_out(Findings& found, bool near_pole) {
  const std::int64_t count = found.left_out;
  if (count == 0) return;
  found.warnings.push_back(
      {"linkages_left_out",
       fmt::format("Left out {} of the best: so near a change point, a dead point{}, or with so short a link, that "
                   "rounding decides "
                   "what they do, and driving them through the task confirmed no more.{}",
                   count == 1 ? "is one" : fmt::format("are {}", count),
                   near_pole ? " or the positions' common pole" : "",
                   near_pole ? " Set the positions further off a turn about one pole." : ""),
       {{"count", static_cast<double>(count)}}});
}

}  // namespace

void warn_of_more(Findings& found, std::int64_t count) {
  if (count <= 0) return;
  found.warnings.push_back({"more_than_best",
                            fmt::format("{} more {} the requirements and {} not listed; a larger \"best\" lists {}.",
                                        count, count == 1 ? "linkage meets" : "linkages meet",
                                        count == 1 ? "is" : "are", count == 1 ? "it" : "them"),
                            {{"count", static_cast<double>(count)}}});
}

void warn_of_map(FourBarAnswer& answer) {
  for (const auto& found : {left_out_warning(answer), skipped_stretch_warning(answer)})
    answer.warnings.insert(answer.warnings.end(), found.begin(), found.end());
}

namespace {

template <class KindAnswer>
void leave_out(KindAnswer& answer, bool near_pole) {
  using Found = typename decltype(answer.linkages)::value_type;
  const auto unconfirmed = [](const Found& found) { return is_unconfirmed(found); };
  std::int64_t& count = answer.left_out;
  if (!answer.pairs.empty()) {  // all there are, those of the list among them
    count = static_cast<std::int64_t>(std::erase_if(answer.pairs, unconfirmed));
    std::erase_if(answer.linkages, unconfirmed);
  }
  if (answer.requirements.no_defects)  // none in the working frame, where they were judged
    count += static_cast<std::int64_t>(
        std::erase_if(answer.linkages, [](const Found& found) { return !found.report.defects.none(); }));
  count += static_cast<std::int64_t>(std::erase_if(answer.linkages, unconfirmed));
  warn_of_left_out(answer, near_pole);
}

}  // namespace

void leave_out_unconfirmed(FourBarAnswer& answer) { leave_out(answer, answer.given.conditions.near_pole.has_value()); }

void leave_out_unconfirmed(SphericalAnswer& answer) {
  constexpr bool near_pole = false;
  leave_out(answer, near_pole);
}

void leave_out_unconfirmed(SixBarAnswer& answer) {
  answer.left_out = static_cast<std::int64_t>(std::erase_if(answer.linkages, [](const SixBarSolution& found) {
    return found.rating.drive.defects.none() && !found.verified_by_driving;
  }));
  warn_of_left_out(answer, pose_conditions(answer.task.poses).near_pole.has_value());
}

void warn_of_locking(FourBarAnswer& answer, const Progress& progress) {
  for (Notice& warning : locking_warning(answer, progress)) answer.warnings.push_back(std::move(warning));
}

void warn_of_locking(SphericalAnswer& answer, const Progress& progress) {
  for (Notice& warning : locking_warning(answer, progress)) answer.warnings.push_back(std::move(warning));
}

}  // namespace linkwright
