#include "linkwright/files/text_file.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

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

using testing::Folder;
using ::testing::HasSubstr;
using testing::text_of;

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const Folder folder;
  {
    AtomicFile file(folder / "result.json");
    file.write("one ");
    file.write(std::string(3 << 20, 'x'));
    EXPECT_FALSE(std::filesystem::exists(folder / "result.json"));
    EXPECT_FALSE(file.commit());
  }
  EXPECT_EQ(text_of(folder / "result.json"), "one " + std::string(3 << 20, 'x'));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit) {
  const Folder folder;
  std::ofstream(folder / "result.json") << "old";
  { AtomicFile(folder / "result.json").write("new"); }
  EXPECT_EQ(text_of(folder / "result.json"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, ReplacesAFileAndKeepsItsPermissions) {
  const Folder folder;
  std::ofstream(folder / "result.json") << "a long old text";
  ASSERT_EQ(::chmod((folder / "result.json").c_str(), 0640), 0);
  EXPECT_FALSE(write_atomically(folder / "result.json", "new"));
  EXPECT_EQ(text_of(folder / "result.json"), "new");
  EXPECT_EQ(static_cast<unsigned>(std::filesystem::status(folder / "result.json").permissions()), 0640u);
}

TEST(AtomicFile, FollowsASymbolicLink) {
  const Folder folder;
  std::ofstream(folder / "file") << "old";
  std::filesystem::create_symlink(folder / "file", folder / "link");
  EXPECT_FALSE(write_atomically(folder / "link", "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(text_of(folder / "file"), "new");
}

TEST(AtomicFile, RefusesWhatIsNoRegularFile) {
  const Folder folder;
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_symlink(folder / "nothing", folder / "link");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::pair<std::filesystem::path, std::string> refused[] = {{folder / "folder", "a directory"},
                                                                   {folder / "link", "leads nowhere"},
                                                                   {folder / "pipe", "a pipe"},
                                                                   {"/dev/full", "a device"},
                                                                   {"/dev/null", "a device"}};
  for (const auto& [path, reason] : refused) {
    const auto failure = write_atomically(path, "text");
    ASSERT_TRUE(failure) << path;
    EXPECT_EQ(failure->code, "not_a_regular_file");
    EXPECT_THAT(failure->message, HasSubstr(reason));
  }
  EXPECT_EQ(folder.file_count(), 3u);
}

TEST(AtomicFile, TellsTheSystemsReason) {
  const auto missing = write_atomically("/no/such/folder/file", "text");
  ASSERT_TRUE(missing);
  EXPECT_THAT(missing->message, HasSubstr("No such file or directory"));
  const auto below_a_file = write_atomically("/dev/null/file", "text");
  ASSERT_TRUE(below_a_file);
  EXPECT_THAT(below_a_file->message, HasSubstr("Not a directory"));
  EXPECT_TRUE(write_atomically("", "text"));
}

}  // namespace
}  // namespace linkwright::text_file_test
