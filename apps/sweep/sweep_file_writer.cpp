#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "hdf5_handle.hpp"
#include "in_child.hpp"
#include "sweep_file.hpp"

namespace linkwright {
namespace {

constexpr std::size_t chunk_bytes = 1 << 16;

/// The system's reason for the failure that HDF5 met first, or HDF5's own words.
std::string hdf5_reason() {
  std::string reason;
  const auto visit = [](unsigned depth, const H5E_error2_t* error, void* into) -> herr_t {
    auto& words = *static_cast<std::string*>(into);
    if (depth == 0 && error->desc) words = error->desc;
    return 0;
  };
  ::H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &reason);
  constexpr std::string_view before = "error message = '";
  if (const auto at = reason.find(before); at != std::string::npos) {
    const std::string rest = reason.substr(at + before.size());
    return rest.substr(0, rest.find('\''));
  }
  return reason.empty() ? "HDF5 does not say why" : reason;
}

/// One data set, filled a chunk at a time.
class ColumnWriter {
 public:
  ColumnWriter(hid_t group, const SweepColumn& column) : column_(column), memory_type_(memory_type(column)) {
    const hsize_t none = 0, chunk = rows_a_chunk(), unlimited = H5S_UNLIMITED;
    const Hdf5Handle space(::H5Screate_simple(1, &none, &unlimited), ::H5Sclose);
    const Hdf5Handle properties(::H5Pcreate(H5P_DATASET_CREATE), ::H5Pclose);
    ::H5Pset_obj_track_times(properties.id(), false);
    ::H5Pset_chunk(properties.id(), 1, &chunk);
    if (column.width > 1 && column.kind != ColumnKind::text) ::H5Pset_shuffle(properties.id());
    ::H5Pset_deflate(properties.id(), 4);
    data_ = Hdf5Handle(::H5Dcreate2(group, column.name.c_str(), file_type(column).id(), space.id(), H5P_DEFAULT,
                                    properties.id(), H5P_DEFAULT),
                       ::H5Dclose);
  }

  [[nodiscard]] hid_t id() const { return data_.id(); }

  [[nodiscard]] bool add(std::string_view bytes) {
    const std::size_t chunk = rows_a_chunk() * column_.width;
    while (!bytes.empty()) {
      const std::size_t taken = std::min(chunk - held_.size(), bytes.size());
      held_ += bytes.substr(0, taken);
      bytes.remove_prefix(taken);
      if (held_.size() == chunk && !flush()) return false;
    }
    return true;
  }

  [[nodiscard]] bool finish() { return flush() && data_.reset(); }

 private:
  [[nodiscard]] hsize_t rows_a_chunk() const { return chunk_bytes / column_.width; }

  [[nodiscard]] bool flush() {
    const hsize_t count = held_.size() / column_.width, end = written_ + count;
    if (count == 0) return true;
    if (::H5Dset_extent(data_.id(), &end) < 0) return false;
    const Hdf5Handle file_space(::H5Dget_space(data_.id()), ::H5Sclose);
    const Hdf5Handle memory_space(::H5Screate_simple(1, &count, nullptr), ::H5Sclose);
    ::H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, &written_, nullptr, &count, nullptr);
    const bool done =
        ::H5Dwrite(data_.id(), memory_type_.id(), memory_space.id(), file_space.id(), H5P_DEFAULT, held_.data()) >= 0;
    written_ = end;
    held_.clear();
    return done;
  }

  const SweepColumn& column_;
  Hdf5Handle memory_type_, data_;
  std::string held_;
  hsize_t written_ = 0;
};

bool put_attribute(hid_t object, const char* name, const std::string& text) {
  const Hdf5Handle type = text_type(H5T_VARIABLE);
  const Hdf5Handle space(::H5Screate(H5S_SCALAR), ::H5Sclose);
  const Hdf5Handle attribute(::H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), ::H5Aclose);
  const char* const bytes = text.c_str();
  return attribute && ::H5Awrite(attribute.id(), type.id(), &bytes) >= 0;
}

