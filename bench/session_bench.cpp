// What the page asks of its engine, by the native engine: web/scripts/bench.mjs asks the same of the page's own. Names
// and questions are the same there; a pose of the tailgate moves, an
// orientation of the folding wing turns, or the line of the crane is shifted, before each map, as in a drag.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "session.hpp"

namespace linkwright::bench::session_bench {
namespace {

using wasm::PageSession;

constexpr double some_input = 1.3125, some_output = 1.1125;

std::string example(const std::string& name) {
  std::ifstream file(LINKWRIGHT_EXAMPLES_DIR "/" + name + ".json");
  return {std::istreambuf_iterator<char>(file), {}};
}
std::string tailgate() { return example("tailgate"); }

/// An example and a number in it that a drag changes, between the texts before and after it.
struct Dragged {
  const char* name;
  std::string before;
  double number;
  std::string after;

  [[nodiscard]] std::string text(int step) const {
    std::string text = example(name);
    const std::string old = fmt::format("{}{}{}", before, number, after);
    return text.replace(text.find(old), old.size(), fmt::format("{}{}{}", before, number - 0.01 * (step % 100), after));
  }
};
const Dragged tailgate_pose{"tailgate", "\"x\": ", -220, ", \"y\": 220"};
const Dragged wing_orientation{"folding_wing", "[-40, 16, ", 62, "]"};
const Dragged crane_line{"straight_luffing_crane", "\"line\": {\"point\": [9, ", 16, "]"};

MapRequest whole_map(int samples) {
  MapRequest request;
  request.samples = samples;
  return request;
}

void session_drag(benchmark::State& state, const Dragged& dragged) {
  std::vector<std::string> texts;
  for (int step = 0; step < 100; ++step) texts.push_back(dragged.text(step));
  PageSession session;
  std::size_t step = 0;
  for (auto _ : state) {
    session.set_problem(texts[++step % texts.size()]);
    benchmark::DoNotOptimize(session.explore(whole_map(static_cast<int>(state.range(0)))));
  }
}
BENCHMARK_CAPTURE(session_drag, pose, tailgate_pose)
    ->Name("session/drag")
    ->Arg(100)
    ->Arg(400)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(session_drag, orientation, wing_orientation)
    ->Name("session/turn")
    ->Arg(400)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(session_drag, line, crane_line)
    ->Name("session/line")
    ->Arg(100)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// A file is opened: everything up to the first map.
void session_open(benchmark::State& state, const char* name) {
  const std::string text = example(name);
  for (auto _ : state) {
    PageSession session;
    session.set_problem(text);
    benchmark::DoNotOptimize(session.explore(whole_map(400)));
  }
}
const bool opened = [] {
  for (const char* name : {"tailgate", "latch", "airtight_hatch", "transfer_arm", "nose_gear", "sine_generator",
                           "flow_meter", "log_generator", "loader_bucket_chain", "folding_wing", "ankle_orthosis",
                           "universal_joint_like", "straight_stage"})
    benchmark::RegisterBenchmark(fmt::format("session/open/{}", name).c_str(), session_open, name)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  return true;
}();

template <class Question>
void asked(benchmark::State& state, Question&& question) {
  PageSession session;
  session.set_problem(tailgate());
  benchmark::DoNotOptimize(session.explore(whole_map(400)));
  for (auto _ : state) benchmark::DoNotOptimize(question(session));
}
void session_hover(benchmark::State& state) {
  asked(state, [](PageSession& session) { return session.linkage({some_input, some_output}); });
}
void session_live(benchmark::State& state) {
  asked(state, [](PageSession& session) { return session.live({some_input, some_output}); });
}
void session_halo(benchmark::State& state) {
  asked(state, [](PageSession& session) { return session.halo(HaloRequest{2, false, 120, 13, 60}); });
}
void session_best(benchmark::State& state) {
  asked(state, [](PageSession& session) { return session.best(1); });
}
void session_improve(benchmark::State& state) {
  asked(state, [](PageSession& session) { return session.improve({some_input, some_output}); });
}
BENCHMARK(session_hover)->Name("session/hover")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_live)->Name("session/live")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_halo)->Name("session/halo")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_best)->Name("session/best")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_improve)->Name("session/improve")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace linkwright::bench::session_bench
