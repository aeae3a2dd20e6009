#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

using Solutions = std::vector<SixBarSolution>;

std::string angle_of(double sine) { return angle_text(std::asin(std::min(sine, 1.0))); }

bool is_driven(const SixBarRating& rating) { return rating.drive.completed && rating.drive.defects.none(); }

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", grouped_text(count), count == 1 ? one : many);
}

std::string search_words(const Problem& problem, const SixBarAnswer& answer, const SixBarSearchResult& search) {
  std::string text = fmt::format("Tried {} that reach all poses (of {} drawn, seed {}",
                                 counted(search.chains_tried, "chain", "chains"), grouped_text(search.chains_drawn),
                                 answer.options.seed);
  if (answer.options.box) text += ", pivots in " + box_words(*answer.options.box);
  text += fmt::format("): {} with all pivots in the box, {} simulated, {} of these free of defects. Requirements: {}.",
                      counted(search.six_bars, "six-bar", "six-bars"), grouped_text(search.driven),
                      grouped_text(search.defect_free),
                      requirement_words(answer.requirements, linkages(problem.task), problem.length_unit));
  text = wrapped(text);
  if (search.interrupted)
    text += wrapped(fmt::format(
        "Stopped early, after {} of {} chains: {}", grouped_text(search.chains_tried),
        grouped_text(answer.options.effort),
        answer.linkages.empty() ? "nothing is found so far." : "this is the best so far, verified but not refined."));
  return text;
}

std::string six_bar_map_words(const Problem& problem, const SixBarAnswer& answer) {
  const RegionCounts& counts = answer.counts;
  const std::int64_t degenerate = counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::string text = fmt::format("The solution region of {} × {} pairs of added links holds {}", answer.region.rows(),
                                 answer.region.columns(), counted(counts.pairs - degenerate, "six-bar", "six-bars"));
  if (degenerate > 0) text += fmt::format(" and {} pairs that make none", grouped_text(degenerate));
  text += fmt::format(". {} free of defects; {}: {}.", counted(counts.defect_free, "is", "are"),
                      counted(answer.meeting_requirements, "meets the requirements", "meet the requirements"),
                      requirement_words(answer.requirements, linkages(problem.task), problem.length_unit));
  return wrapped(text);
}

std::string heading_of_best(const SynthesisOptions& options) {
  return options.at ? "The six-bar there:\n" : best_heading("six-bars", options.objective);
}

std::string drive_cell(const SixBarDriveReport& drive) {
  if (drive.defects.circuit()) return "no: circuit";
  if (drive.defects.branch()) return "no: branch";
  return drive.defects.order() ? "no: order" : std::string(name(drive.sense));
}

std::string dimension_table(const Solutions& found, int decimals) {
  TextTable table({"#", "<topology", "<four-bar loop", "<drive", "turns", "γ", "ratio", "longest"});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SixBarRating& rating = found[i].rating;
    const bool driven = is_driven(rating);
    table.add_row({fmt::format("{}", i + 1), std::string(label(found[i].row.topology)),
                   std::string(short_label(rating.shape.type)), drive_cell(rating.drive),
                   driven ? angle_text(rating.drive.sweep, 1) : "–",
                   driven ? angle_text(rating.min_transmission_angle(), 1) : "–",
                   rounded_text(rating.shape.link_ratio, 2), rounded_text(rating.shape.longest, decimals)});
  }
  return table.text();
}

/// "c4 (0-4)".
std::string hinge_name(const SixBar& six_bar, SixBar::JointIndex joint) {
  const auto& bodies = six_bar.joints[joint].bodies;
  return fmt::format("{} ({}-{})", joint_name(joint), bodies[0], bodies[1]);
}

/// The hinges of each six-bar: `joints` as columns.
std::string hinge_table(const Solutions& found, std::initializer_list<SixBar::JointIndex> joints, int decimals) {
  std::vector<std::string> heading = {"#"};
  for (const auto joint : joints) heading.push_back(hinge_name(found.front().member.six_bar, joint));
  TextTable table(heading);
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::vector<std::string> row = {fmt::format("{}", i + 1)};
    for (const auto joint : joints) row.push_back(pivot_text(found[i].member.six_bar.at(joint), decimals));
    table.add_row(std::move(row));
  }
  return table.text();
}

constexpr std::string_view body_words =
    "Bodies: 0 the ground, 1 the driver, 2 the floating link, 3 the guided body; 4 and 5 the added links.";

std::string chain_words(const SixBarAnswer& answer, int decimals) {
  const Solutions& found = answer.linkages;
  const auto chain = {SixBar::a, SixBar::b, SixBar::d};
  if (answer.search) return "The chain:\n" + hinge_table(found, chain, decimals);
  const SixBar& six_bar = found.front().member.six_bar;  // the same in all
  std::string text = "The chain, as given:";
  for (const auto joint : chain)
    text += fmt::format("{} {} at {}", joint == SixBar::a ? "" : ";", hinge_name(six_bar, joint),
                        pivot_text(six_bar.at(joint), decimals));
  return wrapped(text + ".");
}

std::string hinge_words(const SixBarAnswer& answer, int decimals) {
  return "Hinges (x, y) and the bodies they join, in position 1.\n" + chain_words(answer, decimals) +
         "The added links:\n" +
         hinge_table(answer.linkages, {SixBar::c4, SixBar::z4, SixBar::c5, SixBar::z5}, decimals) + wrapped(body_words);
}

