#include "linkwright/sweep/sweep_table.hpp"

#include <cstring>
#include <utility>

#include "files/linkage_columns.hpp"

namespace linkwright {
namespace {

// As many bytes of UTF-8 as fit, whole characters only.
std::string_view fitting(std::string_view text, std::size_t width) {
  if (text.size() <= width) return text;
  std::size_t size = width;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size);
}

bool take(std::string_view& bytes, std::size_t count, std::string_view& taken) {
  if (bytes.size() < count) return false;
  taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return true;
}

}  // namespace

SweepColumn number_column(std::string name, std::string unit, std::string description) {
  return {std::move(name), ColumnKind::number, sizeof(double), std::move(unit), std::move(description)};
}

SweepColumn count_column(std::string name, std::string description) {
  return {std::move(name), ColumnKind::count, sizeof(std::int64_t), "", std::move(description)};
}

SweepColumn flag_column(std::string name, std::string description) {
  return {std::move(name), ColumnKind::flag, 1, "", std::move(description)};
}

SweepColumn text_column(std::string name, std::size_t width, std::string description) {
  return {std::move(name), ColumnKind::text, width, "", std::move(description)};
}

void TableRows::put_bytes(const void* bytes, std::size_t count) {
  columns_[next_].append(static_cast<const char*>(bytes), count);
  if (++next_ < columns_.size()) return;
  next_ = 0;
  ++rows_;
}

void TableRows::put(std::string_view text, std::size_t width) {
  std::string padded(fitting(text, width));
  padded.resize(width, '\0');
  put_bytes(padded.data(), padded.size());
}

void TableRows::append(const TableRows& more) {
  for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k] += more.columns_[k];
  rows_ += more.rows_;
}

SweepRows::SweepRows(const SweepColumns& columns) {
  for (std::size_t t = 0; t < tables_.size(); ++t) tables_[t] = TableRows(columns[t].size());
}

void SweepRows::append(const SweepRows& more) {
  for (std::size_t t = 0; t < tables_.size(); ++t) tables_[t].append(more.tables_[t]);
}

std::string SweepRows::to_bytes() const {
  std::string bytes;
  for (const TableRows& table : tables_) {
    const std::uint64_t rows = table.rows_;
    bytes.append(reinterpret_cast<const char*>(&rows), sizeof rows);
    for (const std::string& column : table.columns_) bytes += column;
  }
  return bytes;
}

bool SweepRows::from_bytes(std::string_view bytes, const SweepColumns& columns) {
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    TableRows& table = tables_[t];
    table = TableRows(columns[t].size());
    std::string_view taken;
    if (!take(bytes, sizeof(std::uint64_t), taken)) return false;
    std::uint64_t rows = 0;
    std::memcpy(&rows, taken.data(), sizeof rows);
    for (std::size_t k = 0; k < columns[t].size(); ++k) {
      if (rows > bytes.size() || !take(bytes, rows * columns[t][k].width, taken)) return false;
      table.columns_[k] = taken;
    }
    table.rows_ = rows;
  }
  return bytes.empty();
}

namespace {

SweepColumn sweep_column(LinkageColumn&& column) {
  constexpr std::size_t longest_word = 48;
  switch (column.kind) {
    case LinkageColumn::Kind::flag:
      return flag_column(std::move(column.name), std::move(column.description));
    case LinkageColumn::Kind::text:
      return text_column(std::move(column.name), longest_word, std::move(column.description));
    default:
      return number_column(std::move(column.name), std::move(column.unit), std::move(column.description));
  }
}

}  // namespace

std::vector<KeptColumn> keepable_columns(const Problem& problem) {
  std::vector<KeptColumn> all;
  for (LinkageColumn& column : linkage_columns(problem)) {
    const bool by_default = column.is_usual;
    all.push_back({sweep_column(std::move(column)), by_default});
  }
  return all;
}

}  // namespace linkwright
