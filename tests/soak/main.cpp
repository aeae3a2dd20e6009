// Random problems of every kind that a file can state, drawn wide, each solved in a process of its own and its answer
// checked: script/soak. Or the problem files given.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <thread>

#include "draw.hpp"
#include "drawn_problem.hpp"
#include "trial.hpp"
#include "watched_processes.hpp"

namespace linkwright::soak {
namespace {

struct Arguments {
  std::size_t count = 300;
  std::uint64_t seed = 1;
  std::optional<std::size_t> only;
  std::string kind;
  double limit = 60;  // against hanging: ten times what the slowest takes on a busy machine
  int at_once = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::filesystem::path folder = "build/soak";
  std::vector<std::filesystem::path> files;
};

struct Finished {
  std::size_t number = 0;
  std::string kind, name;
  Trial trial;
  double seconds = 0;
};

/// What is tried: drawn tasks, or files.
class Tasks {
 public:
  explicit Tasks(const Arguments& arguments) : arguments_(&arguments) {}

  [[nodiscard]] std::vector<std::size_t> numbers() const {
    if (arguments_->only) return {*arguments_->only};
    std::vector<std::size_t> all(arguments_->files.empty() ? arguments_->count : arguments_->files.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  [[nodiscard]] std::string kind(std::size_t number) const {
    return arguments_->files.empty() ? std::string(drawn(number).kind) : "file";
  }
  [[nodiscard]] std::string name(std::size_t number) const {
    return arguments_->files.empty() ? fmt::format("{}-{}", arguments_->seed, number)
                                     : arguments_->files[number].filename().string();
  }
  [[nodiscard]] std::string text(std::size_t number) const {
    if (arguments_->files.empty()) return drawn(number).text;
    std::ifstream file(arguments_->files[number]);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Every other task is solved once more in small windows.
  [[nodiscard]] std::optional<Draw> windows(std::size_t number) const {
    Draw draw(arguments_->seed ^ 0xA5A5U, number);
    return draw.chance(0.5) ? std::optional(draw) : std::nullopt;
  }
  /// One task in twenty is also cancelled at some moment.
  [[nodiscard]] std::optional<double> cancelled_after(std::size_t number) const {
    Draw draw(~arguments_->seed, number);
    if (!draw.chance(0.05)) return std::nullopt;
    return draw.power_of_ten(-4, -0.5);
  }

 private:
  [[nodiscard]] DrawnProblem drawn(std::size_t number) const {
    const auto* const known = std::find(kinds.begin(), kinds.end(), arguments_->kind);
    return drawn_problem(arguments_->seed, number, known == kinds.end() ? std::nullopt : std::optional(*known));
  }

  const Arguments* arguments_;
};

Trial trial_of(const Ended& ended) {
  if (ended.how == Ended::How::said) return read_trial(ended.text);
  if (ended.how == Ended::How::over_time) return {"over time", 0, ended.seconds, {"did not end in time"}};
  return {"crashed", 0, ended.seconds, {"crashed: " + ended.text}};
}

std::vector<Finished> finished_tasks(const Arguments& arguments, const Tasks& tasks) {
  std::vector<Finished> finished;
  const ProcessLimits limits{arguments.at_once, arguments.limit, 20 + 10 * arguments.limit};
  run_apart(
      tasks.numbers(), limits,
      [&](std::size_t number) {
        return written(tried(tasks.text(number), tasks.cancelled_after(number), tasks.windows(number)));
      },
      [&](std::size_t number, const Ended& ended) {
        finished.push_back({number, tasks.kind(number), tasks.name(number), trial_of(ended), ended.seconds});
      });
  std::sort(finished.begin(), finished.end(), [](const Finished& a, const Finished& b) { return a.number < b.number; });
  return finished;
}

void print_counts(const std::vector<Finished>& finished) {
  struct Row {
    int tasks = 0, with_linkages = 0, without = 0, refused = 0, findings = 0;
    double seconds = 0;
  };
  std::map<std::string, Row> rows;
  for (const Finished& one : finished)
    for (const std::string& name : {one.kind, std::string("~ all")}) {  // sorts last
      Row& row = rows[name];
      ++row.tasks;
      row.refused += one.trial.outcome == "refused";
      row.with_linkages += one.trial.linkages > 0;
      row.without += one.trial.linkages == 0 && one.trial.outcome != "refused";
      row.findings += !one.trial.findings.empty();
      row.seconds += one.seconds;
    }
  fmt::print("{:<16}{:>8}{:>10}{:>10}{:>10}{:>10}{:>12}\n", "kind", "tasks", "linkages", "none", "refused", "findings",
             "ms a task");
  for (const auto& [name, row] : rows)
    fmt::print("{:<16}{:>8}{:>10}{:>10}{:>10}{:>10}{:>12.1f}\n", name, row.tasks, row.with_linkages, row.without,
               row.refused, row.findings, 1e3 * row.seconds / row.tasks);
}

void print_slowest(std::vector<Finished> finished) {
  constexpr std::size_t shown = 10;
  std::sort(finished.begin(), finished.end(),
            [](const Finished& a, const Finished& b) { return a.seconds > b.seconds; });
  finished.resize(std::min(finished.size(), shown));
  fmt::print("slowest:");
  for (const Finished& one : finished) fmt::print(" {} ({}) {:.2f} s;", one.name, one.kind, one.seconds);
  fmt::print("\n");
}

void print_findings(const Arguments& arguments, const Tasks& tasks, const std::vector<Finished>& finished) {
  for (const Finished& one : finished) {
    if (one.trial.findings.empty()) continue;
    fmt::print("{} ({}):\n", one.name, one.kind);
    for (const std::string& finding : one.trial.findings) fmt::print("  {}\n", finding);
    if (!arguments.files.empty()) continue;
    std::filesystem::create_directories(arguments.folder);
    std::ofstream(arguments.folder / (one.name + ".json")) << tasks.text(one.number);
  }
}

int soak(const Arguments& arguments) {
  const Tasks tasks(arguments);
  const auto finished = finished_tasks(arguments, tasks);
  print_counts(finished);
  print_slowest(finished);
  print_findings(arguments, tasks, finished);
  const auto wrong =
      std::count_if(finished.begin(), finished.end(), [](const Finished& one) { return !one.trial.findings.empty(); });
  fmt::print("{} tasks, {} with findings{}\n", finished.size(), wrong,
             wrong > 0 && arguments.files.empty() ? " (kept in " + arguments.folder.string() + ")" : "");
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace linkwright::soak

int main(int argc, char** argv) {
  using namespace linkwright::soak;
  Arguments arguments;
  CLI::App app("Solves random tasks of every kind, or the problem files given, and checks the answers");
  app.add_option("--count", arguments.count, "How many tasks");
  app.add_option("--seed", arguments.seed, "They are drawn anew with each seed");
  app.add_option("--only", arguments.only, "The task of this number alone");
  app.add_option("--kind", arguments.kind, "Tasks of this kind alone")
      ->check(CLI::IsMember(std::vector<std::string>(kinds.begin(), kinds.end())));
  app.add_option("--limit", arguments.limit, "Seconds of processor time that a task may take");
  app.add_option("--processes", arguments.at_once, "Tasks at once");
  app.add_option("--folder", arguments.folder, "Where tasks with findings are kept");
  app.add_option("FILES", arguments.files, "Problem files")->check(CLI::ExistingFile);
  bool only_print = false;
  app.add_flag("--print", only_print, "Print the task of --only instead of solving it");
  CLI11_PARSE(app, argc, argv);
  if (only_print && arguments.only) {
    const auto* const known = std::find(kinds.begin(), kinds.end(), arguments.kind);
    fmt::print("{}", drawn_problem(arguments.seed, *arguments.only,
                                   known == kinds.end() ? std::nullopt : std::optional(*known))
                         .text);
    return 0;
  }
  return soak(arguments);
}
