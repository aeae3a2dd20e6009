#pragma once

#include <cstdint>
#include <mpi.h>

namespace linkwright {

/// The numbers 0, 1, 2, … each given out once to one of all ranks, and a sum that all add to. They stand in memory of
/// rank 0, which the others reach by themselves: nobody answers. Made and ended by all ranks together; one thread of a
/// rank at a time may call it.
class SharedCounter {
 public:
  SharedCounter();
  ~SharedCounter();
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  [[nodiscard]] std::int64_t next() { return change(number, MPI_SUM, 1); }
  /// No rank is given another number: what next() gives is `stopped` or above.
  void stop() { change(number, MPI_MAX, stopped); }
  [[nodiscard]] bool is_stopped() { return change(number, MPI_NO_OP, 0) >= stopped; }
  /// What the sum is now.
  std::int64_t add_to_sum(std::int64_t more) { return change(sum, MPI_SUM, more) + more; }

  static constexpr std::int64_t stopped = std::int64_t{1} << 62;  ///< no sweep has so many blocks

 private:
  enum Slot { number, sum, slots };
  /// What stood there before.
  std::int64_t change(Slot slot, MPI_Op operation, std::int64_t by);

  std::int64_t* memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace linkwright
