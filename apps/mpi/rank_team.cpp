#include "rank_team.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <mpi.h>
#include <mutex>
#include <sched.h>
#include <thread>

#include "console.hpp"
#include "shared_counter.hpp"

namespace linkwright {
namespace {

using std::chrono::milliseconds;

/// Blocks by the counter of all ranks.
class SharedBlocks : public BlockSource {
 public:
  SharedBlocks(const RemainingBlocks& remaining, SharedCounter& counter, std::mutex& calls)
      : remaining_(remaining), counter_(counter), calls_(calls) {}
  std::optional<std::int64_t> next() override {
    const std::lock_guard lock(calls_);
    return remaining_.at(counter_.next());
  }

 private:
  const RemainingBlocks& remaining_;
  SharedCounter& counter_;
  std::mutex& calls_;
};

/// One rank's part of a run: a thread, with its helpers, computes; the calling one watches over it.
class RankShare {
 public:
  RankShare(int rank, cli::SweepProgressLine* line) : rank_(rank), line_(line) {}

  std::optional<Error> run(const std::function<std::optional<Error>(const SweepRunOptions&, RankShare&)>& compute,
                           int threads) {
    const SweepRunOptions options{threads, &stop_, [this](std::int64_t samples) { kept_ += samples; }};
    auto work = begun([&] { return compute(options, *this); });
    // Where the network does not reach into memory by itself, rank 0 has to look for those who want a number.
    const milliseconds between_looks(rank_ == 0 ? 1 : 200);
    while (work.wait_for(between_looks) != std::future_status::ready) look();
    const auto failure = outcome(work);
    if (failure) stop_all();
    look();
    await_others();
    return failure;
  }

  [[nodiscard]] SharedBlocks blocks(const RemainingBlocks& remaining) { return {remaining, counter_, calls_}; }

 private:
  /// A failure where there is no thread to be had: the others wait for this rank's end.
  static std::future<std::optional<Error>> begun(const std::function<std::optional<Error>()>& work) {
    try {
      return std::async(std::launch::async, work);
    } catch (const std::system_error& error) {
      std::promise<std::optional<Error>> none;
      none.set_value(Error{"rank_failed", "", error.what()});
      return none.get_future();
    }
  }

  static std::optional<Error> outcome(std::future<std::optional<Error>>& work) {
    try {
      return work.get();
    } catch (const std::bad_alloc&) {
      return Error{"out_of_memory", "", "there is not enough memory on a node; use fewer threads (--threads) or ranks"};
    } catch (const std::exception& error) {
      return Error{"rank_failed", "", error.what()};
    }
  }

  void stop_all() {
    const std::lock_guard lock(calls_);
    counter_.stop();
  }

  /// Tells how many samples are kept, hears whether all are to stop.
  void look() {
    const std::lock_guard lock(calls_);
    if (cli::Interruption::happened()) counter_.stop();
    const std::int64_t kept = counter_.add_to_sum(kept_.exchange(0));
    if (counter_.is_stopped()) stop_ = true;
    if (!line_) return;
    if (kept > shown_) line_->add(kept - shown_);
    shown_ = kept;
    int flag = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &flag, MPI_STATUS_IGNORE);  // lets requests in
  }

  void await_others() {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (int done = 0; !done;) {
      std::this_thread::sleep_for(milliseconds(1));
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (line_) look();
    }
  }

  int rank_;
  cli::SweepProgressLine* line_;
  SharedCounter counter_;
  std::mutex calls_;  ///< of MPI
  std::atomic<bool> stop_ = false;
  std::atomic<std::int64_t> kept_ = 0;  ///< not told yet
  std::int64_t shown_ = 0;
};

/// From rank 0 to all. While nothing comes the core is left to others.
void broadcast(void* data, std::size_t bytes) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(data, static_cast<int>(bytes), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return;
    std::this_thread::sleep_for(milliseconds(1));
  }
}

