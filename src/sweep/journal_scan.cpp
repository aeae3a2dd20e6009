#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

#include "journal_records.hpp"

namespace linkwright {
namespace {

/// Goes through one journal.
class JournalReader {
 public:
  JournalReader(JournalFile& file, const SweepPlan& plan)
      : file_(file), plan_check_(plan_check(plan)), blocks_(plan.blocks()), size_(file.size()) {}

  [[nodiscard]] JournalState state() const {
    if (size_ < sizeof(JournalHeader)) return {};
    if (has_header() || size_ == sizeof(JournalHeader) || next_header(sizeof(JournalHeader)) < size_)
      return {JournalOwner::plan, untorn_size()};
    return {JournalOwner::another, size_};
  }

  void read(std::uint32_t journal, JournalScan& scan) const {
    const JournalOwner owner = state().owner;
    if (owner == JournalOwner::nobody && size_ > 0) ++scan.torn;
    if (owner == JournalOwner::another || (owner == JournalOwner::plan && !has_header())) ++scan.corrupt;
    if (owner != JournalOwner::plan) return;
    for (std::uint64_t at = sizeof(JournalHeader); at < size_ && file_.failed() == 0;) {
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

 private:
  [[nodiscard]] bool has_header() const {
    const JournalHeader wanted = journal_header(plan_check_);
    const std::string bytes = file_.read(0, sizeof wanted);
    return bytes.size() == sizeof wanted && std::memcmp(bytes.data(), &wanted, sizeof wanted) == 0;
  }

  [[nodiscard]] std::uint64_t untorn_size() const {
    for (std::uint64_t at = sizeof(JournalHeader); at < size_;) {
      const Piece piece = piece_at(at);
      if (piece.kind == Piece::torn) return at;
      at = piece.end;
    }
    return size_;
  }

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
    const std::string rows = file_.read(at + sizeof(RecordHeader), header->size);
    return rows.size() == header->size && checksum(rows) == header->rows_check;
  }

  [[nodiscard]] std::optional<RecordHeader> header_at(std::uint64_t at) const {
    const std::string bytes = file_.read(at, sizeof(RecordHeader));
    if (bytes.size() < sizeof(RecordHeader)) return std::nullopt;
    RecordHeader header{};
    std::memcpy(&header, bytes.data(), sizeof header);
    const bool is_of_plan = header.plan_check == plan_check_ && header.block >= 0 && header.block < blocks_;
    return is_of_plan && is_whole(header) ? std::optional(header) : std::nullopt;
  }

  /// Where the next whole header stands, or the end of the file.
  [[nodiscard]] std::uint64_t next_header(std::uint64_t from) const {
    constexpr std::uint64_t piece = 1 << 20;
    const RecordHeader pattern = record_header(0, 0, "");
    const std::string_view magic(reinterpret_cast<const char*>(&pattern.magic), sizeof pattern.magic);
    for (std::uint64_t start = from; start < size_ && file_.failed() == 0; start += piece) {
      const std::string bytes = file_.read(start, piece + magic.size() - 1);
      for (std::size_t k = bytes.find(magic); k != std::string::npos; k = bytes.find(magic, k + 1))
        if (header_at(start + k)) return start + k;
    }
    return size_;
  }

  JournalFile& file_;
  std::uint32_t plan_check_;
  std::int64_t blocks_;
  std::uint64_t size_;
};

std::optional<Error> read_journal(std::uint32_t journal, const SweepPlan& plan, JournalScan& scan) {
  const std::filesystem::path& path = scan.journals[journal];
  const OpenFile open_file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (open_file.descriptor() < 0) return unreadable_journal(path, errno);
  JournalFile file(open_file.descriptor());
  if (file.failed() == 0) JournalReader(file, plan).read(journal, scan);
  if (file.failed() != 0) return unreadable_journal(path, file.failed());
  return std::nullopt;
}

}  // namespace

JournalState journal_state(JournalFile& file, const SweepPlan& plan) { return JournalReader(file, plan).state(); }

Result<JournalScan> scan_journals(const std::filesystem::path& folder, const SweepPlan& plan) {
  JournalScan scan;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_journal(entry.path())) scan.journals.push_back(entry.path());
  if (error) return unreadable_journal(folder, error.value());
  std::sort(scan.journals.begin(), scan.journals.end());
  for (std::uint32_t k = 0; k < scan.journals.size(); ++k)
    if (const auto failure = read_journal(k, plan, scan)) return *failure;
  const auto by_number = [](const StoredBlock& a, const StoredBlock& b) { return a.block < b.block; };
  std::stable_sort(scan.blocks.begin(), scan.blocks.end(), by_number);
  const auto same = [](const StoredBlock& a, const StoredBlock& b) { return a.block == b.block; };
  scan.blocks.erase(std::unique(scan.blocks.begin(), scan.blocks.end(), same), scan.blocks.end());
  return scan;
}

StoredBlocks::~StoredBlocks() {
  for (const std::uint32_t journal : opened_) ::close(descriptors_[journal]);
}

int StoredBlocks::descriptor_of(std::uint32_t journal) {
  int& descriptor = descriptors_[journal];
  if (descriptor >= 0) return descriptor;
  if (opened_.size() == most_open) {
    ::close(std::exchange(descriptors_[opened_.front()], -1));
    opened_.pop_front();
  }
  descriptor = ::open(journals_[journal].c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor >= 0) opened_.push_back(journal);
  return descriptor;
}

Result<std::string> StoredBlocks::read(const StoredBlock& block) {
  const int descriptor = descriptor_of(block.journal);
  if (descriptor < 0) return unreadable_journal(journals_[block.journal], errno);
  JournalFile file(descriptor);
  const std::string bytes = file.read(block.offset, sizeof(RecordHeader));
  if (file.failed() != 0) return unreadable_journal(journals_[block.journal], file.failed());
  if (bytes.size() < sizeof(RecordHeader)) return missing_block(block.block);
  RecordHeader header{};
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.block != block.block || !is_whole(header)) return missing_block(block.block);
  std::string rows = file.read(block.offset + sizeof(RecordHeader), header.size);
  if (file.failed() != 0) return unreadable_journal(journals_[block.journal], file.failed());
  if (rows.size() != header.size || checksum(rows) != header.rows_check) return missing_block(block.block);
  return rows;
}

Error missing_block(std::int64_t block) {
  return {"missing_block",
          "",
          fmt::format("block {} is not whole in the journals; --resume computes it anew", block),
          {{"block", block}}};
}

}  // namespace linkwright
