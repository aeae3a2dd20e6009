// What a number of SharedCounter costs the ranks that fetch them: mpirun -n 3 linkwright_mpi_bench [FETCHES]
// Rank 0 only looks up once a millisecond, as it does while its threads compute. bench/sweep_ranks.py calls this.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "shared_counter.hpp"

namespace {

using Clock = std::chrono::steady_clock;

void look_up_until_all_have_fetched() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int done = 0; !done;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    int flag = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &flag, MPI_STATUS_IGNORE);
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
}

double fetch(linkwright::SharedCounter& counter, int fetches) {
  const auto begun = Clock::now();
  for (int k = 0; k < fetches; ++k) (void)counter.next();
  const double microseconds = std::chrono::duration<double, std::micro>(Clock::now() - begun).count() / fetches;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
  return microseconds;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int fetches = argc > 1 ? std::atoi(argv[1]) : 1000;
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  {
    linkwright::SharedCounter counter;
    double mine = 0, largest = 0;
    if (rank == 0)
      look_up_until_all_have_fetched();
    else
      mine = fetch(counter, fetches);
    MPI_Reduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
    if (rank == 0) std::printf("%.3f\n", largest);
  }
  MPI_Finalize();
}
