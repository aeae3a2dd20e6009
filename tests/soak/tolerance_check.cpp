#include "tolerance_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "analyses/tolerances/tolerance_analysis.hpp"
#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/region/measure.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright::soak {
namespace {

using nlohmann::json;
using Wrongs = std::vector<std::string>;

constexpr double rounding_of_files = 1e-6;

double number_of(const json& object, const char* key) { return object[key].get<double>(); }

bool is_one_or_zero(double sum) { return std::abs(sum - 1) < rounding_of_files || sum == 0; }

void check_shares(const json& shares, Wrongs& wrongs) {
  if (shares.empty()) return;
  double all = 0, before = 2;
  std::vector<double> of_position(shares[0]["per_position"].size());
  for (const json& share : shares) {
    const double part = number_of(share, "share");
    if (!(part >= 0 && part <= before)) wrongs.push_back("shares are not in order");
    before = part;
    all += part;
    for (std::size_t j = 0; j < of_position.size(); ++j) of_position[j] += share["per_position"][j].get<double>();
  }
  if (!is_one_or_zero(all)) wrongs.push_back(fmt::format("the shares sum to {}", all));
  if (!std::all_of(of_position.begin(), of_position.end(), is_one_or_zero))
    wrongs.push_back("the shares of a position do not sum to one");
}

void check_yield(const json& report, bool has_limit, Wrongs& wrongs) {
  if (report["yield"].is_null() == has_limit) return wrongs.push_back("a yield goes with a limit, and only so");
  const double failing = number_of(report, "not_assembled");
  if (!(failing >= 0 && failing <= 1)) wrongs.push_back("not_assembled is no share");
  if (!has_limit) return;
  const double yield = number_of(report, "yield"), low = report["yield_interval"][0],
               high = report["yield_interval"][1];
  if (!(0 <= low && low <= yield && yield <= high && high <= 1)) wrongs.push_back("a yield outside of its interval");
  if (yield > 1 - failing + 1e-12) wrongs.push_back("more good ones than assemble");
}

/// The worst case is Σ |S| T; σ ≤ T/√3, and with clearance c less than 2c/√3.
void check_errors(const json& report, bool of_line, Wrongs& wrongs) {
  const double error = number_of(report, "error"), deviations = of_line ? 3 : 1;
  for (const char* key : {"error", "error_sampled", "worst_case", "mean_plus_3_sigma"})
    if (!(number_of(report, key) >= 0)) wrongs.push_back(fmt::format("{} is below zero", key));
  if (number_of(report, "worst_case") * deviations < std::sqrt(3.0) * error * (1 - rounding_of_files))
    wrongs.push_back("the worst case is better than the usual one");
}

void check_allocation(const json& report, bool has_cost, Wrongs& wrongs) {
  if (report["allocation"].is_null()) return;
  if (!has_cost) wrongs.push_back("an allocation without a cost");
  for (const json& of : report["allocation"])
    if (!(number_of(of, of.contains("tolerance") ? "tolerance" : "tolerance_deg") > 0))
      wrongs.push_back("an allocated tolerance is not above zero");
}

double listed_error(const json& report) {
  return number_of(report, report["beyond_first_order"].get<bool>() ? "error_sampled" : "error");
}

/// A map's yield is of fewer samples.
void check_wanted(const json& wanted, const json& report, Wrongs& wrongs) {
  constexpr double luck = 0.1;
  if (wanted.contains("max_tolerance_error") && !wanted["max_tolerance_error"].is_null() &&
      listed_error(report) > number_of(wanted, "max_tolerance_error") * (1 + rounding_of_files))
    wrongs.push_back("more than max_tolerance_error");
  if (wanted.contains("min_yield") && !wanted["min_yield"].is_null() &&
      number_of(report, "yield") < number_of(wanted, "min_yield") - luck)
    wrongs.push_back("less than min_yield");
}

void check_order_by_tolerances(const json& options, const json& linkages, Wrongs& wrongs) {
  const std::string objective = options.value("objective", "");
  if (options.contains("pareto") || (objective != "tolerance_error" && objective != "yield")) return;
  double before = INFINITY;
  for (const json& entry : linkages) {
    const json& report = entry["tolerance"];
    const double worth = report.is_null()       ? -INFINITY
                         : objective == "yield" ? number_of(report, "yield")
                                                : -listed_error(report);
    if (worth > before) wrongs.push_back("the linkages are not listed best first");
    before = worth;
  }
}

void check_front(const json& result, Wrongs& wrongs) {
  if (!result.contains("pareto")) return;
  const json& front = result["pareto"]["front"];
  for (std::size_t i = 1; i < front.size(); ++i) {
    const json &one = front[i - 1]["values"], &other = front[i]["values"];
    if (one[0] == other[0] || one[1] == other[1]) wrongs.push_back("one of the front beats its neighbour");
  }
}

void check_columns(const RegionMap& map, Wrongs& wrongs) {
  for (const float error : map.values(measures::tolerance_error))
    if (error < 0) return wrongs.push_back("tolerance_error of the region is no error");
  for (const float yield : map.values(measures::yield))
    if (!(std::isnan(yield) || (yield >= 0 && yield <= 1))) return wrongs.push_back("yield of the region is no share");
}

/// By other threads.
void check_again(const Answer& answer, Wrongs& wrongs) {
  const Findings& found = findings(answer);
  const Tolerances& tolerances = *found.options.tolerances;
  if (found.tolerance.empty() || !found.tolerance[0]) return;
  constexpr int threads = 3;
  const auto output = listed_outputs(answer, tolerances.turning_length.value_or(0))[0];
  const SampledErrors &once = found.tolerance[0]->sampled, again = sample_errors(*output, tolerances, threads);
  if (once.error != again.error || once.not_assembled != again.not_assembled || once.mean != again.mean)
    wrongs.push_back("the same seed gives other errors");
}

}  // namespace

std::vector<std::string> wrongs_of_tolerances(const Problem& problem, const Answer& answer, const json& result) {
  Wrongs wrongs;
  check_front(result, wrongs);
  const auto& tolerances = problem.options.tolerances;
  const json &linkages = result["linkages"], &options = result["problem"]["options"];
  for (const json& entry : linkages) {
    if (entry.contains("tolerance") != tolerances.has_value())
      wrongs.push_back("tolerances are told where they are given");
    if (!tolerances || entry["tolerance"].is_null()) continue;
    const json& report = entry["tolerance"];
    check_shares(report["sensitivities"], wrongs);
    check_yield(report, tolerances->limit.has_value(), wrongs);
    check_errors(report, std::holds_alternative<StraightLineTask>(problem.task), wrongs);
    check_allocation(report, tolerances->cost_exponent.has_value(), wrongs);
    check_wanted(result["problem"]["requirements"], report, wrongs);
  }
  if (!tolerances || !wrongs.empty()) return wrongs;
  check_order_by_tolerances(options, linkages, wrongs);
  check_columns(findings(answer).region, wrongs);
  check_again(answer, wrongs);
  return wrongs;
}

}  // namespace linkwright::soak
