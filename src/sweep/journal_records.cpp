#include "journal_records.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

namespace linkwright {
namespace {

constexpr std::uint32_t record_magic = 0x4b42574c;  // LWBK

template <class Header>
std::string_view bytes_of(const Header& header, std::size_t count) {
  return {reinterpret_cast<const char*>(&header), count};
}

}  // namespace

std::uint32_t checksum(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(::crc32_z(::crc32_z(0, nullptr, 0), data, bytes.size()));
}

std::uint32_t plan_check(const SweepPlan& plan) {
  return checksum(plan.base_text() + "\n" + plan.sweep_text() + "\n" LINKWRIGHT_VERSION);
}

JournalHeader journal_header(std::uint32_t plan_check) { return {"linkwright sweep 2\n", plan_check}; }

RecordHeader record_header(std::uint32_t plan_check, std::int64_t block, std::string_view rows) {
  RecordHeader header{record_magic, plan_check, block, rows.size(), checksum(rows), 0};
  header.header_check = checksum(bytes_of(header, offsetof(RecordHeader, header_check)));
  return header;
}

bool is_whole(const RecordHeader& header) {
  return header.magic == record_magic &&
         header.header_check == checksum(bytes_of(header, offsetof(RecordHeader, header_check)));
}

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

JournalFile::JournalFile(int descriptor) : descriptor_(descriptor) {
  struct stat about {};
  if (::fstat(descriptor, &about) != 0)
    failed_ = errno;
  else if (!S_ISREG(about.st_mode))
    failed_ = EINVAL;
  else
    size_ = static_cast<std::uint64_t>(about.st_size);
}

std::string JournalFile::read(std::uint64_t offset, std::uint64_t count) {
  std::string bytes(count, '\0');
  std::size_t have = 0;
  while (have < bytes.size() && failed_ == 0) {
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + have, bytes.size() - have, static_cast<off_t>(offset + have));
    if (got == 0) break;
    if (got > 0)
      have += static_cast<std::size_t>(got);
    else if (errno != EINTR)
      failed_ = errno;
  }
  bytes.resize(failed_ == 0 ? have : 0);
  return bytes;
}

std::string journal_name(int process) { return fmt::format("{:06}.journal", process); }

bool is_journal(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return digits >= 6 && name.substr(digits) == ".journal";
}

Error unreadable_journal(const std::filesystem::path& path, int error_number) {
  const char* const reason = std::strerror(error_number);
  return {"unreadable_journal", "", path.string() + " cannot be read: " + reason, {{"reason", reason}}};
}

Error unwritable(std::string_view what, const std::filesystem::path& path, int error_number) {
  const char* const reason = std::strerror(error_number);
  return {"unwritable_output",
          "",
          fmt::format("{} {}: {}", path.string(), what, reason),
          {{"what", what}, {"reason", reason}}};
}

Error sweep_in_use() { return {"sweep_in_use", "", "another run is writing this file; wait for it or stop it"}; }

}  // namespace linkwright
