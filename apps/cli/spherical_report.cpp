#include "spherical_report.hpp"

#include <fmt/format.h>
#include <vector>

#include "four_bar_columns.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "requirement_report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

std::string spherical_map_words(const Problem& problem, const SphericalMotionAnswer& answer) {
  if (answer.counts.pairs == 0) return "";
  const RegionCounts& counts = answer.counts;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  return wrapped(fmt::format(
      "The solution region of {} × {} pairs of dyads holds {} spherical four-bars. {} are free of defects; {} meet the "
      "requirements: {}.",
      answer.region.rows(), answer.region.columns(), grouped_text(whole), grouped_text(counts.defect_free),
      grouped_text(answer.meeting_requirements),
      requirement_words(answer.requirements, linkages(problem.task), problem.length_unit)));
}

std::string angle_table(const std::vector<SphericalSolution>& found) {
  TextTable table({"#", "<type", "<drive", "turns", "γ", "ground", "input", "coupler", "output"});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SphericalSolution& one = found[i];
    const bool clean = one.report.defects.none();
    table.add_row({fmt::format("{}", i + 1), std::string(short_label(one.report.type)),
                   clean ? std::string(name(one.report.sense)) : "–", clean ? angle_text(one.report.sweep, 1) : "–",
                   clean ? angle_text(one.report.min_transmission_angle, 1) : "–", angle_text(one.angles.ground, 2),
                   angle_text(one.angles.input, 2), angle_text(one.angles.coupler, 2),
                   angle_text(one.angles.output, 2)});
  }
  return table.text();
}

}  // namespace

std::string spherical_report(const Problem& problem, const SphericalMotionAnswer& answer) {
  const std::string text = spherical_map_words(problem, answer);
  if (answer.linkages.empty()) return text + "\n" + wrapped(answer.reason.message);
  return text + "\n" + angle_table(answer.linkages);
}

std::string spherical_words(const StoredSphericalAnalysis& analysis) {
  const LinkAngles& l = analysis.angles;
  return wrapped(fmt::format("{}: ground {}, input {}, coupler {}, output {}", label(analysis.type),
                             angle_text(l.ground, 3), angle_text(l.input, 3), angle_text(l.coupler, 3),
                             angle_text(l.output, 3)));
}

}  // namespace linkwright::cli
