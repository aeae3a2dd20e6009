#include "sweep_command.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <functional>

#include "console.hpp"
#include "in_child.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/sweep/run_sweep.hpp"
#include "report.hpp"
#include "sweep_file.hpp"

namespace linkwright::cli {
namespace {

/// The machine's no, not the caller's: what is done is kept.
bool is_failure(const Error& error) {
  constexpr std::array codes = {"unwritable_output", "unreadable_journal", "missing_block",
                                "folder_not_shared", "out_of_memory",      "rank_failed"};
  return std::find(codes.begin(), codes.end(), error.code) != codes.end();
}

int refused(const std::string& file, const std::vector<Error>& errors) {
  print_mistakes(file, errors);
  return is_failure(errors.front()) ? failure : mistake;
}

int stopped() {
  print_failure(Interruption::words());
  return Interruption::exit_status();
}

void tell_what_is_lost(const JournalScan& scan) {
  if (scan.torn > 0) print_failure("the last block was not written whole; it is computed anew");
  if (scan.corrupt > 0)
    print_failure(fmt::format("{} of what was kept {} corrupt; those blocks are computed anew",
                              scan.corrupt == 1 ? "one piece" : grouped_text(scan.corrupt) + " pieces",
                              scan.corrupt == 1 ? "is" : "are"));
}

/// The table is there and no sweep to it is begun: nothing is left to resume.
bool is_finished(const std::filesystem::path& output) {
  std::error_code error;
  return std::filesystem::exists(output, error) && !SweepFolder::is_begun(output);
}

/// Many times what reading a whole table takes.
std::chrono::seconds patience_for(const std::filesystem::path& table) {
  constexpr std::uintmax_t bytes_a_second = 100'000;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(table, error);
  return std::chrono::seconds(60 + (error ? 0 : size / bytes_a_second));
}

/// Reads a table of HDF5 and tells of it.
int read_apart(const std::filesystem::path& path, const std::function<int()>& work) {
  const ChildEnd end = in_child(patience_for(path), work);
  if (end.status) return *end.status;
  if (Interruption::happened()) return stopped();
  if (end.crashed())
    return refused(path.string(), {Error{"damaged_table", "", "this table is damaged: HDF5 fails when it is read"}});
  if (end.signal == SIGPIPE) std::raise(SIGPIPE);  // whoever reads the answer has heard enough
  print_failure(end.signal == 0 ? "there is no process to be had that reads the table"
                                : fmt::format("the process that read the table was ended by signal {}", end.signal));
  return failure;
}

int tell_finished(const std::filesystem::path& output, const SweepPlan& plan) {
  const auto head = read_sweep_head(output);
  if (!head) return refused(output.string(), head.errors());
  if (!is_head_of(*head, plan))
    return refused(output.string(), {Error{"another_sweep", "",
                                           "this is the table of another sweep or version; --overwrite replaces it"}});
  SweepFolder::tidy_up(output);
  const auto text = fmt::format("{} is complete: {} samples\n", output.string(), grouped_text(plan.samples()));
  return print_answer(text) ? 0 : failure;
}

/// Blocks that are not done, into journals; the exit status where that ends early.
std::optional<int> compute(const SweepPlan& plan, const SweepFolder& folder, const SweepArguments& arguments,
                           SweepWorkers& workers) {
  const auto scan = folder.scan(plan);
  if (!scan) return refused(arguments.output, scan.errors());
  tell_what_is_lost(*scan);
  RemainingBlocks remaining(plan, *scan);
  SweepProgressLine line(plan.samples(), plan.samples() - remaining.samples());
  const auto error = workers.compute(plan, folder, remaining, arguments.threads, line);
  if (error) return refused(arguments.output, {*error});
  if (Interruption::happened()) return stopped();
  return std::nullopt;
}

/// Where an output leads to, as AtomicFile has it.
Result<std::filesystem::path> followed(const std::filesystem::path& output) {
  std::error_code error;
  if (!std::filesystem::is_symlink(output, error)) return output;
  auto target = std::filesystem::canonical(output, error);
  if (!error) return target;
  return Error{"not_a_regular_file", "",
               "this output path is a symbolic link that leads nowhere; it was left alone, name another file"};
}

int run(const SweepPlan& plan, const SweepArguments& arguments, SweepWorkers& workers) {
  const auto target = followed(arguments.output);
  if (!target) return refused(arguments.output, target.errors());
  const std::filesystem::path& output = *target;
  if (arguments.resumes && is_finished(output)) return read_apart(output, [&] { return tell_finished(output, plan); });
  const SweepStart start = arguments.resumes      ? SweepStart::resume
                           : arguments.overwrites ? SweepStart::overwrite
                                                  : SweepStart::fresh;
  auto folder = SweepFolder::open(output, plan, start);
  if (!folder) return refused(arguments.output, folder.errors());
  Interruption::set_words("stopped; what is done is kept, and the same command with --resume goes on");
  const auto begun = std::chrono::steady_clock::now();
  if (const auto status = compute(plan, *folder, arguments, workers)) return *status;
  const auto failed = write_sweep_file(output, plan, *folder);
  if (failed) return Interruption::happened() ? stopped() : refused(arguments.output, {*failed});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const std::string text =
      fmt::format("{} samples are in {}, after {}; linkwright sweep --inspect tells what they are\n",
                  grouped_text(plan.samples()), output.string(), duration_text(seconds));
  return print_answer(text) ? 0 : failure;
}

/// What one sample takes, from a few that are spread over all of them.
std::optional<double> seconds_a_sample(const SweepPlan& plan) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t most = 5;
  constexpr double patience = 3;
  const auto begun = Clock::now();
  double seconds = 0;
  std::int64_t tried = 0;
  for (; tried < std::min(most, plan.samples()) && seconds < patience; ++tried) {
    const std::int64_t sample = (2 * tried + 1) * (plan.samples() / (2 * most)) % plan.samples();
    if (!sweep_samples(plan, sample, sample + 1, Interruption::flag())) return std::nullopt;
    seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  }
  return seconds / static_cast<double>(tried);
}

int dry_run(const SweepPlan& plan, int threads) {
  const auto seconds = seconds_a_sample(plan);
  if (!seconds) return stopped();
  const double all = *seconds * static_cast<double>(plan.samples()) / threads;
  const std::string text =
      report_plan(plan) + fmt::format("A sample takes about {} ms, all of them about {} on {} thread{}.\n",
                                      significant_text(1e3 * *seconds, 2), duration_text(all), threads,
                                      threads == 1 ? "" : "s");
  return print_answer(text) ? 0 : failure;
}

int inspect_begun(const std::filesystem::path& folder) {
  const auto plan = read_begun_sweep(folder);
  if (!plan) return refused(folder.string(), plan.errors());
  const auto scan = scan_journals(folder, *plan);
  if (!scan) return refused(folder.string(), scan.errors());
  const std::int64_t left = RemainingBlocks(*plan, *scan).samples();
  const std::string text =
      report_plan(*plan) + fmt::format("{} of {} samples are done{}; the same sweep with --resume goes on.\n",
                                       grouped_text(plan->samples() - left), grouped_text(plan->samples()),
                                       scan->corrupt > 0 ? fmt::format(", {} pieces are corrupt", scan->corrupt) : "");
  return print_answer(text) ? 0 : failure;
}

int inspect(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return inspect_begun(path);
  const std::filesystem::path begun = SweepFolder::beside(path);
  if (!std::filesystem::exists(path, error) && std::filesystem::is_directory(begun, error)) return inspect_begun(begun);
  return read_apart(path, [&path] {
    const auto summary = summarize_sweep_file(path);
    if (!summary) return refused(path.string(), summary.errors());
    return print_answer(report_sweep_file(*summary)) ? 0 : failure;
  });
}

int usage(std::string_view message) {
  print_failure(fmt::format("{}; see linkwright sweep --help", message));
  return mistake;
}

}  // namespace