bool put_attribute(hid_t object, const char* name, std::int64_t number) {
  const Hdf5Handle space(::H5Screate(H5S_SCALAR), ::H5Sclose);
  const Hdf5Handle attribute(::H5Acreate2(object, name, H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                             ::H5Aclose);
  return attribute && ::H5Awrite(attribute.id(), H5T_NATIVE_INT64, &number) >= 0;
}

Hdf5Handle create_file(const std::filesystem::path& path) {
  const Hdf5Handle creation(::H5Pcreate(H5P_FILE_CREATE), ::H5Pclose);
  const Hdf5Handle access(::H5Pcreate(H5P_FILE_ACCESS), ::H5Pclose);
  ::H5Pset_obj_track_times(creation.id(), false);
  ::H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  ::H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  return {::H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.id(), access.id()), ::H5Fclose};
}

Hdf5Handle create_group(hid_t file, std::string_view name) {
  const Hdf5Handle properties(::H5Pcreate(H5P_GROUP_CREATE), ::H5Pclose);
  ::H5Pset_obj_track_times(properties.id(), false);
  ::H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return {::H5Gcreate2(file, std::string(name).c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), ::H5Gclose};
}

/// The file being written. After the first failure, which keeps its reason, it does nothing.
class TableWriter {
 public:
  TableWriter(const std::filesystem::path& path, const SweepPlan& plan) : plan_(plan) {
    file_ = create_file(path);
    keep(static_cast<bool>(file_) && put_head());
    for (std::size_t t = 0; t < sweep_table_names.size() && !failed(); ++t) open_table(t);
  }

  [[nodiscard]] bool failed() const { return reason_.has_value(); }
  /// Of the first failure.
  [[nodiscard]] const std::optional<std::string>& reason() const { return reason_; }

  void add(const SweepRows& rows) {
    for (std::size_t t = 0; t < sweep_table_names.size() && !failed(); ++t) {
      const TableRows& table = rows.of(static_cast<SweepTable>(t));
      for (std::size_t k = 0; k < table.columns() && !failed(); ++k) keep(columns_[t][k]->add(table.bytes(k)));
    }
  }

  void finish() {
    for (auto& table : columns_)
      for (auto& column : table) keep(failed() || column->finish());
    for (auto& table : columns_) table.clear();
    groups_.clear();
    const bool closed = file_.reset();
    keep(closed);
  }

 private:
  void keep(bool done) {
    if (!done && !failed()) reason_ = hdf5_reason();
  }

  [[nodiscard]] bool put_head() {
    const hid_t root = file_.id();
    return put_attribute(root, "linkwright_sweep", std::int64_t{sweep_file_version}) &&
           put_attribute(root, "version", std::string(LINKWRIGHT_VERSION)) &&
           put_attribute(root, "title", plan_.title()) &&
           put_attribute(root, "sampling", std::string(name(plan_.sampling()))) &&
           put_attribute(root, "seed", static_cast<std::int64_t>(plan_.seed())) &&
           put_attribute(root, "samples", plan_.samples()) && put_attribute(root, "problem", plan_.base_text()) &&
           put_attribute(root, "sweep", plan_.sweep_text());
  }

  void open_table(std::size_t table) {
    groups_.push_back(create_group(file_.id(), sweep_table_names[table]));
    for (const SweepColumn& column : plan_.columns()[table]) {
      columns_[table].push_back(std::make_unique<ColumnWriter>(groups_.back().id(), column));
      const hid_t data = columns_[table].back()->id();
      keep(data >= 0 && put_attribute(data, "unit", column.unit) &&
           put_attribute(data, "description", column.description));
    }
  }

  const SweepPlan& plan_;
  Hdf5Handle file_;
  std::vector<Hdf5Handle> groups_;
  std::array<std::vector<std::unique_ptr<ColumnWriter>>, sweep_table_names.size()> columns_;
  std::optional<std::string> reason_;
};