std::string limits_words(const Problem& problem, const SixBarAnswer& answer) {
  if (answer.options.at) return wrapped(answer.reason.message);
  const std::optional<Box> box = answer.search ? answer.options.box : std::nullopt;
  return wrapped("Six-bar 1 " + held_back_words(limits_touched(answer.requirements, answer.linkages.front(), box,
                                                               problem.length_unit)));
}

std::string check_words(const Solutions& all, bool are_picked) {
  double length = 0, pose = 0;
  bool confirmed = true;
  for (const SixBarSolution& found : all) {
    length = std::max(length, found.residual);
    pose = std::max(pose, found.pose_residual);
    confirmed = confirmed && found.verified_by_driving;
  }
  return wrapped(fmt::format(
      "The distances between the hinges of a link stay the same over the positions to a relative {}, and the position "
      "error of the body is at most {} of the longest link; {}.",
      significant_text(length, 2), significant_text(pose, 2),
      confirmed    ? "an independent simulation of the motion verified every six-bar listed"
      : are_picked ? "simulation of the motion disagrees with the table: rounding decides what the six-bar does there"
                   : "simulation of the motion disagrees with the table, which is a bug: please report it"));
}

std::string no_six_bar_words(const Problem& problem, const SixBarAnswer& answer) {
  if (answer.options.at) return "\n" + wrapped(answer.reason.message);
  if (answer.options.best == 0 || (answer.search && answer.search->interrupted)) return "";
  std::string text = "\n" + wrapped(answer.reason.message);
  for (const Relaxation& relaxation : answer.relax)
    text += wrapped("  " + relaxation_words(relaxation, problem.length_unit), 4);
  return text;
}

std::string length_table(const StoredSixBarAnalysis& analysis, int decimals) {
  TextTable table({"<link", "<hinges", "distance"});
  for (const SixBarLength& length : analysis.lengths)
    table.add_row({fmt::format("{}", length.body),
                   fmt::format("{}-{}", joint_name(length.joints[0]), joint_name(length.joints[1])),
                   rounded_text(length.length, decimals)});
  return table.text();
}

std::string range_words(const SixBarMotion& motion) {
  if (motion.full_turn) return "The driver turns fully; it has no dead points.\n";
  if (motion.states.empty()) return "";
  return wrapped(
      fmt::format("The driver rocks from {} to {} ({} in all) about position 1, counter-clockwise "
                  "positive, between two dead points.",
                  angle_text(motion.states.front().place.turn, 2), angle_text(motion.states.back().place.turn, 2),
                  angle_text(motion.states.back().place.turn - motion.states.front().place.turn, 2)));
}

std::string travel_words(const StoredSixBarAnalysis& analysis) {
  if (analysis.linkage.poses.size() < 2) return "";
  if (analysis.travel.states.empty())
    return wrapped("Driven by body 1 it does not pass all poses of the file in their order.");
  const double turn = analysis.travel.states.back().place.turn;
  return wrapped(
      fmt::format("Through all {} poses of the file the driver turns {} {}; the minimum transmission angle "
                  "on the way is {}.",
                  analysis.linkage.poses.size(), angle_text(std::abs(turn), 2),
                  turn < 0 ? "clockwise" : "counter-clockwise", angle_of(analysis.travel.min_sine)));
}

std::string transmission_words(const StoredSixBarAnalysis& analysis) {
  const std::string_view what =
      analysis.motion.dyadic
          ? "Transmission angle (the smaller of its two dyads)"
          : "Transmission index (the loops do not separate into dyads: asin √(|det| / Π|columns|) of their Jacobian)";
  std::string text = fmt::format("{} in the position given: {}", what, angle_text(analysis.transmission_angle, 2));
  text += analysis.motion.full_turn
              ? fmt::format("; minimum over the full turn: {}.", angle_of(analysis.motion.min_sine))
              : "; it is 0 at the dead points.";
  return wrapped(text);
}

}  // namespace

std::string six_bar_report(const Problem& problem, const SixBarAnswer& answer) {
  const Solutions& found = answer.linkages;
  std::string text = answer.search ? search_words(problem, answer, *answer.search) : six_bar_map_words(problem, answer);
  if (found.empty()) return text + no_six_bar_words(problem, answer);
  double longest = 0;
  for (const SixBarSolution& one : found) longest = std::max(longest, one.rating.shape.longest);
  const int decimals = std::min(length_decimals(longest), 9);
  return text + "\n" + heading_of_best(answer.options) + dimension_table(found, decimals) + "\n" +
         hinge_words(answer, decimals) + "\n" + limits_words(problem, answer) +
         check_words(found, answer.options.at.has_value());
}

std::string six_bar_words(const StoredSixBarAnalysis& analysis) {
  const StoredSixBar& linkage = analysis.linkage;
  const std::string title = linkage.title.empty() ? "Six-bar linkage" : printable(linkage.title);
  const std::string unit = printable(linkage.length_unit);
  const int decimals = std::min(length_decimals(analysis.shape.longest) + 1, 12);
  return wrapped(fmt::format("{}: {}, driven by body 1 at hinge a", title, row_label(linkage.row))) +
         (unit.empty() ? std::string("Lengths:\n") : fmt::format("Lengths in {}:\n", spoken_unit(unit))) +
         length_table(analysis, decimals) +
         wrapped(fmt::format("Longest over shortest: {}. Its four-bar loop: {}.",
                             rounded_text(analysis.shape.link_ratio, 3), label(analysis.shape.type))) +
         range_words(analysis.motion) + travel_words(analysis) + missed_words(linkage) + transmission_words(analysis) +
         wrapped(body_words);
}

}  // namespace linkwright::cli
