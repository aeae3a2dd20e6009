// Any bytes as a problem file, a linkage file and a result file. A problem that is read must write as a file that reads
// as the same problem; a linkage likewise.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "files/listed_problem.hpp"
#include "fuzz_support.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace {

using namespace linkwright;
using fuzz::check_errors, fuzz::require;

void check_same_poses(const std::vector<PrescribedPose>& again, const std::vector<PrescribedPose>& poses) {
  require(again.size() == poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    require(again[i].pose.origin == poses[i].pose.origin);
    require(again[i].pose.angle == poses[i].pose.angle);
    require(again[i].multiplicity() == poses[i].multiplicity());
  }
}

void check_same(const MotionTask& again, const MotionTask& task) {
  check_same_poses(again.poses, task.poses);
  require(again.given == task.given);
  require(again.near == task.near && again.turning_length == task.turning_length);
}

void check_same_function(const WantedFunction& again, const WantedFunction& task) {
  require(again.pairs.size() == task.pairs.size());
  for (std::size_t i = 0; i < task.pairs.size(); ++i) {
    require(std::isfinite(task.pairs[i].input) && std::isfinite(task.pairs[i].output));
    require(again.pairs[i].input == task.pairs[i].input && again.pairs[i].output == task.pairs[i].output);
    require(again.pairs[i].multiplicity() == task.pairs[i].multiplicity());
  }
  require(again.function.has_value() == task.function.has_value());
  require(again.free.has_value() == task.free.has_value());
  if (task.free) require(again.free->range == task.free->range && again.free->pair == task.free->pair);
}

void check_same(const FunctionTask& again, const FunctionTask& task) {
  check_same_function(again, task);
  require(again.input_pivot == task.input_pivot && again.output_pivot == task.output_pivot);
}

void check_same(const SphericalFunctionTask& again, const SphericalFunctionTask& task) {
  check_same_function(again, task);
  require(again.ground_angle == task.ground_angle);
}

void check_same(const SixBarTask& again, const SixBarTask& task) {
  check_same_poses(again.poses, task.poses);
  require(again.added == task.added);
  require(again.chain.has_value() == task.chain.has_value() && again.box.has_value() == task.box.has_value());
  if (task.chain) require(again.chain->b == task.chain->b && again.chain->assembly_mode == task.chain->assembly_mode);
}

void check_same(const SphericalMotionTask& again, const SphericalMotionTask& task) { require(again == task); }
void check_same(const StraightLineTask& again, const StraightLineTask& task) { require(again == task); }
void check_same(const PathTask& again, const PathTask& task) { require(again == task); }

void check_same_task(const Task& again, const Task& task) {
  require(again.index() == task.index());
  std::visit([&](const auto& of_kind) { check_same(std::get<std::decay_t<decltype(of_kind)>>(again), of_kind); }, task);
}

void check_problem(std::string_view text) {
  const auto problem = read_problem(text);
  if (!problem) return check_errors(problem.errors());
  const std::string written = write_problem(*problem);
  const auto again = read_problem(written);
  require(again.ok());
  require(write_problem(*again) == written);
  check_same_task(again->task, problem->task);
}

bool same_bars(const StoredLinkage& again, const StoredLinkage& linkage) {
  return again.four_bar.input_moving == linkage.four_bar.input_moving;
}

bool same_bars(const StoredSphericalFourBar& again, const StoredSphericalFourBar& linkage) {
  return again.four_bar == linkage.four_bar && again.orientations == linkage.orientations;
}

bool same_bars(const StoredSixBar& again, const StoredSixBar& linkage) {
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
    if (again.six_bar.joints[joint].point != linkage.six_bar.joints[joint].point) return false;
  return again.row.added == linkage.row.added;
}

template <class Stored>
void check_stored(const Stored& linkage) {
  const std::string written = write_linkage(linkage);
  const auto again = read_any_linkage(written);
  require(again.ok());
  const auto* same_kind = std::get_if<Stored>(&*again);
  require(same_kind != nullptr && same_bars(*same_kind, linkage));
  require(write_linkage(*same_kind) == written);
}

void check_linkage(std::string_view text) {
  const auto linkage = read_any_linkage(text);
  if (!linkage) return check_errors(linkage.errors());
  std::visit([](const auto& of_kind) { check_stored(of_kind); }, *linkage);
}

void check_result(std::string_view text) {
  const auto linkages = read_any_result_linkages(text);
  if (!linkages) return check_errors(linkages.errors());
  const auto listed = read_listed_problem(text, 1);
  if (!listed) check_errors(listed.errors());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_problem(text);
  check_linkage(text);
  check_result(text);
  return 0;
}
