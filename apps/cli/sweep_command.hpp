#pragma once

#include <optional>
#include <string>

#include "linkwright/sweep/run_sweep.hpp"
#include "sweep_progress.hpp"

namespace CLI {
class App;
}

namespace linkwright::cli {

struct SweepArguments {
  std::string sweep;      ///< path, or "-" for standard input; empty with `inspected`
  std::string output;     ///< path
  std::string inspected;  ///< path of a table, or empty
  bool resumes = false, overwrites = false, is_dry = false;
  int threads = 0;  ///< of a process; 0: as many as there are for it
};
void add_sweep(CLI::App& app, SweepArguments& arguments);

/// What computes the blocks of a sweep: the threads of this process, or many processes.
class SweepWorkers {
 public:
  SweepWorkers() = default;
  SweepWorkers(const SweepWorkers&) = delete;
  SweepWorkers& operator=(const SweepWorkers&) = delete;
  virtual ~SweepWorkers() = default;

  /// In all of them, where one process has `wished` threads (0: as many as there are for it).
  [[nodiscard]] virtual int threads(int wished) const = 0;
  /// Keeps all blocks that remain in journals of the folder, and tells the line how many samples these are. Returns
  /// when all are kept or the program is interrupted, or with what kept a block from being written.
  [[nodiscard]] virtual std::optional<Error> compute(const SweepPlan& plan, const SweepFolder& folder,
                                                     RemainingBlocks& remaining, int threads,
                                                     SweepProgressLine& line) = 0;
};

/// The threads of this process, into journal 0.
class ThreadsHere : public SweepWorkers {
 public:
  [[nodiscard]] int threads(int wished) const override;
  [[nodiscard]] std::optional<Error> compute(const SweepPlan& plan, const SweepFolder& folder,
                                             RemainingBlocks& remaining, int threads, SweepProgressLine& line) override;
};

/// The exit status.
[[nodiscard]] int sweep(const SweepArguments& arguments, SweepWorkers& workers);

}  // namespace linkwright::cli
