#include "files/json/base64.hpp"

#include <gtest/gtest.h>
#include <string_view>
#include <vector>

namespace linkwright::base64_test {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Base64, TestVectorsOfRfc4648) {
  EXPECT_EQ(base64(bytes_of("")), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes_of("foob")), "Zm9vYg==");
  EXPECT_EQ(base64(bytes_of("fooba")), "Zm9vYmE=");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
}

TEST(Base64, PiecesMakeTheSameTextAsTheWhole) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 1000; ++i) bytes.push_back(static_cast<std::uint8_t>(i * 37));
  for (std::size_t piece : {1u, 2u, 3u, 7u, 999u}) {
    Base64Encoder encoder;
    std::string text;
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
      encoder.encode(std::span(bytes).subspan(begin, std::min(piece, bytes.size() - begin)), text);
    }
    encoder.finish(text);
    EXPECT_EQ(text, base64(bytes)) << piece;
  }
}

}  // namespace
}  // namespace linkwright::base64_test
