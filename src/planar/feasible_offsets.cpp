#include "linkwright/planar/feasible_offsets.hpp"

#include <utility>

#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {
namespace {

/// Counts the passing cells of one task after another in the same memory.
class CellCounter {
 public:
  CellCounter(const Requirements& wanted, Spacing spacing, int samples)
      : wanted_(wanted), spacing_(spacing), samples_(samples) {}

  [[nodiscard]] std::uint32_t count(const MotionTask& task) {
    if (!mistakes_in(task).empty()) return 0;
    const TaskFamily given = task_family(task, wanted_, Objective::min_transmission_angle);
    if (!given.family) return 0;
    const FourBarFamily& family = *given.family;
    const Requirements wanted = with_defaults(wanted_, given);
    const auto samples = [&](Side side) { return family.samples(side, samples_, spacing_); };
    RegionOptions one_thread;
    one_thread.threads = 1;
    family.classify(map_, samples(Side::input), samples(Side::output), wanted.respect_direction, one_thread);
    const RequirementFilter filter = filter_of(family, map_, wanted);
    std::uint32_t passing = 0;
    for (std::size_t row = 0; row < map_.rows(); ++row)
      for (std::size_t column = 0; column < map_.columns(); ++column) passing += filter.passes(row, column);
    return passing;
  }

 private:
  Requirements wanted_;
  Spacing spacing_;
  int samples_;
  RegionMap map_;
};

}  // namespace

std::vector<double> offset_values(double reach, int steps) {
  std::vector<double> offsets;
  for (int i = 0; i < steps; ++i) offsets.push_back(steps == 1 ? 0 : reach * (2.0 * i / (steps - 1) - 1));
  return offsets;
}

FeasibleOffsets::FeasibleOffsets(MotionTask task, Requirements requirements, Spacing spacing, int samples)
    : task_(std::move(task)), requirements_(std::move(requirements)), spacing_(spacing), samples_(samples) {}

std::vector<std::uint32_t> FeasibleOffsets::moved(std::size_t pose, double reach, int steps) const {
  const std::vector<double> offsets = offset_values(reach, steps);
  std::vector<std::uint32_t> counts(offsets.size() * offsets.size());
  parallel_for(offsets.size(), 0, [&](std::size_t begin, std::size_t end) {
    CellCounter counter(requirements_, spacing_, samples_);
    MotionTask task = task_;
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x < offsets.size(); ++x) {
        task.poses[pose].pose.origin = task_.poses[pose].pose.origin + Point{offsets[x], offsets[y]};
        counts[y * offsets.size() + x] = counter.count(task);
      }
  });
  return counts;
}

std::vector<std::uint32_t> FeasibleOffsets::turned(std::size_t pose, double reach, int steps) const {
  std::vector<std::uint32_t> counts;
  CellCounter counter(requirements_, spacing_, samples_);
  MotionTask task = task_;
  for (const double turn : offset_values(reach, steps)) {
    task.poses[pose].pose.angle = task_.poses[pose].pose.angle + turn;
    counts.push_back(counter.count(task));
  }
  return counts;
}

}  // namespace linkwright
