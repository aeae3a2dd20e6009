#include "linkwright/sweep/block_journal.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/uio.h>
#include <unistd.h>
#include <utility>

#include "journal_records.hpp"

namespace linkwright {
namespace {

/// All of both, or −1 with errno.
int write_both(int descriptor, std::string_view first, std::string_view second) {
  while (!first.empty() || !second.empty()) {
    const std::array<iovec, 2> parts = {iovec{const_cast<char*>(first.data()), first.size()},
                                        iovec{const_cast<char*>(second.data()), second.size()}};
    const ssize_t written = ::writev(descriptor, parts.data(), parts.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return -1;
    const std::size_t of_first = std::min(static_cast<std::size_t>(written), first.size());
    first.remove_prefix(of_first);
    second.remove_prefix(static_cast<std::size_t>(written) - of_first);
  }
  return 0;
}

Error another_journal(const std::filesystem::path& path) {
  return {"another_journal", "",
          path.string() + " is of another sweep, or damaged from its first byte on; move it away, or --overwrite"};
}

}  // namespace

Result<BlockJournal> BlockJournal::open(const std::filesystem::path& folder, const SweepPlan& plan, int process) {
  const std::filesystem::path path = folder / journal_name(process);
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor < 0) return unwritable("cannot be written", path, errno);
  BlockJournal journal(path, descriptor, plan_check(plan));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return sweep_in_use();
  JournalFile file(descriptor);
  const JournalState state = file.failed() == 0 ? journal_state(file, plan) : JournalState{};
  if (file.failed() != 0) return unreadable_journal(path, file.failed());  // what cannot be read is not cut off
  if (state.owner == JournalOwner::another) return another_journal(path);
  const JournalHeader header = journal_header(journal.plan_check_);
  const std::string_view bytes(reinterpret_cast<const char*>(&header), sizeof header);
  if (::ftruncate(descriptor, static_cast<off_t>(state.untorn_size)) != 0 || ::lseek(descriptor, 0, SEEK_SET) != 0 ||
      write_both(descriptor, bytes, "") != 0)
    return unwritable("cannot be written", path, errno);
  journal.size_ = std::max<std::uint64_t>(state.untorn_size, sizeof header);
  return journal;
}

BlockJournal::BlockJournal(BlockJournal&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      plan_check_(other.plan_check_),
      size_(other.size_) {}

BlockJournal::~BlockJournal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<Error> BlockJournal::add(std::int64_t block, std::string_view rows) {
  const RecordHeader header = record_header(plan_check_, block, rows);
  const std::string_view bytes(reinterpret_cast<const char*>(&header), sizeof header);
  if (::lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET) >= 0 && write_both(descriptor_, bytes, rows) == 0) {
    size_ += sizeof header + rows.size();
    return std::nullopt;
  }
  const Error failure = unwritable("cannot be written", path_, errno);
  if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) return failure;  // a torn end is found when it is read
  return failure;
}

std::optional<Error> BlockJournal::sync() {
  if (::fdatasync(descriptor_) == 0 || errno == EINVAL) return std::nullopt;
  return unwritable("cannot be written", path_, errno);
}

}  // namespace linkwright
