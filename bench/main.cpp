// linkwright_bench [options of Google Benchmark]
// linkwright_bench --dump TASK SAMPLES     the sampled grounded links and the kernel's counts, JSON, for the peers
// linkwright_bench --dump-sphere SAMPLES   the same of a spherical task
// linkwright_bench --dump-lines SAMPLES    the task of a straight line, and what its linkages are worth
// linkwright_bench --dump-tolerances SAMPLES   a linkage, its tolerances, and how far its samples are off
// linkwright_bench --dump-path SAMPLES   places of arms and the number of their linkages; four-bars between two pivots
// linkwright_bench --dump-loads SAMPLES   linkages of a map, what acts on them, and the forces of the hand
// linkwright_bench --dump-curves           closed paths drawn at random, and the types of their linkages
// linkwright_bench --dump-five COUNT       random tasks of five poses and their Burmester points, JSON, for the peer
// linkwright_bench --dump-five-orientations COUNT      the same of five orientations and their dyads

#include <benchmark/benchmark.h>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>

#include "bench_task.hpp"

int main(int argc, char** argv) {
  if (argc == 4 && std::string_view(argv[1]) == "--dump") {
    fmt::print("{}\n", linkwright::bench::dump(argv[2], std::atoi(argv[3])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-five") {
    fmt::print("{}\n", linkwright::bench::dump_five(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-five-orientations") {
    fmt::print("{}\n", linkwright::bench::dump_five_orientations(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-sphere") {
    fmt::print("{}\n", linkwright::bench::dump_sphere(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-lines") {
    fmt::print("{}\n", linkwright::bench::dump_lines(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-tolerances") {
    fmt::print("{}\n", linkwright::bench::dump_tolerances(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-loads") {
    fmt::print("{}\n", linkwright::bench::dump_loads(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "--dump-path") {
    fmt::print("{}\n", linkwright::bench::dump_path(std::atoi(argv[2])));
    return 0;
  }
  if (argc == 2 && std::string_view(argv[1]) == "--dump-curves") {
    fmt::print("{}\n", linkwright::bench::dump_curves());
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
