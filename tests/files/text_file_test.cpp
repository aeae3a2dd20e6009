#include "linkwright/files/text_file.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/file_support.hpp"

namespace linkwright::text_file_test {
namespace {

using ::testing::HasSubstr;

TEST(TextFile, IsReadWhole) {
  const testing::Folder folder;
  const std::string text = std::string(200'000, 'x') + '\0' + "end";
  std::ofstream(folder / "file", std::ios::binary) << text;
  const auto read = read_text_file(folder / "file", 1 << 20);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, text);
}

TEST(TextFile, OfExactlyTheMostBytesIsRead) {
  const testing::Folder folder;
  std::ofstream(folder / "file") << std::string(1000, 'x');
  EXPECT_TRUE(read_text_file(folder / "file", 1000).ok());
  EXPECT_FALSE(read_text_file(folder / "file", 999).ok());
}

TEST(TextFile, ThatIsMissingIsRefusedWithTheSystemsReason) {
  const auto read = read_text_file("/no/such/file.json", 100);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.errors()[0].code, "unreadable_file");
  EXPECT_THAT(read.errors()[0].message, HasSubstr("No such file"));
}

TEST(TextFile, ThatIsADirectoryIsRefused) {
  const testing::Folder folder;
  const auto read = read_text_file(folder.path(), 100);
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.errors()[0].message, HasSubstr("directory"));
}

TEST(TextFile, WithoutEndIsReadNoFurtherThanAllowed) {
  const auto read = read_text_file("/dev/zero", 1 << 20);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.errors()[0].code, "file_too_large");
}

}  // namespace
}  // namespace linkwright::text_file_test
