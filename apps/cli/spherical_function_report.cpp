#include "spherical_function_report.hpp"

#include <fmt/format.h>

#include "function_report.hpp"
#include "linkwright/files/number_text.hpp"
#include "requirement_report.hpp"
#include "spherical_report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

std::string generator_counts(const Problem& problem, const SphericalFunctionAnswer& answer) {
  const RegionCounts& counts = answer.counts;
  if (counts.pairs == 0) return "";
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  return wrapped(fmt::format("{} holds {} spherical four-bars. {} are free of defects; {} meet the requirements: {}.",
                             function_map_words(*answer.family(), answer.region), grouped_text(whole),
                             grouped_text(counts.defect_free), grouped_text(answer.meeting_requirements),
                             requirement_words(answer.requirements, linkages(problem.task), problem.length_unit)));
}

}  // namespace

std::string spherical_function_report(const Problem& problem, const SphericalFunctionAnswer& answer) {
  std::string text = generator_counts(problem, answer);
  if (!answer.pairs.empty())
    text += "\nAll linkages that satisfy the five precision points, best first:\n" + spherical_table(answer.pairs);
  if (answer.linkages.empty()) return text + "\n" + wrapped(answer.reason.message);
  const std::string errors = function_error_words(answer);
  return text + "\nBest linkages:\n" + spherical_table(answer.linkages) + (errors.empty() ? "" : "\n" + errors) + "\n" +
         wrapped("Linkages listed: " + precision_words(answer) + ".");
}

}  // namespace linkwright::cli