Error cannot_write(const std::filesystem::path& path, const std::string& reason) {
  return {"unwritable_output",
          "",
          fmt::format("{} cannot be written: {}; what is done is kept", path.string(), reason),
          {{"what", path.string()}, {"reason", reason}}};
}

/// On the disk, or the system's reason.
std::optional<std::string> sync(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  const int why = errno;
  if (descriptor >= 0) ::close(descriptor);
  return synced ? std::nullopt : std::optional<std::string>(std::strerror(why));
}

/// This very table stands there already: a run was stopped before it had tidied up.
bool is_table_of(const std::filesystem::path& path, const SweepPlan& plan) {
  const ChildEnd end = in_child(std::chrono::minutes(1), [&] {
    const auto head = read_sweep_head(path);
    return head && is_head_of(*head, plan) ? 0 : 1;
  });
  return end.status == 0;
}

/// Takes the name of the output where nothing has it; 0, or the system's number for why not.
int take_free_name(const std::filesystem::path& made, const std::filesystem::path& output) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, output.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;  // not every file system can
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(output, error))) return EEXIST;
  return ::rename(made.c_str(), output.c_str()) == 0 ? 0 : errno;
}

/// All on the disk, and under its name. What came to stand there since the sweep was begun is left alone.
std::optional<Error> settle(const std::filesystem::path& made, const std::filesystem::path& output,
                            const SweepPlan& plan, const SweepFolder& folder) {
  if (const auto reason = sync(made)) return cannot_write(output, *reason);
  std::error_code error;
  const bool replaces =
      folder.replaces_output() || (std::filesystem::exists(output, error) && is_table_of(output, plan));
  const int failed = !replaces ? take_free_name(made, output) : ::rename(made.c_str(), output.c_str()) == 0 ? 0 : errno;
  if (failed == EEXIST)
    return Error{"output_exists", "",
                 "another file came to be there meanwhile; what is done is kept: move that file away, then --resume"};
  if (failed != 0) return cannot_write(output, std::strerror(failed));
  (void)sync(std::filesystem::absolute(output).parent_path());  // the name as well, where folders can be synced
  return std::nullopt;
}

std::optional<Error> merge(const std::filesystem::path& made, const SweepPlan& plan, const JournalScan& scan) {
  TableWriter table(made, plan);
  StoredBlocks stored(scan);
  SweepRows rows(plan.columns());
  std::optional<Error> failure;
  for (const StoredBlock& block : scan.blocks) {
    const auto bytes = stored.read(block);
    if (!bytes)
      failure = bytes.errors().front();
    else if (!rows.from_bytes(*bytes, plan.columns()))
      failure = missing_block(block.block);
    if (failure || table.failed()) break;
    table.add(rows);
  }
  table.finish();
  const std::optional<std::string>& reason = table.reason();
  if (!failure && reason) failure = cannot_write(made, *reason);
  return failure;
}

}  // namespace

std::optional<Error> missing_sweep_files() { return std::nullopt; }

std::optional<Error> write_sweep_file(const std::filesystem::path& output, const SweepPlan& plan, SweepFolder& folder) {
  quiet_hdf5();
  const auto scan = folder.scan(plan);
  if (!scan) return scan.errors().front();
  for (std::int64_t k = 0; k < plan.blocks(); ++k)
    if (k >= static_cast<std::int64_t>(scan->blocks.size()) || scan->blocks[static_cast<std::size_t>(k)].block != k)
      return missing_block(k);
  const std::filesystem::path made = folder.path() / "sweep.merged.h5";
  std::error_code error;
  std::filesystem::remove(made, error);  // of a run that was killed
  auto failure = merge(made, plan, *scan);
  if (!failure) failure = settle(made, output, plan, folder);
  if (failure)
    std::filesystem::remove(made, error);
  else
    folder.remove();
  return failure;
}

}  // namespace linkwright
