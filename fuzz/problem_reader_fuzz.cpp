// Any bytes as a problem file, a linkage file and a result file. A problem that is read must write as a file that reads
// as the same problem; a linkage likewise.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz_support.hpp"
#include "linkwright/io/linkage_file.hpp"
#include "linkwright/io/problem_file.hpp"
#include "linkwright/io/result_file.hpp"

namespace {

using namespace linkwright;
using fuzz::check_errors, fuzz::require;

void check_problem(std::string_view text) {
  const auto problem = read_problem(text);
  if (!problem) return check_errors(problem.errors());
  const std::string written = write_problem(*problem);
  const auto again = read_problem(written);
  require(again.ok());
  require(write_problem(*again) == written);
  require(again->task.poses.size() == problem->task.poses.size());
  for (std::size_t i = 0; i < problem->task.poses.size(); ++i) {
    require(again->task.poses[i].pose.origin == problem->task.poses[i].pose.origin);
    require(again->task.poses[i].pose.angle == problem->task.poses[i].pose.angle);
    require(again->task.poses[i].multiplicity() == problem->task.poses[i].multiplicity());
  }
}

void check_linkage(std::string_view text) {
  const auto linkage = read_linkage(text);
  if (!linkage) return check_errors(linkage.errors());
  const std::string written = write_linkage(*linkage);
  const auto again = read_linkage(written);
  require(again.ok());
  require(again->four_bar.input_circle == linkage->four_bar.input_circle);
  require(write_linkage(*again) == written);
}

void check_result(std::string_view text) {
  const auto linkages = read_result_linkages(text);
  if (!linkages) return check_errors(linkages.errors());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_problem(text);
  check_linkage(text);
  check_result(text);
  return 0;
}
