#include "six_bar_judge.hpp"

namespace linkwright {

std::vector<std::optional<SixBarDriveReport>> judge_six_bars(std::span<const SixBarToDrive> six_bars, Simd simd) {
  SixBarReports reports(six_bars.size());
  std::vector<std::size_t> dyadic, others;
  for (std::size_t i = 0; i < six_bars.size(); ++i)
    if (!six_bars[i].wanted.empty()) (six_bars[i].loops.dyads ? dyadic : others).push_back(i);
  if (!dyadic.empty()) judge_dyads(six_bars, std::move(dyadic), simd, reports);
  if (!others.empty()) judge_strands(six_bars, std::move(others), simd, reports);
  return reports;
}

}  // namespace linkwright
