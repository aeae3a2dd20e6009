#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// What a column of a sweep's tables holds, with its width in bytes: doubles (NaN where there is nothing), whole
/// numbers of 64 bits, flags (0, 1, 255 where there is nothing), UTF-8 text padded with zeros.
enum class ColumnKind { number, count, flag, text };

struct SweepColumn {
  std::string name;  ///< as in result files: lengths.ground, input.center_point[0]
  ColumnKind kind = ColumnKind::number;
  std::size_t width = 8;    ///< bytes to a row
  std::string unit;         ///< deg, the problem's unit of length, or empty
  std::string description;  ///< one line
};
[[nodiscard]] SweepColumn number_column(std::string name, std::string unit, std::string description);
[[nodiscard]] SweepColumn count_column(std::string name, std::string description);
[[nodiscard]] SweepColumn flag_column(std::string name, std::string description);
[[nodiscard]] SweepColumn text_column(std::string name, std::size_t width, std::string description);

inline constexpr std::uint8_t no_flag = 255;

/// The tables of a sweep: one row to a sample, to a linkage that is kept, to a reason why a sample has none.
enum class SweepTable { samples, linkages, failures };
inline constexpr std::array<std::string_view, 3> sweep_table_names = {"samples", "linkages", "failures"};
using SweepColumns = std::array<std::vector<SweepColumn>, sweep_table_names.size()>;

/// Rows of one table, a column at a time; bytes as this machine has them.
class TableRows {
 public:
  explicit TableRows(std::size_t columns = 0) : columns_(columns) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_.size(); }
  [[nodiscard]] const std::string& bytes(std::size_t column) const { return columns_[column]; }

  // A row is put column by column, from the first on.
  void put(double number) { put_bytes(&number, sizeof number); }
  void put(std::int64_t count) { put_bytes(&count, sizeof count); }
  void put(std::uint8_t flag) { put_bytes(&flag, sizeof flag); }
  /// Cut between two characters where it is too long for the width.
  void put(std::string_view text, std::size_t width);

  void append(const TableRows& more);

  friend bool operator==(const TableRows&, const TableRows&) = default;

 private:
  friend class SweepRows;
  void put_bytes(const void* bytes, std::size_t count);

  std::size_t rows_ = 0, next_ = 0;
  std::vector<std::string> columns_;
};

/// Rows of all tables: what a block of samples gives.
class SweepRows {
 public:
  explicit SweepRows(const SweepColumns& columns);

  [[nodiscard]] TableRows& of(SweepTable table) { return tables_[static_cast<std::size_t>(table)]; }
  [[nodiscard]] const TableRows& of(SweepTable table) const { return tables_[static_cast<std::size_t>(table)]; }
  void append(const SweepRows& more);

  /// One text of bytes for a journal, and back; false where the text is not one of these columns.
  [[nodiscard]] std::string to_bytes() const;
  [[nodiscard]] bool from_bytes(std::string_view bytes, const SweepColumns& columns);

  friend bool operator==(const SweepRows&, const SweepRows&) = default;

 private:
  std::array<TableRows, sweep_table_names.size()> tables_;
};

/// A number, flag or word of the linkages of a result file that a sweep can keep.
struct KeptColumn {
  SweepColumn column;
  bool by_default = false;  ///< kept where a sweep does not say which
};

/// All that can be kept of the linkages of a problem; columns of tolerances where it has some.
[[nodiscard]] std::vector<KeptColumn> keepable_columns(const Problem& problem);

}  // namespace linkwright
