#include "small_program.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most = SmallProgram::most_unknowns;

/// The rows of a basis, taken apart into triangles with pivots from columns: it solves for the rows and for the
/// columns.
class Basis {
 public:
  Basis(const std::vector<SmallProgram::Row>& rows, const std::array<std::size_t, most>& of, std::size_t n) : n_(n) {
    for (std::size_t i = 0; i < n; ++i) {
      a_[i] = rows[of[i]];
      order_[i] = i;
    }
    for (std::size_t k = 0; k < n && regular_; ++k) eliminate(k);
  }
  [[nodiscard]] bool is_regular() const { return regular_; }

  /// x with row · x = b of each row.
  [[nodiscard]] SmallProgram::Row by_rows(const SmallProgram::Row& b) const {
    SmallProgram::Row x{};
    for (std::size_t i = 0; i < n_; ++i) {
      x[i] = b[order_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= a_[i][j] * x[j];
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) x[i] -= a_[i][j] * x[j];
      x[i] /= a_[i][i];
    }
    return x;
  }
  /// x with Σ x_i row_i = b.
  [[nodiscard]] SmallProgram::Row by_columns(const SmallProgram::Row& b) const {
    SmallProgram::Row z = b;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < i; ++j) z[i] -= a_[j][i] * z[j];
      z[i] /= a_[i][i];
    }
    SmallProgram::Row x{};
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) z[i] -= a_[j][i] * z[j];
      x[order_[i]] = z[i];
    }
    return x;
  }

 private:
  void eliminate(std::size_t k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n_; ++i)
      if (std::abs(a_[i][k]) > std::abs(a_[pivot][k])) pivot = i;
    std::swap(a_[k], a_[pivot]);
    std::swap(order_[k], order_[pivot]);
    regular_ = std::abs(a_[k][k]) > 1e-13;
    if (!regular_) return;
    for (std::size_t i = k + 1; i < n_; ++i) {
      a_[i][k] /= a_[k][k];
      for (std::size_t j = k + 1; j < n_; ++j) a_[i][j] -= a_[i][k] * a_[k][j];
    }
  }

  std::size_t n_;
  std::array<SmallProgram::Row, most> a_{};
  std::array<std::size_t, most> order_{};
  bool regular_ = true;
};

}  // namespace

SmallProgram::SmallProgram(std::span<const double> low, std::span<const double> high) : unknowns_(low.size()) {
  require(low.size() == high.size() && unknowns_ <= most_unknowns, "a program has as many limits as unknowns");
  // The first rows are the basis to begin with: all unknowns at their lower limits.
  for (std::size_t k = 0; k < unknowns_; ++k) {
    Row row{};
    row[k] = -1;
    add(row, -low[k]);
  }
  for (std::size_t k = 0; k < unknowns_; ++k) {
    Row row{};
    row[k] = 1;
    add(row, high[k]);
  }
}

void SmallProgram::add(const Row& row, double limit) {
  rows_.push_back(row);
  limits_.push_back(limit);
}

namespace {
constexpr int most_steps = 400;
}

bool SmallProgram::has_room() const {
  return least_within(most_steps, std::numeric_limits<double>::infinity()).has_value();
}

std::optional<SmallProgram::Row> SmallProgram::least() const {
  bool settled = false;
  const auto vertex = least_within(most_steps, std::numeric_limits<double>::infinity(), &settled);
  return vertex && settled ? std::optional(vertex->y) : std::nullopt;
}

/// The row that a place violates most, with regard to the sizes of its numbers; none: the number of rows.
std::size_t SmallProgram::most_violated(const Row& y) const {
  constexpr double rounding = 1e-11;
  std::size_t worst = rows_.size();
  double by = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    double value = -limits_[i], size = std::abs(limits_[i]) + 1;
    for (std::size_t k = 0; k < most_unknowns; ++k) {
      const double part = rows_[i][k] * y[k];
      value += part;
      size += std::abs(part);
    }
    if (value > by && value > rounding * size) {
      worst = i;
      by = value;
    }
  }
  return worst;
}

std::optional<SmallProgram::Vertex> SmallProgram::least_within(int steps, double enough, bool* settled) const {
  const std::size_t n = unknowns_;
  Vertex at;
  for (std::size_t k = 0; k < n; ++k) at.row[k] = k;
  Row down{};
  down[n - 1] = -1;
  Vertex last = at;
  for (int step = 0;; ++step) {
    const Basis basis(rows_, at.row, n);
    if (!basis.is_regular()) return step > 0 ? std::optional(last) : std::nullopt;
    Row limits{};
    for (std::size_t k = 0; k < n; ++k) limits[k] = limits_[at.row[k]];
    at.y = basis.by_rows(limits);
    at.multiplier = basis.by_columns(down);
    last = at;
    const std::size_t worst = most_violated(at.y);
    if (settled) *settled = worst == rows_.size();
    if (worst == rows_.size() || step >= steps || at.y[n - 1] >= enough) return at;
    // Which row gives way: the multipliers of the others stay ≥ 0.
    const Row shares = basis.by_columns(rows_[worst]);
    std::size_t leaves = n;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      if (!(shares[k] > 1e-11)) continue;
      const double ratio = at.multiplier[k] / shares[k];
      if (ratio < least || (ratio == least && at.row[k] < at.row[leaves])) {
        least = ratio;
        leaves = k;
      }
    }
    if (leaves == n) return std::nullopt;  // no room
    at.row[leaves] = worst;
  }
}

}  // namespace linkwright
