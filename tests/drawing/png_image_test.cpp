#include "drawing/png_image.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <zlib.h>

namespace linkwright::png_image_test {
namespace {

struct Chunk {
  std::string name;
  std::vector<std::uint8_t> content;
};

std::uint32_t big_endian(const std::vector<std::uint8_t>& file, std::size_t at) {
  return std::uint32_t{file[at]} << 24 | std::uint32_t{file[at + 1]} << 16 | std::uint32_t{file[at + 2]} << 8 |
         file[at + 3];
}

/// The chunks of a file, their checksums checked.
std::vector<Chunk> chunks_of(const std::vector<std::uint8_t>& file) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::size_t size = big_endian(file, at);
    chunks.push_back({std::string(file.begin() + static_cast<long>(at) + 4, file.begin() + static_cast<long>(at) + 8),
                      {file.begin() + static_cast<long>(at) + 8, file.begin() + static_cast<long>(at + 8 + size)}});
    EXPECT_EQ(big_endian(file, at + 8 + size), crc32(0, &file[at + 4], static_cast<uInt>(size + 4)));
    at += 12 + size;
  }
  return chunks;
}

TEST(PngImage, HoldsItsPixels) {
  PngImage image{3, 2, {0, 0xFF8000, 0x0000FF}, {0, 1, 2, 2, 1, 0}};
  const auto file = image.file();
  ASSERT_GT(file.size(), 8u);
  EXPECT_EQ(std::memcmp(file.data(), "\x89PNG\r\n\x1a\n", 8), 0);
  const auto chunks = chunks_of(file);
  ASSERT_EQ(chunks.size(), 5u);
  EXPECT_EQ(chunks[0].name, "IHDR");
  EXPECT_EQ(big_endian(chunks[0].content, 0), 3u);
  EXPECT_EQ(big_endian(chunks[0].content, 4), 2u);
  EXPECT_EQ(chunks[1].content, (std::vector<std::uint8_t>{0, 0, 0, 0xFF, 0x80, 0, 0, 0, 0xFF}));
  EXPECT_EQ(chunks[4].name, "IEND");
  std::vector<std::uint8_t> rows(8);
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(rows.data(), &size, chunks[3].content.data(), static_cast<uLong>(chunks[3].content.size())),
            Z_OK);
  EXPECT_EQ(rows, (std::vector<std::uint8_t>{0, 0, 1, 2, 0, 2, 1, 0}));
}

}  // namespace
}  // namespace linkwright::png_image_test
