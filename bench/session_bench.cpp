// What the page asks of its engine, by the native engine: web/scripts/bench.mjs asks the same of the page's own. Names
// and questions are the same there; a pose of the tailgate moves before each map, as in a drag.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

#include "session.hpp"

namespace linkwright::bench::session_bench {
namespace {

using wasm::ExploreRequest, wasm::HaloRequest, wasm::Session;

constexpr double some_input = 1.3125, some_output = 1.1125;

std::string example(const std::string& name) {
  std::ifstream file(LINKWRIGHT_EXAMPLES_DIR "/" + name + ".json");
  return {std::istreambuf_iterator<char>(file), {}};
}
std::string tailgate() { return example("tailgate"); }
std::string moved(std::string text, int step) {
  const std::string x = "\"x\": -220, \"y\": 220";
  return text.replace(text.find(x), x.size(), fmt::format("\"x\": {}, \"y\": 220", -220 - 0.01 * (step % 100)));
}
ExploreRequest whole_map(int samples) {
  ExploreRequest request;
  request.samples = samples;
  return request;
}

void session_drag(benchmark::State& state) {
  const std::string text = tailgate();
  Session session;
  int step = 0;
  for (auto _ : state) {
    session.set_problem(moved(text, ++step));
    benchmark::DoNotOptimize(session.explore(whole_map(static_cast<int>(state.range(0)))));
  }
}
BENCHMARK(session_drag)
    ->Name("session/drag")
    ->Arg(100)
    ->Arg(400)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// A file is opened: everything up to the first map.
void session_open(benchmark::State& state, const char* name) {
  const std::string text = example(name);
  for (auto _ : state) {
    Session session;
    session.set_problem(text);
    benchmark::DoNotOptimize(session.explore(whole_map(400)));
  }
}
const bool opened = [] {
  for (const char* name : {"tailgate", "latch", "airtight_hatch", "transfer_arm", "nose_gear", "sine_generator",
                           "flow_meter", "log_generator", "loader_bucket_chain"})
    benchmark::RegisterBenchmark(fmt::format("session/open/{}", name).c_str(), session_open, name)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  return true;
}();

template <class Question>
void asked(benchmark::State& state, Question&& question) {
  Session session;
  session.set_problem(tailgate());
  benchmark::DoNotOptimize(session.explore(whole_map(400)));
  for (auto _ : state) benchmark::DoNotOptimize(question(session));
}
void session_hover(benchmark::State& state) {
  asked(state, [](Session& session) { return session.linkage(some_input, some_output); });
}
void session_live(benchmark::State& state) {
  asked(state, [](Session& session) { return session.live(some_input, some_output); });
}
void session_halo(benchmark::State& state) {
  asked(state, [](Session& session) { return session.halo(HaloRequest{2, false, 120, 13, 60}); });
}
void session_best(benchmark::State& state) {
  asked(state, [](Session& session) { return session.best(1); });
}
void session_improve(benchmark::State& state) {
  asked(state, [](Session& session) { return session.improve(some_input, some_output); });
}
BENCHMARK(session_hover)->Name("session/hover")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_live)->Name("session/live")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_halo)->Name("session/halo")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_best)->Name("session/best")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(session_improve)->Name("session/improve")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace linkwright::bench::session_bench
