#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

bool errs_by_angle(const Task& task) {
  return output_kind(task) == OutputKind::angle || output_kind(task) == OutputKind::turn;
}

}  // namespace

void list_tolerances(LinkageColumns& list, const Task& task) {
  const std::string unit = errs_by_angle(task) ? "deg" : list.length_unit();
  list.number("tolerance.error", unit, "Error by tolerances, to first order (root mean square)", LinkageColumn::usual);
  list.number("tolerance.error_sampled", unit, "The same of linkages sampled");
  list.number("tolerance.worst_case", unit, "Worst case of the tolerances");
  list.number("tolerance.mean_plus_3_sigma", unit, "Mean and three standard deviations of the linkages sampled");
  list.number("tolerance.signal_to_noise_db", "dB", "Signal-to-noise ratio");
  list.number("tolerance.yield", "", "Share of linkages within the limit", LinkageColumn::usual);
  list.number("tolerance.yield_interval[0]", "", "Lower end of the yield's 95 % interval");
  list.number("tolerance.yield_interval[1]", "", "Upper end of the yield's 95 % interval");
  list.number("tolerance.not_assembled", "", "Share of linkages that cannot be assembled");
}

}  // namespace linkwright
