#include "shared_counter.hpp"

#include <algorithm>

namespace linkwright {

SharedCounter::SharedCounter() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const MPI_Aint size = rank == 0 ? slots * static_cast<MPI_Aint>(sizeof *memory_) : 0;
  MPI_Win_allocate(size, sizeof *memory_, MPI_INFO_NULL, MPI_COMM_WORLD, &memory_, &window_);
  MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
  if (rank == 0) std::fill_n(memory_, static_cast<int>(slots), 0);
  MPI_Win_sync(window_);
  MPI_Barrier(MPI_COMM_WORLD);
}

SharedCounter::~SharedCounter() {
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

std::int64_t SharedCounter::change(Slot slot, MPI_Op operation, std::int64_t by) {
  std::int64_t before = 0;
  MPI_Fetch_and_op(&by, &before, MPI_INT64_T, 0, slot, operation, window_);
  MPI_Win_flush(0, window_);
  return before;
}

}  // namespace linkwright
