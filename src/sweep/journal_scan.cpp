#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include "journal_records.hpp"

namespace linkwright {
namespace {

/// Goes through one journal.
class JournalReader {
 public:
  JournalReader(int descriptor, std::uint64_t size, std::int64_t blocks)
      : descriptor_(descriptor), size_(size), blocks_(blocks) {}

  void read(std::uint32_t journal, JournalScan& scan) const {
    for (std::uint64_t at = sizeof(JournalHeader); at < size_;) {
      const Piece piece = piece_at(at);
      if (piece.kind == Piece::torn)
        ++scan.torn;
      else if (piece.kind == Piece::record && is_sound(at))
        scan.blocks.push_back({piece.block, journal, at});
      else
        ++scan.corrupt;
      at = piece.end;
    }
  }

  [[nodiscard]] std::uint64_t untorn_size() const {
    for (std::uint64_t at = sizeof(JournalHeader); at < size_;) {
      const Piece piece = piece_at(at);
      if (piece.kind == Piece::torn) return at;
      at = piece.end;
    }
    return size_;
  }

 private:
  /// Bytes from a place to `end`: a record, by its header, or what is none; torn where nothing follows that is whole.
  struct Piece {
    enum { record, corrupt, torn } kind;
    std::int64_t block;
    std::uint64_t end;
  };

  [[nodiscard]] Piece piece_at(std::uint64_t at) const {
    if (const auto header = header_at(at)) {
      const std::uint64_t rows_at = at + sizeof(RecordHeader);
      if (header->size > size_ - rows_at) return {Piece::torn, header->block, size_};
      return {Piece::record, header->block, rows_at + header->size};
    }
    const std::uint64_t next = next_header(at + 1);
    return {next < size_ ? Piece::corrupt : Piece::torn, 0, next};
  }

  [[nodiscard]] bool is_sound(std::uint64_t at) const {
    const auto header = header_at(at);
    if (!header) return false;
    const std::string rows = read_at(descriptor_, at + sizeof(RecordHeader), header->size);
    return rows.size() == header->size && checksum(rows) == header->rows_check;
  }

  [[nodiscard]] std::optional<RecordHeader> header_at(std::uint64_t at) const {
    const std::string bytes = read_at(descriptor_, at, sizeof(RecordHeader));
    if (bytes.size() < sizeof(RecordHeader)) return std::nullopt;
    RecordHeader header{};
    std::memcpy(&header, bytes.data(), sizeof header);
    return is_whole(header, blocks_) ? std::optional(header) : std::nullopt;
  }

  /// Where the next whole header stands, or the end of the file.
  [[nodiscard]] std::uint64_t next_header(std::uint64_t from) const {
    constexpr std::uint64_t piece = 1 << 20;
    const RecordHeader pattern = record_header(0, "");
    const std::string_view magic(reinterpret_cast<const char*>(&pattern.magic), sizeof pattern.magic);
    for (std::uint64_t start = from; start < size_; start += piece) {
      const std::string bytes = read_at(descriptor_, start, piece + magic.size() - 1);
      for (std::size_t k = bytes.find(magic); k != std::string::npos; k = bytes.find(magic, k + 1))
        if (header_at(start + k)) return start + k;
    }
    return size_;
  }

  int descriptor_;
  std::uint64_t size_;
  std::int64_t blocks_;
};

Error unreadable(const std::filesystem::path& path, int error_number) {
  return {"unreadable_journal",
          "",
          path.string() + " cannot be read: " + std::strerror(error_number),
          {{"reason", std::strerror(error_number)}}};
}

bool is_of_plan(int descriptor, const SweepPlan& plan) {
  const JournalHeader wanted = journal_header(plan);
  const std::string bytes = read_at(descriptor, 0, sizeof wanted);
  return bytes.size() == sizeof wanted && std::memcmp(bytes.data(), &wanted, sizeof wanted) == 0;
}

/// A journal whose header was not written whole has nothing; one of another plan is corrupt.
std::optional<Error> read_journal(std::uint32_t journal, const SweepPlan& plan, JournalScan& scan) {
  const std::filesystem::path& path = scan.journals[journal];
  const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.descriptor() < 0) return unreadable(path, errno);
  const auto size = static_cast<std::uint64_t>(::lseek(file.descriptor(), 0, SEEK_END));
  if (is_of_plan(file.descriptor(), plan))
    JournalReader(file.descriptor(), size, plan.blocks()).read(journal, scan);
  else if (size > 0)
    ++(size < sizeof(JournalHeader) ? scan.torn : scan.corrupt);
  return std::nullopt;
}

}  // namespace

std::uint64_t untorn_size(int descriptor, const SweepPlan& plan) {
  if (!is_of_plan(descriptor, plan)) return 0;
  const auto size = static_cast<std::uint64_t>(::lseek(descriptor, 0, SEEK_END));
  return JournalReader(descriptor, size, plan.blocks()).untorn_size();
}

Result<JournalScan> scan_journals(const std::filesystem::path& folder, const SweepPlan& plan) {
  JournalScan scan;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".journal") scan.journals.push_back(entry.path());
  if (error) return unreadable(folder, error.value());
  std::sort(scan.journals.begin(), scan.journals.end());
  for (std::uint32_t k = 0; k < scan.journals.size(); ++k)
    if (const auto failure = read_journal(k, plan, scan)) return *failure;
  const auto by_number = [](const StoredBlock& a, const StoredBlock& b) { return a.block < b.block; };
  std::stable_sort(scan.blocks.begin(), scan.blocks.end(), by_number);
  const auto same = [](const StoredBlock& a, const StoredBlock& b) { return a.block == b.block; };
  scan.blocks.erase(std::unique(scan.blocks.begin(), scan.blocks.end(), same), scan.blocks.end());
  return scan;
}

StoredBlocks::StoredBlocks(const JournalScan& scan) {
  for (const auto& path : scan.journals) descriptors_.push_back(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
}

StoredBlocks::~StoredBlocks() {
  for (const int descriptor : descriptors_)
    if (descriptor >= 0) ::close(descriptor);
}

std::optional<std::string> StoredBlocks::read(const StoredBlock& block) const {
  const int descriptor = descriptors_[block.journal];
  const std::string bytes = read_at(descriptor, block.offset, sizeof(RecordHeader));
  if (bytes.size() < sizeof(RecordHeader)) return std::nullopt;
  RecordHeader header{};
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.block != block.block || !is_whole(header, block.block + 1)) return std::nullopt;
  std::string rows = read_at(descriptor, block.offset + sizeof(RecordHeader), header.size);
  if (rows.size() != header.size || checksum(rows) != header.rows_check) return std::nullopt;
  return rows;
}

}  // namespace linkwright
