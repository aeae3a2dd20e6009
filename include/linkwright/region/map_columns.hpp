#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace linkwright {

/// Memory that is not cleared, in large pages where the system has them (a map of 10⁸ cells is half a million small
/// ones). Throws std::bad_alloc.
[[nodiscard]] void* allocate_cells(std::size_t bytes);
/// Gives back memory of allocate_cells().
struct FreeCells {
  void operator()(void* cells) const;
};

/// Memory of one property over the cells of a map, not cleared when made: who judges writes every cell.
template <class T>
class Column {
 public:
  /// Values are lost where the size changes. Throws std::bad_alloc, and then the column is empty.
  void resize(std::size_t size) {
    if (size == size_) return;
    size_ = 0;
    values_.reset();
    values_.reset(static_cast<T*>(allocate_cells(size * sizeof(T))));
    size_ = size;
  }
  /// Null while the column is empty.
  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] std::span<const T> view() const { return {values_.get(), size_}; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }

 private:
  std::unique_ptr<T[], FreeCells> values_;
  std::size_t size_ = 0;
};

}  // namespace linkwright
