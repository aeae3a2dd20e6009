#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace linkwright {

struct ArchivedFile {
  std::string name, text;
};

/// A ZIP archive that stores files as they are, without compression and without time of day. (PKWARE, APPNOTE 6.3.)
/// Names and sizes below 65,536 and 4 GiB.
[[nodiscard]] std::string zip_archive(const std::vector<ArchivedFile>& files);

/// The checksum of ZIP and PNG files. (ISO 3309.)
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes);

}  // namespace linkwright
