#include "base64.hpp"

#include <string_view>

namespace linkwright {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

void Base64Encoder::put_group(std::uint32_t bits, std::string& text) const {
  for (int shift = 18; shift >= 0; shift -= 6) text += alphabet[(bits >> shift) & 63];
}

void Base64Encoder::encode(std::span<const std::uint8_t> bytes, std::string& text) {
  text.reserve(text.size() + bytes.size() / 3 * 4 + 4);
  for (const std::uint8_t byte : bytes) {
    pending_ = pending_ << 8 | byte;
    if (++pending_bytes_ == 3) {
      put_group(pending_, text);
      pending_ = 0;
      pending_bytes_ = 0;
    }
  }
}

void Base64Encoder::finish(std::string& text) {
  if (pending_bytes_ == 0) return;
  const int missing = 3 - pending_bytes_;
  put_group(pending_ << 8 * missing, text);
  text.replace(text.size() - static_cast<std::size_t>(missing), std::string::npos, static_cast<std::size_t>(missing),
               '=');
  pending_ = 0;
  pending_bytes_ = 0;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  Base64Encoder encoder;
  encoder.encode(bytes, text);
  encoder.finish(text);
  return text;
}

}  // namespace linkwright
