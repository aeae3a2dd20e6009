#include "trial.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "answer_check.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "window_trial.hpp"

namespace linkwright::soak {
namespace {

using Clock = std::chrono::steady_clock;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// How long solving goes on after it was told to stop: by the clock or by the processor, whichever is shorter, so that
/// neither a busy machine nor a second thread counts against it. Nothing where it was done before.
std::optional<double> seconds_to_stop(const Problem& problem, double cancel_after) {
  std::atomic<bool> cancelled = false, done = false;
  double told_at = 0;
  Clock::time_point told;
  std::thread canceller([&] {
    const auto moment = Clock::now() + std::chrono::duration<double>(cancel_after);
    while (Clock::now() < moment && !done) std::this_thread::sleep_for(std::chrono::microseconds(200));
    told = Clock::now();
    told_at = processor_seconds();
    cancelled = true;
  });
  Progress progress;
  progress.cancelled = &cancelled;
  const auto solution = solve(problem, progress);
  const bool in_time = cancelled;
  done = true;
  canceller.join();
  if (!in_time) return std::nullopt;
  const double by_clock = std::chrono::duration<double>(Clock::now() - told).count();
  return std::min(by_clock, processor_seconds() - told_at);
}

void check_cancelling(const Problem& problem, double cancel_after, Trial& trial) {
  constexpr double longest = 0.5;
  const auto seconds = seconds_to_stop(problem, cancel_after);
  if (seconds && *seconds > longest)
    trial.findings.push_back(fmt::format("stopped {:.2f} s after it was told to", *seconds));
}

void check_drawing(const Problem& problem, const Answer& answer, Trial& trial) {
  const std::string picture = draw_answer(problem, answer);
  for (const char* word : {"nan", "inf"})
    for (const char* before : {"\"", " ", ",", "-"})
      if (picture.find(std::string(before) + word + "\"") != std::string::npos ||
          picture.find(std::string(before) + word + " ") != std::string::npos)
        trial.findings.push_back(fmt::format("{} stands in the picture", word));
}

}  // namespace

Trial tried(std::string_view problem_text, std::optional<double> cancel_after, std::optional<Draw> windows) {
  auto problem = read_problem(problem_text);
  if (!problem) return {"refused", 0, 0, {}};
  Trial trial;
  if (cancel_after) check_cancelling(*problem, *cancel_after, trial);
  problem->options.region.threads = 1;  // so that times are those of the work
  const double start = processor_seconds();
  const auto solution = solve(*problem);
  trial.solve_seconds = processor_seconds() - start;
  if (!solution) {
    trial.outcome = "refused";
    trial.findings.push_back("read, but not solved: " + solution.errors().front().message);
    return trial;
  }
  constexpr bool with_region = false;
  const auto wrongs = wrongs_of(*problem, *solution, write_result(*problem, *solution, with_region));
  trial.findings.insert(trial.findings.end(), wrongs.begin(), wrongs.end());
  check_drawing(*problem, *solution, trial);
  if (windows) {
    const auto missed = wrongs_in_windows(*problem, *solution, *windows);
    trial.findings.insert(trial.findings.end(), missed.begin(), missed.end());
  }
  trial.outcome = name(findings(*solution).status);
  trial.linkages = static_cast<int>(linkage_count(*solution));
  return trial;
}

std::string written(const Trial& trial) {
  return nlohmann::json{{"outcome", trial.outcome},
                        {"linkages", trial.linkages},
                        {"solve_seconds", trial.solve_seconds},
                        {"findings", trial.findings}}
      .dump();
}

Trial read_trial(const std::string& text) {
  const auto read = nlohmann::json::parse(text);
  return {read["outcome"], read["linkages"], read["solve_seconds"], read["findings"]};
}

}  // namespace linkwright::soak
