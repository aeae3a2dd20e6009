#include "png_image.hpp"

#include <span>
#include <string_view>
#include <zlib.h>

namespace linkwright {
namespace {

using Bytes = std::vector<std::uint8_t>;

void put_big_endian(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void put_chunk(Bytes& file, std::string_view name, std::span<const std::uint8_t> content) {
  put_big_endian(file, static_cast<std::uint32_t>(content.size()));
  const std::size_t start = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), content.begin(), content.end());
  put_big_endian(file,
                 static_cast<std::uint32_t>(crc32(0, file.data() + start, static_cast<uInt>(file.size() - start))));
}

Bytes header(std::uint32_t width, std::uint32_t height) {
  Bytes bytes;
  put_big_endian(bytes, width);
  put_big_endian(bytes, height);
  constexpr std::uint8_t bits = 8, by_palette = 3, deflate = 0, filters = 0, not_interlaced = 0;
  bytes.insert(bytes.end(), {bits, by_palette, deflate, filters, not_interlaced});
  return bytes;
}

Bytes compressed(const Bytes& plain) {
  uLongf size = compressBound(static_cast<uLong>(plain.size()));
  Bytes bytes(size);
  if (compress2(bytes.data(), &size, plain.data(), static_cast<uLong>(plain.size()), Z_BEST_COMPRESSION) != Z_OK)
    return {};
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> PngImage::file() const {
  Bytes palette;
  for (const std::uint32_t color : colors) {
    for (int shift = 16; shift >= 0; shift -= 8) palette.push_back(static_cast<std::uint8_t>(color >> shift));
  }
  Bytes rows;
  rows.reserve((width + 1) * height);
  for (std::size_t row = 0; row < height; ++row) {
    constexpr std::uint8_t no_filter = 0;
    rows.push_back(no_filter);
    const auto start = pixels.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), start, start + static_cast<std::ptrdiff_t>(width));
  }
  const Bytes data = compressed(rows);
  if (data.empty()) return {};

  Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  put_chunk(bytes, "IHDR", header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)));
  put_chunk(bytes, "PLTE", palette);
  put_chunk(bytes, "tRNS", Bytes{0});
  put_chunk(bytes, "IDAT", data);
  put_chunk(bytes, "IEND", {});
  return bytes;
}

}  // namespace linkwright
