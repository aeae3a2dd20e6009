#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace linkwright {

/// A linear program of a few unknowns and many rows.
class SmallProgram {
 public:
  static constexpr std::size_t most_unknowns = 8;
  using Row = std::array<double, most_unknowns>;

  /// Least of the last unknown. `low`, `high`: a box that the unknowns are in, which makes it bounded.
  SmallProgram(std::span<const double> low, std::span<const double> high);
  /// Demands row · y ≤ limit; of the row the first unknowns() count.
  void add(const Row& row, double limit);
  [[nodiscard]] std::size_t unknowns() const { return unknowns_; }

  /// The unknowns, and by row its multiplier ≥ 0.
  struct Vertex {
    Row y{};
    std::array<std::size_t, most_unknowns> row{};  ///< that meet there
    Row multiplier{};                              ///< of these
  };
  /// The unknowns; nothing where the rows leave no room, or no vertex was settled on within a few hundred steps. The
  /// dual simplex method: it goes from vertex to vertex of fewer rows, and each step takes in the row that is violated
  /// most.
  [[nodiscard]] std::optional<Row> least() const;
  /// Not where it is shown that the rows leave no room; where least() is nothing and this is true, none was settled on.
  [[nodiscard]] bool has_room() const;
  /// Where that method stands after some steps, or when the last unknown has got to `enough`: no place that the rows
  /// leave has less than its last unknown. Nothing where the rows leave no room.
  [[nodiscard]] std::optional<Vertex> least_within(int steps, double enough, bool* settled = nullptr) const;

  /// Takes out all that was added.
  void clear() {
    rows_.resize(2 * unknowns_);
    limits_.resize(2 * unknowns_);
  }

 private:
  [[nodiscard]] std::size_t most_violated(const Row& y) const;

  std::size_t unknowns_;
  std::vector<Row> rows_;
  std::vector<double> limits_;
};

}  // namespace linkwright
