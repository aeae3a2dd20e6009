#include "linkwright/solve/halo.hpp"

#include <array>
#include <utility>

#include "analyses/analyses.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {
namespace {

constexpr int most_steps = 101;

struct Move {
  Point by{};
  double turn = 0;
};

bool move_pose(std::vector<PrescribedPose>& poses, std::size_t pose, const Move& move) {
  if (pose >= poses.size()) return false;
  poses[pose].pose.origin += move.by;
  poses[pose].pose.angle += move.turn;
  return true;
}

// Where b changes sides of the line from a to d, the elbows of all positions do.
bool move_hinge(ThreeLinkChain& chain, std::size_t hinge, const Move& move) {
  const std::array<Point*, 3> hinges = {&chain.a, &chain.b, &chain.d};
  if (hinge >= hinges.size()) return false;
  const int before = chain.assembly_mode_in_position_1();
  *hinges[hinge] += move.by;
  if (chain.assembly_mode_in_position_1() != before)
    for (int& side : chain.assembly_mode) side = -side;
  return true;
}

bool move_part(MotionTask& task, std::size_t part, const Move& move) { return move_pose(task.poses, part, move); }
bool move_part(SixBarTask& task, std::size_t part, const Move& move) {
  if (move_pose(task.poses, part, move)) return true;
  return task.chain && move_hinge(*task.chain, part - task.poses.size(), move);
}
template <class OtherTask>
bool move_part(OtherTask& /*task*/, std::size_t /*part*/, const Move& /*move*/) {
  return false;
}

bool move_part(Task& task, int part, const Move& move) {
  return std::visit([&](auto& of_kind) { return move_part(of_kind, static_cast<std::size_t>(part), move); }, task);
}

/// Counts the passing cells of one problem after another in the same memory.
class CellCounter {
 public:
  explicit CellCounter(int samples) : samples_(samples) {}

  [[nodiscard]] std::uint32_t count(const Problem& problem) {
    if (!mistakes_in(problem.task).empty()) return 0;
    return std::visit(
        [&](const auto& task) { return count(begin_answer(task, problem.requirements, problem.options)); },
        problem.task);
  }

 private:
  template <class KindAnswer>
  [[nodiscard]] std::uint32_t count(const KindAnswer& known) {
    const LinkageFamily* family = known.family();
    if (family == nullptr) return 0;
    const Requirements wanted = with_defaults(known.requirements, known);
    const auto samples = [&](Side side) { return family->samples(side, samples_, known.options.spacing); };
    RegionOptions one_thread;
    one_thread.threads = 1;
    family->classify(map_, samples(Side::input), samples(Side::output), wanted.respect_direction, one_thread);
    const AddedMeasures added = added_measures(*family, with_task_defaults(known.options, known.characteristic_length),
                                               known.of_task, no_sampled);
    if (added.are_required(wanted)) added.add_to(map_, *family, wanted, no_sampled);
    const RequirementFilter filter = filter_of(*family, map_, wanted);
    std::uint32_t passing = 0;
    for (std::size_t row = 0; row < map_.rows(); ++row)
      for (std::size_t column = 0; column < map_.columns(); ++column) passing += filter.passes(row, column);
    return passing;
  }

  static constexpr bool no_sampled = false;

  int samples_;
  RegionMap map_;
};

std::vector<Move> moves_of(const HaloRequest& request) {
  std::vector<Move> moves;
  if (request.steps <= 0 || request.steps > most_steps) return {};
  const std::vector<double> offsets = offset_values(request.reach, request.steps);
  for (const double y : offsets) {
    if (request.turn) {
      moves.push_back({{}, y});
      continue;
    }
    for (const double x : offsets) moves.push_back({{x, y}, 0});
  }
  return moves;
}

}  // namespace

std::vector<double> offset_values(double reach, int steps) {
  std::vector<double> offsets;
  for (int i = 0; i < steps; ++i) offsets.push_back(steps == 1 ? 0 : reach * (2.0 * i / (steps - 1) - 1));
  return offsets;
}

std::vector<std::uint32_t> halo(const Problem& problem, const HaloRequest& request) {
  if (Task task = problem.task; request.part < 0 || !move_part(task, request.part, {})) return {};
  const std::vector<Move> moves = moves_of(request);
  const int samples = std::visit(
      [&](const auto& task) {
        const auto known = begin_answer(task, problem.requirements, problem.options);
        return halo_samples(known, request.samples, moves.size());
      },
      problem.task);
  std::vector<std::uint32_t> counts(moves.size());
  parallel_for(moves.size(), 0, [&](std::size_t begin, std::size_t end) {
    CellCounter counter(samples);
    for (std::size_t i = begin; i < end; ++i) {
      Problem moved = problem;
      move_part(moved.task, request.part, moves[i]);
      counts[i] = counter.count(moved);
    }
  });
  return counts;
}

}  // namespace linkwright