int ThreadsHere::threads(int wished) const { return wished > 0 ? wished : available_threads(); }

std::optional<Error> ThreadsHere::compute(const SweepPlan& plan, const SweepFolder& folder, RemainingBlocks& remaining,
                                          int threads, SweepProgressLine& line) {
  auto journal = BlockJournal::open(folder.path(), plan, 0);
  if (!journal) return journal.errors().front();
  const SweepRunOptions options{threads, Interruption::flag(), [&line](std::int64_t samples) { line.add(samples); }};
  return run_sweep(plan, remaining, *journal, options);
}

int sweep(const SweepArguments& arguments, SweepWorkers& workers) {
  const Interruption interruption(Interruption::Answer::when_asked);
  if (const auto missing = missing_sweep_files()) {
    print_failure(missing->message);
    return failure;
  }
  if (!arguments.inspected.empty()) return inspect(arguments.inspected);
  if (arguments.sweep.empty()) return usage("SWEEP is required, or --inspect");
  const auto plan = read_sweep_file(arguments.sweep);
  if (!plan) return refused(arguments.sweep == "-" ? "standard input" : arguments.sweep, plan.errors());
  if (arguments.is_dry) return dry_run(*plan, workers.threads(arguments.threads));
  if (arguments.output.empty()) return usage("--output is required, or --dry-run");
  if (arguments.output == "-") return usage("a table cannot go to standard output; name a file");
  return run(*plan, arguments, workers);
}

}  // namespace linkwright::cli
