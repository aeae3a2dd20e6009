// Any bytes as a sweep file and as rows. A plan that is read has problems for its first and its last sample, or
// says why not, and its texts make the same plan.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz_support.hpp"
#include "linkwright/sweep/sweep_plan.hpp"

namespace {

using namespace linkwright;
using fuzz::check_errors, fuzz::require;

void check_sample(const SweepPlan& plan, std::int64_t sample) {
  require(plan.values(sample).size() == plan.variables().size());
  const auto problem = plan.problem(sample);
  if (!problem) check_errors(problem.errors());
}

void check_plan(std::string_view text) {
  const auto plan = SweepPlan::read(text, "/nonexistent");
  if (!plan) return check_errors(plan.errors());
  require(plan->samples() >= 1 && plan->blocks() >= 1);
  require((plan->blocks() - 1) * plan->block_samples() < plan->samples());
  check_sample(*plan, 0);
  check_sample(*plan, plan->samples() - 1);
  const std::string whole = R"({"problem": )" + plan->base_text() + ", " + plan->sweep_text().substr(1);
  const auto again = SweepPlan::read(whole, "/nonexistent");
  require(again.ok() && again->sweep_text() == plan->sweep_text() && again->base_text() == plan->base_text());
}

void check_rows(std::string_view bytes) {
  const SweepColumns columns = {
      {{count_column("sample", ""), number_column("x", "", "")}, {flag_column("f", "")}, {text_column("t", 4, "")}}};
  SweepRows rows(columns);
  if (rows.from_bytes(bytes, columns)) require(rows.to_bytes() == bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  check_rows(bytes);
  if (bytes.find("/dev") == std::string_view::npos) check_plan(bytes);  // as the name of a problem's file: waits
  return 0;
}
