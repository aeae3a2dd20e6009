#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace linkwright {

/// Base64 (RFC 4648, with padding) of bytes that come in pieces.
class Base64Encoder {
 public:
  /// Appends the text of as many whole groups of three bytes as there are; keeps the rest for later.
  void encode(std::span<const std::uint8_t> bytes, std::string& text);
  /// Appends the last group, padded.
  void finish(std::string& text);

 private:
  void put_group(std::uint32_t bits, std::string& text) const;

  std::uint32_t pending_ = 0;
  int pending_bytes_ = 0;
};

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace linkwright
