#pragma once

#include "sweep_command.hpp"

namespace linkwright {

/// All ranks of MPI_COMM_WORLD compute the blocks of a sweep, each into its own journal: rank 0 leads, the others
/// follow it. Made by all of them together, before and after which MPI is there.
class RankTeam : public cli::SweepWorkers {
 public:
  RankTeam();
  /// Rank 0 lets the others go.
  ~RankTeam() override;

  [[nodiscard]] bool leads() const { return rank_ == 0; }
  /// Of ranks other than 0: does what rank 0 asks for, until it lets go.
  void follow();

  [[nodiscard]] int threads(int wished) const override;
  [[nodiscard]] std::optional<Error> compute(const SweepPlan& plan, const SweepFolder& folder,
                                             RemainingBlocks& remaining, int threads,
                                             cli::SweepProgressLine& line) override;

 private:
  /// This rank's part, with all others. What kept any of them from doing theirs, the same on all.
  [[nodiscard]] std::optional<Error> share(const std::filesystem::path& folder, std::vector<BlockRun> runs, int threads,
                                           const SweepPlan* plan, cli::SweepProgressLine* line) const;

  int rank_ = 0, ranks_ = 1;
  int own_threads_ = 1;  ///< its share of the node
  int all_threads_ = 1;  ///< of all ranks together
};

}  // namespace linkwright
