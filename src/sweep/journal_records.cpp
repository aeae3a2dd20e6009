#include "journal_records.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
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

std::string read_at(int descriptor, std::uint64_t offset, std::uint64_t count) {
  std::string bytes(count, '\0');
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got =
        ::pread(descriptor, bytes.data() + have, bytes.size() - have, static_cast<off_t>(offset + have));
    if (got > 0)
      have += static_cast<std::size_t>(got);
    else if (got == 0 || errno != EINTR)
      break;
  }
  bytes.resize(have);
  return bytes;
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
