#include "planar/six_bar_rater.hpp"

namespace linkwright {

void SixBarRater::add(std::size_t place, const SixBarMember& member) {
  const SixBarShape shape = shape_of(member.six_bar);
  if (shape.type == LinkageType::degenerate) return take_(place, {shape, {}});
  const SixBarLoops loops(member.six_bar);
  if (!signs_agree(loops, member.turns)) return take_(place, {shape, turned_down_by_signs()});
  waiting_.push_back({place, shape, loops, member.turns});
  if (waiting_.size() == pack) finish();
}

void SixBarRater::finish() {
  std::vector<SixBarToDrive> driven;
  for (const Waiting& six_bar : waiting_) driven.push_back({six_bar.loops, six_bar.turns});
  const std::vector<SixBarDriveReport> reports = drive_six_bars(driven, simd_);
  for (std::size_t i = 0; i < reports.size(); ++i) take_(waiting_[i].place, {waiting_[i].shape, reports[i]});
  waiting_.clear();
}

}  // namespace linkwright
