#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "linkwright/sweep/block_journal.hpp"

// A journal on the disk: a header with the checksum of its plan, then records one after another, each a header with
// checksums of itself and of the rows that follow it. Numbers as this machine has them.
namespace linkwright {

struct JournalHeader {
  char magic[20];
  std::uint32_t plan_check;
};
static_assert(sizeof(JournalHeader) == 24);

struct RecordHeader {
  std::uint32_t magic, rows_check;
  std::int64_t block;
  std::uint64_t size;
  std::uint32_t header_check, unused;
};
static_assert(sizeof(RecordHeader) == 32);

[[nodiscard]] JournalHeader journal_header(const SweepPlan& plan);
[[nodiscard]] RecordHeader record_header(std::int64_t block, std::string_view rows);
/// A record of a block of the plan could begin with it.
[[nodiscard]] bool is_whole(const RecordHeader& header, std::int64_t blocks);
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

/// As many bytes as there are, at most `count`; shorter at the end of the file or where it cannot be read.
[[nodiscard]] std::string read_at(int descriptor, std::uint64_t offset, std::uint64_t count);

/// How much of a journal of this plan there is without a last record that was not written whole; 0: not even its
/// header.
[[nodiscard]] std::uint64_t untorn_size(int descriptor, const SweepPlan& plan);

/// "…: <the system's reason>".
[[nodiscard]] Error unwritable(std::string_view what, const std::filesystem::path& path, int error_number);
[[nodiscard]] Error sweep_in_use();

}  // namespace linkwright
