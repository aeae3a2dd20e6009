#include "machine/zip_archive.hpp"

#include <array>

namespace linkwright {
namespace {

constexpr std::uint32_t midnight_of_1980 = 0x00210000;  // day 1 of month 1; ZIP knows none before

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t k = 0; k < 256; ++k) {
    table[k] = k;
    for (int bit = 0; bit < 8; ++bit) table[k] = (table[k] >> 1) ^ ((table[k] & 1) != 0 ? 0xEDB88320u : 0u);
  }
  return table;
}();

void put(std::string& bytes, std::uint32_t value, int count) {
  for (int k = 0; k < count; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xFF);
}

/// What the header before a file and its entry in the directory have in common.
void put_entry(std::string& bytes, const ArchivedFile& file) {
  const auto size = static_cast<std::uint32_t>(file.text.size());
  put(bytes, 20, 2);      // version needed: 2.0
  put(bytes, 0x0800, 2);  // names are UTF-8
  put(bytes, 0, 2);       // stored
  put(bytes, midnight_of_1980, 4);
  put(bytes, crc32_of(file.text), 4);
  put(bytes, size, 4);
  put(bytes, size, 4);
  put(bytes, static_cast<std::uint32_t>(file.name.size()), 2);
  put(bytes, 0, 2);  // no extra field
}

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes) crc = (crc >> 8) ^ crc_table[(crc ^ static_cast<unsigned char>(byte)) & 0xFF];
  return ~crc;
}

std::string zip_archive(const std::vector<ArchivedFile>& files) {
  std::string bytes, directory;
  for (const ArchivedFile& file : files) {
    const auto at = static_cast<std::uint32_t>(bytes.size());
    put(bytes, 0x04034B50, 4);
    put_entry(bytes, file);
    bytes += file.name + file.text;
    put(directory, 0x02014B50, 4);
    put(directory, 20, 2);  // made by version 2.0
    put_entry(directory, file);
    put(directory, 0, 2);  // no comment
    put(directory, 0, 4);  // first disk, no attributes
    put(directory, 0, 4);
    put(directory, at, 4);
    directory += file.name;
  }
  const auto start = static_cast<std::uint32_t>(bytes.size()), count = static_cast<std::uint32_t>(files.size());
  bytes += directory;
  put(bytes, 0x06054B50, 4);
  put(bytes, 0, 4);  // one disk
  put(bytes, count, 2);
  put(bytes, count, 2);
  put(bytes, static_cast<std::uint32_t>(directory.size()), 4);
  put(bytes, start, 4);
  put(bytes, 0, 2);  // no comment
  return bytes;
}

}  // namespace linkwright
