#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "hdf5_handle.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "sweep_file.hpp"

namespace linkwright {
namespace {

constexpr std::size_t longest_attribute = 64u << 20, widest_text = 4096, most_columns = 2000;
constexpr hsize_t rows_a_piece = 4096, most_chunk_bytes = 16u << 20;

Error no_table(std::string_view why) {
  return {"no_sweep_table", "", "this is no table of a sweep: " + std::string(why), {{"why", why}}};
}

Result<Hdf5Handle> open_table(const std::filesystem::path& path);

std::optional<std::string> text_attribute(hid_t object, const char* name) {
  const Hdf5Handle attribute(::H5Aopen(object, name, H5P_DEFAULT), ::H5Aclose);
  if (!attribute) return std::nullopt;
  const Hdf5Handle stored(::H5Aget_type(attribute.id()), ::H5Tclose);
  const Hdf5Handle space(::H5Aget_space(attribute.id()), ::H5Sclose);
  if (::H5Tis_variable_str(stored.id()) <= 0 || ::H5Sget_simple_extent_npoints(space.id()) != 1) return std::nullopt;
  const Hdf5Handle type = text_type(H5T_VARIABLE);
  char* bytes = nullptr;
  if (::H5Aread(attribute.id(), type.id(), &bytes) < 0 || bytes == nullptr) return std::nullopt;
  std::string text = well_formed({bytes, ::strnlen(bytes, longest_attribute)});
  ::H5free_memory(bytes);
  return text;
}

std::optional<std::int64_t> number_attribute(hid_t object, const char* name) {
  const Hdf5Handle attribute(::H5Aopen(object, name, H5P_DEFAULT), ::H5Aclose);
  if (!attribute) return std::nullopt;
  const Hdf5Handle stored(::H5Aget_type(attribute.id()), ::H5Tclose);
  const Hdf5Handle space(::H5Aget_space(attribute.id()), ::H5Sclose);
  if (::H5Tget_class(stored.id()) != H5T_INTEGER || ::H5Sget_simple_extent_npoints(space.id()) != 1)
    return std::nullopt;
  std::int64_t number = 0;
  if (::H5Aread(attribute.id(), H5T_NATIVE_INT64, &number) < 0) return std::nullopt;
  return number;
}

Result<Hdf5Handle> open_table(const std::filesystem::path& path) {
  quiet_hdf5();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return Error{"unreadable_file", "", "this file cannot be read: No such file or directory; check its name", {}};
  if (!std::filesystem::is_regular_file(status)) return no_table("it is no regular file");
  Hdf5Handle file(::H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), ::H5Fclose);
  if (!file) return no_table("it is no HDF5 file, or may not be read");
  const auto version = number_attribute(file.id(), "linkwright_sweep");
  if (!version) return no_table("it has no attribute linkwright_sweep");
  if (*version != sweep_file_version)
    return Error{"newer_version", "", "this table was written by a newer Linkwright; use the newer program", {}};
  return file;
}

Result<SweepFileHead> head_of(hid_t file) {
  SweepFileHead head;
  for (const auto& [name, text] : {std::pair{"title", &head.title},
                                   {"version", &head.version},
                                   {"sampling", &head.sampling},
                                   {"problem", &head.problem},
                                   {"sweep", &head.sweep}}) {
    auto found = text_attribute(file, name);
    if (!found) return no_table(std::string("it has no attribute ") + name);
    *text = *std::move(found);
  }
  const auto seed = number_attribute(file, "seed"), samples = number_attribute(file, "samples");
  if (!seed || !samples) return no_table("it does not say how many samples it has");
  head.seed = *seed;
  head.samples = *samples;
  return head;
}

std::optional<SweepColumn> column_of(hid_t data, std::string_view name) {
  SweepColumn column;
  column.name = well_formed(name);
  column.unit = text_attribute(data, "unit").value_or("");
  column.description = text_attribute(data, "description").value_or("");
  const Hdf5Handle type(::H5Dget_type(data), ::H5Tclose);
  column.width = ::H5Tget_size(type.id());
  switch (::H5Tget_class(type.id())) {
    case H5T_FLOAT:
      column.kind = ColumnKind::number;
      break;
    case H5T_INTEGER:
      column.kind = column.width == 1 ? ColumnKind::flag : ColumnKind::count;
      break;
    case H5T_STRING:
      column.kind = ColumnKind::text;
      if (::H5Tis_variable_str(type.id()) != 0) return std::nullopt;
      break;
    default:
      return std::nullopt;
  }
  const bool is_text = column.kind == ColumnKind::text;
  if (column.width == 0 || column.width > (is_text ? widest_text : sizeof(double))) return std::nullopt;
  if (!is_text) column.width = column.kind == ColumnKind::flag ? 1 : 8;
  return column;
}

/// How many rows of a column are read at a time, whole chunks of them; 0 where its bytes are not all in this file, or
/// chunks are so large that no sweep has written them.
hsize_t rows_at_a_time(hid_t data, std::size_t width) {
  const Hdf5Handle properties(::H5Dget_create_plist(data), ::H5Pclose);
  const H5D_layout_t layout = ::H5Pget_layout(properties.id());
  if (layout == H5D_VIRTUAL || ::H5Pget_external_count(properties.id()) != 0) return 0;
  if (layout != H5D_CHUNKED) return rows_a_piece;
  hsize_t rows = 0;
  if (::H5Pget_chunk(properties.id(), 1, &rows) != 1 || rows == 0 || rows > most_chunk_bytes / width) return 0;
  return rows >= rows_a_piece ? rows : rows_a_piece / rows * rows;
}

/// What a piece of a column adds to its summary.
class Summarizer {
 public:
  explicit Summarizer(ColumnSummary& summary) : summary_(summary) {
    summary_.low = std::numeric_limits<double>::infinity();
    summary_.high = -summary_.low;
  }