template <class Container>
void broadcast(Container& items) {
  std::int64_t count = static_cast<std::int64_t>(items.size());
  broadcast(&count, sizeof count);
  items.resize(static_cast<std::size_t>(count));
  broadcast(items.data(), items.size() * sizeof *items.data());
}

Error unreadable_for_a_rank(const std::filesystem::path& folder, const Error& error) {
  if (error.code != "no_sweep_begun") return error;
  return {"folder_not_shared", "",
          "a rank does not find " + folder.string() + "; name an output in a folder that all nodes share"};
}

/// The error of the lowest rank that has one, on all of them.
std::optional<Error> first_error(int rank, int ranks, const std::optional<Error>& own) {
  int mine = own ? rank : ranks, first = ranks;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first == ranks) return std::nullopt;
  std::string code = own ? own->code : "", message = own ? own->message : "";
  for (std::string* text : {&code, &message}) {
    auto size = static_cast<int>(text->size());
    MPI_Bcast(&size, 1, MPI_INT, first, MPI_COMM_WORLD);
    text->resize(static_cast<std::size_t>(size));
    MPI_Bcast(text->data(), size, MPI_CHAR, first, MPI_COMM_WORLD);
  }
  return Error{code, "", message};
}

/// The cores that the ranks of this node may use, shared out evenly; at most those that this one may use.
int share_of_node() {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(node, &rank);
  MPI_Comm_size(node, &ranks);
  cpu_set_t own, all;
  CPU_ZERO(&own);
  ::sched_getaffinity(0, sizeof own, &own);
  MPI_Allreduce(&own, &all, static_cast<int>(sizeof own), MPI_BYTE, MPI_BOR, node);
  MPI_Comm_free(&node);
  const int cores = CPU_COUNT(&all);
  return std::clamp(cores / ranks + (rank < cores % ranks ? 1 : 0), 1, std::max(1, CPU_COUNT(&own)));
}

}  // namespace

RankTeam::RankTeam() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  own_threads_ = share_of_node();
  MPI_Allreduce(&own_threads_, &all_threads_, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
}

RankTeam::~RankTeam() {
  std::string no_folder;
  if (leads()) broadcast(no_folder);
}

int RankTeam::threads(int wished) const { return wished > 0 ? wished * ranks_ : all_threads_; }

std::optional<Error> RankTeam::compute(const SweepPlan& plan, const SweepFolder& folder, RemainingBlocks& remaining,
                                       int threads, cli::SweepProgressLine& line) {
  std::string path = std::filesystem::absolute(folder.path()).string();
  std::vector<BlockRun> runs = remaining.runs();
  broadcast(path);
  broadcast(runs);
  broadcast(&threads, sizeof threads);
  return share(path, std::move(runs), threads, &plan, &line);
}

void RankTeam::follow() {
  for (std::string folder; broadcast(folder), !folder.empty();) {
    std::vector<BlockRun> runs;
    int threads = 0;
    broadcast(runs);
    broadcast(&threads, sizeof threads);
    (void)share(folder, std::move(runs), threads, nullptr, nullptr);  // rank 0 tells
  }
}

std::optional<Error> RankTeam::share(const std::filesystem::path& folder, std::vector<BlockRun> runs, int threads,
                                     const SweepPlan* plan, cli::SweepProgressLine* line) const {
  const auto compute = [&](const SweepRunOptions& options, RankShare& shared) -> std::optional<Error> {
    const auto begun = plan ? Result<SweepPlan>(*plan) : read_begun_sweep(folder);
    if (!begun) return unreadable_for_a_rank(folder, begun.errors().front());
    auto journal = BlockJournal::open(folder, *begun, rank_);
    if (!journal) return journal.errors().front();
    const RemainingBlocks remaining(*begun, std::move(runs));
    SharedBlocks blocks = shared.blocks(remaining);
    return run_sweep(*begun, blocks, *journal, options);
  };
  RankShare shared(rank_, line);
  const auto own = shared.run(compute, threads > 0 ? threads : own_threads_);
  return first_error(rank_, ranks_, own);
}

}  // namespace linkwright
