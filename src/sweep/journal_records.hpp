#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "linkwright/sweep/block_journal.hpp"

// A journal on the disk: a header, then records one after another, each a header with checksums of itself and of the
// rows that follow it. All headers have the checksum of the plan, so that every record tells for itself whose it is.
// Numbers as this machine has them.
namespace linkwright {

struct JournalHeader {
  char magic[20];
  std::uint32_t plan_check;
};
static_assert(sizeof(JournalHeader) == 24);

struct RecordHeader {
  std::uint32_t magic, plan_check;
  std::int64_t block;
  std::uint64_t size;
  std::uint32_t rows_check, header_check;
};
static_assert(sizeof(RecordHeader) == 32);

/// Of a plan's texts and this version.
[[nodiscard]] std::uint32_t plan_check(const SweepPlan& plan);
[[nodiscard]] JournalHeader journal_header(std::uint32_t plan_check);
[[nodiscard]] RecordHeader record_header(std::uint32_t plan_check, std::int64_t block, std::string_view rows);
/// The bytes are those that were written.
[[nodiscard]] bool is_whole(const RecordHeader& header);
[[nodiscard]] std::uint32_t checksum(std::string_view bytes);

/// A descriptor that closes itself.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// A journal that is read. Once the system has failed to read, nothing more is: what came of it says nothing of the
/// file.
class JournalFile {
 public:
  /// `descriptor` stays its owner's.
  explicit JournalFile(int descriptor);

  /// The system's number of the first failure; 0: none.
  [[nodiscard]] int failed() const { return failed_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// As many bytes as there are, at most `count`; fewer at the end of the file or where reading fails.
  [[nodiscard]] std::string read(std::uint64_t offset, std::uint64_t count);

 private:
  int descriptor_, failed_ = 0;
  std::uint64_t size_ = 0;
};

/// Of which plan a journal is, by its header or, where that has changed, by a record.
enum class JournalOwner { nobody, plan, another };
struct JournalState {
  JournalOwner owner = JournalOwner::nobody;  ///< nobody: not even its header was written
  std::uint64_t untorn_size = 0;              ///< bytes without a last record that was not written whole
};
/// Where reading fails the file has failed(), and its state is not known.
[[nodiscard]] JournalState journal_state(JournalFile& file, const SweepPlan& plan);

/// 000000.journal of process 0; so are all named that a sweep writes.
[[nodiscard]] std::string journal_name(int process);
[[nodiscard]] bool is_journal(const std::filesystem::path& path);

/// "…: <the system's reason>".
[[nodiscard]] Error unreadable_journal(const std::filesystem::path& path, int error_number);
[[nodiscard]] Error unwritable(std::string_view what, const std::filesystem::path& path, int error_number);
[[nodiscard]] Error sweep_in_use();

}  // namespace linkwright