  void add(const char* bytes) {
    switch (summary_.column.kind) {
      case ColumnKind::number: {
        double value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return add_number(value, std::isnan(value));
      }
      case ColumnKind::count: {
        std::int64_t value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return add_number(static_cast<double>(value), false);
      }
      case ColumnKind::flag: {
        const auto value = static_cast<std::uint8_t>(*bytes);
        return add_number(value, value == no_flag);
      }
      default:
        add_text({bytes, ::strnlen(bytes, summary_.column.width)});
    }
  }

 private:
  void add_number(double value, bool is_missing) {
    if (is_missing) {
      ++summary_.missing;
      return;
    }
    summary_.low = std::min(summary_.low, value);
    summary_.high = std::max(summary_.high, value);
  }
  void add_text(std::string_view text) {
    if (text.empty()) ++summary_.missing;
    const std::string word = presentable(text);
    if (summary_.words.size() < most_words || summary_.words.contains(word)) ++summary_.words[word];
  }

  ColumnSummary& summary_;
};

std::optional<ColumnSummary> summary_of(hid_t group, const std::string& name) {
  const Hdf5Handle data(::H5Dopen2(group, name.c_str(), H5P_DEFAULT), ::H5Dclose);
  auto column = data ? column_of(data.id(), name) : std::nullopt;
  const Hdf5Handle space(data ? ::H5Dget_space(data.id()) : -1, ::H5Sclose);
  if (!column || !space || ::H5Sget_simple_extent_ndims(space.id()) != 1) return std::nullopt;
  ColumnSummary summary;
  summary.column = *std::move(column);
  hsize_t rows = 0;
  ::H5Sget_simple_extent_dims(space.id(), &rows, nullptr);
  summary.rows = static_cast<std::int64_t>(rows);
  const hsize_t most = rows_at_a_time(data.id(), summary.column.width);
  if (most == 0) return std::nullopt;
  const Hdf5Handle type = memory_type(summary.column);
  std::string piece(most * summary.column.width, '\0');
  Summarizer summarizer(summary);
  for (hsize_t start = 0; start < rows; start += most) {
    const hsize_t count = std::min(most, rows - start);
    const Hdf5Handle memory(::H5Screate_simple(1, &count, nullptr), ::H5Sclose);
    ::H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &start, nullptr, &count, nullptr);
    if (::H5Dread(data.id(), type.id(), memory.id(), space.id(), H5P_DEFAULT, piece.data()) < 0) return std::nullopt;
    for (hsize_t k = 0; k < count; ++k) summarizer.add(piece.data() + k * summary.column.width);
  }
  return summary;
}

/// Names of the data sets of a group in the order in which they were made.
std::vector<std::string> column_names(hid_t group) {
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    auto& list = *static_cast<std::vector<std::string>*>(into);
    list.emplace_back(name);
    return list.size() < most_columns ? 0 : 1;
  };
  ::H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, visit, &names);
  return names;
}

}  // namespace

Result<SweepFileHead> read_sweep_head(const std::filesystem::path& path) {
  const auto file = open_table(path);
  return file ? head_of(file->id()) : Result<SweepFileHead>(file.errors());
}

bool is_head_of(const SweepFileHead& head, const SweepPlan& plan) {
  return head.problem == plan.base_text() && head.sweep == plan.sweep_text() && head.version == LINKWRIGHT_VERSION;
}

Result<SweepFileSummary> summarize_sweep_file(const std::filesystem::path& path) {
  const auto file = open_table(path);
  if (!file) return file.errors();
  auto head = head_of(file->id());
  if (!head) return head.errors();
  SweepFileSummary summary;
  summary.head = *std::move(head);
  for (std::size_t t = 0; t < sweep_table_names.size(); ++t) {
    const std::string name(sweep_table_names[t]);
    const Hdf5Handle group(::H5Gopen2(file->id(), name.c_str(), H5P_DEFAULT), ::H5Gclose);
    if (!group) return no_table("it has no group " + name);
    for (const std::string& column : column_names(group.id())) {
      auto looked_through = summary_of(group.id(), column);
      if (!looked_through) return no_table("its column " + name + "/" + presentable(column) + " cannot be read");
      summary.tables[t].push_back(*std::move(looked_through));
    }
  }
  return summary;
}

}  // namespace linkwright
