#include "linkwright/sweep/block_journal.hpp"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "sweep/journal_records.hpp"
#include "sweep_support.hpp"

namespace linkwright {
namespace block_journal_test {
namespace {

using sweep_support::ScratchFolder;
using sweep_support::small_plan;
namespace fs = std::filesystem;

std::string rows_of(std::int64_t block) { return "rows of " + std::to_string(block) + std::string(100, 'x'); }

/// A folder with blocks 0 to 9 in its journal.
class BlockJournals : public testing::Test {
 protected:
  BlockJournals() {
    auto folder = SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::fresh);
    EXPECT_TRUE(folder.ok());
    journal = folder->path() / "000000.journal";
    auto open = BlockJournal::open(folder->path(), plan, 0);
    for (std::int64_t block = 0; block < 10; ++block) EXPECT_FALSE(open->add(block, rows_of(block)));
    EXPECT_FALSE(open->sync());
  }
  JournalScan scan() { return *scan_journals(journal.parent_path(), plan); }
  void change_byte(std::uint64_t at) {
    std::fstream file(journal, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const int byte = file.get();
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(byte ^ 0x40));
  }

  ScratchFolder scratch;
  SweepPlan plan = small_plan();
  fs::path journal;
};

TEST_F(BlockJournals, GiveBackWhatTheyKeep) {
  const JournalScan found = scan();
  ASSERT_EQ(found.blocks.size(), 10u);
  StoredBlocks stored(found);
  for (const StoredBlock& block : found.blocks) EXPECT_EQ(*stored.read(block), rows_of(block.block));
  EXPECT_EQ(found.torn + found.corrupt, 0);
}

// Wherever a killed program stopped writing, what is before is there.
TEST_F(BlockJournals, LoseOnlyTheBlockThatIsTorn) {
  const auto size = fs::file_size(journal);
  const std::uint64_t record = (size - 24) / 10;
  for (std::uint64_t keep = size - 1; keep > size - record; --keep) {
    fs::resize_file(journal, keep);
    const JournalScan found = scan();
    EXPECT_EQ(found.blocks.size(), 9u) << keep;
    EXPECT_EQ(found.torn, 1) << keep;
    EXPECT_EQ(found.corrupt, 0) << keep;
  }
}

// A run that goes on does not bury what was torn: it would be taken for corrupt, and the record after it with it.
TEST_F(BlockJournals, GoOnWithoutWhatIsTorn) {
  const auto size = fs::file_size(journal);
  const std::uint64_t record = (size - 24) / 10;
  for (const std::uint64_t lost : {std::uint64_t{1}, record - 33, record - 32, record - 1}) {
    fs::resize_file(journal, size - lost);
    auto open = BlockJournal::open(journal.parent_path(), plan, 0);
    EXPECT_EQ(fs::file_size(journal), size - record) << lost;
    EXPECT_FALSE(open->add(9, rows_of(9)));
    const JournalScan mended = scan();
    ASSERT_EQ(mended.blocks.size(), 10u) << lost;
    EXPECT_EQ(mended.torn + mended.corrupt, 0) << lost;
    EXPECT_EQ(*StoredBlocks(mended).read(mended.blocks[9]), rows_of(9));
  }
}

// Corrupt in the middle, whole at its end: what stands behind stays.
TEST_F(BlockJournals, GoOnBehindWhatIsCorrupt) {
  const auto size = fs::file_size(journal);
  change_byte(24 + (size - 24) / 10 * 4 + 8);
  EXPECT_FALSE(BlockJournal::open(journal.parent_path(), plan, 0)->add(4, rows_of(4)));
  const JournalScan found = scan();
  EXPECT_EQ(found.blocks.size(), 10u);
  EXPECT_EQ(found.corrupt, 1);
}

TEST_F(BlockJournals, LoseOnlyTheBlockThatIsCorrupt) {
  const auto size = fs::file_size(journal);
  const std::uint64_t record = (size - 24) / 10;
  for (const std::uint64_t at : {0u, 5u, 8u, 16u, 24u, 40u, 100u}) {
    change_byte(24 + 4 * record + at);
    const JournalScan found = scan();
    EXPECT_EQ(found.blocks.size(), 9u) << at;
    EXPECT_EQ(found.corrupt, 1) << at;
    change_byte(24 + 4 * record + at);
  }
  EXPECT_EQ(scan().blocks.size(), 10u);
}

TEST_F(BlockJournals, OfManyProcessesAreOne) {
  EXPECT_FALSE(BlockJournal::open(journal.parent_path(), plan, 3)->add(30, rows_of(30)));
  EXPECT_FALSE(BlockJournal::open(journal.parent_path(), plan, 3)->add(5, rows_of(5)));
  const JournalScan found = scan();
  EXPECT_EQ(found.journals.size(), 2u);
  EXPECT_EQ(found.blocks.size(), 11u);
  EXPECT_EQ(found.blocks.back().block, 30);
}

// Each record tells whose it is.
TEST_F(BlockJournals, LoseNothingByTheirFirstBytes) {
  for (std::uint64_t at = 0; at < 24; ++at) {
    change_byte(at);
    EXPECT_EQ(scan().blocks.size(), 10u) << at;
    EXPECT_EQ(scan().corrupt, 1) << at;
    EXPECT_TRUE(BlockJournal::open(journal.parent_path(), plan, 0).ok()) << at;
    EXPECT_EQ(scan().corrupt, 0) << at;
  }
  EXPECT_EQ(scan().blocks.size(), 10u);
}

TEST_F(BlockJournals, OfAnotherPlanAreNeitherTakenNorTouched) {
  const auto size = fs::file_size(journal);
  const auto other = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "random", "samples": 41})", R"([{"at": "/requirements/max_length", "from": 1, "to": 2}])"));
  const JournalScan found = *scan_journals(journal.parent_path(), other);
  EXPECT_TRUE(found.blocks.empty());
  EXPECT_EQ(found.corrupt, 1);
  const auto refused = BlockJournal::open(journal.parent_path(), other, 0);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors()[0].code, "another_journal");
  EXPECT_EQ(fs::file_size(journal), size);
}

// What the system does not read for a moment must not be taken for the end of the file, and cut off.
TEST_F(BlockJournals, ThatCannotBeReadAreTold) {
  const int unreadable = ::open(journal.c_str(), O_WRONLY);
  JournalFile file(unreadable);
  EXPECT_GT(file.size(), 0u);
  (void)journal_state(file, plan);
  EXPECT_EQ(file.failed(), EBADF);
  ::close(unreadable);
}

TEST_F(BlockJournals, AreFilesAndNothingElse) {
  const fs::path folder = journal.parent_path();
  fs::create_directory(folder / "000001.journal");
  ASSERT_EQ(::mkfifo((folder / "000002.journal").c_str(), 0666), 0);
  fs::create_symlink(journal, folder / "000003.journal");
  for (const int process : {1, 2, 3}) EXPECT_FALSE(BlockJournal::open(folder, plan, process).ok()) << process;
  for (const char* name : {"000001.journal", "000002.journal"}) {
    const auto refused = scan_journals(folder, plan);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.errors()[0].code, "unreadable_journal");
    fs::remove(folder / name);
  }
  EXPECT_EQ(scan().blocks.size(), 10u);
}

TEST_F(BlockJournals, OutliveTheirPlan) {
  const fs::path output = scratch.path() / "out.h5";
  fs::remove(journal.parent_path() / "sweep.json");
  const auto other = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "random", "samples": 41})", R"([{"at": "/requirements/max_length", "from": 1, "to": 2}])"));
  EXPECT_EQ(SweepFolder::open(output, plan, SweepStart::fresh).errors()[0].code, "journals_without_plan");
  EXPECT_EQ(SweepFolder::open(output, other, SweepStart::resume).errors()[0].code, "journals_without_plan");
  ASSERT_TRUE(SweepFolder::open(output, plan, SweepStart::resume).ok());
  EXPECT_EQ(scan().blocks.size(), 10u);
  EXPECT_TRUE(SweepFolder::is_begun(output));
}

TEST_F(BlockJournals, LeaveOtherFilesAlone) {
  const fs::path output = scratch.path() / "out.h5", folder = journal.parent_path();
  const std::vector<std::string> others = {"diary.journal", "12.journal", "lock", "merged.h5", ".notes.tmp"};
  for (const std::string& name : others) std::ofstream(folder / name) << name;
  std::ofstream(folder / ".sweep.json.17-0.tmp") << "half";
  {
    auto begun = SweepFolder::open(output, plan, SweepStart::overwrite);
    ASSERT_TRUE(begun.ok());
    EXPECT_FALSE(fs::exists(journal));
    begun->remove();
  }
  EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())),
            others.size());
}

TEST_F(BlockJournals, OfACompleteTableAreTidiedUp) {
  const fs::path output = scratch.path() / "out.h5";
  SweepFolder::tidy_up(output);
  EXPECT_TRUE(fs::exists(journal));  // its sweep is begun
  fs::remove(journal.parent_path() / "sweep.json");
  SweepFolder::tidy_up(output);
  EXPECT_FALSE(fs::exists(journal.parent_path()));
}

// A run that ends takes the lock's name away from those that have just opened it.
TEST(SweepFolders, AreOneRunsAtATimeWhenRunsBeginAndEnd) {
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  std::atomic<int> inside = 0, most = 0, runs = 0;
  const auto begin_and_end = [&] {
    for (int round = 0; round < 100; ++round) {
      auto folder = SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::overwrite);
      if (!folder) continue;
      ++runs;
      if (++inside > most) most = inside.load();
      std::this_thread::yield();
      --inside;
      folder->remove();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) threads.emplace_back(begin_and_end);
  }
  EXPECT_EQ(most, 1);
  EXPECT_GT(runs, 0);
}

TEST_F(BlockJournals, CanBeMoreThanAProcessMayOpen) {
  constexpr int processes = StoredBlocks::most_open + 40;
  for (int process = 1; process < processes; ++process)
    EXPECT_FALSE(BlockJournal::open(journal.parent_path(), plan, process)->add(process % 30 + 10, rows_of(process)));
  const JournalScan found = scan();
  StoredBlocks stored(found);
  for (int round = 0; round < 2; ++round)
    for (std::uint32_t k = 0; k < found.journals.size(); ++k)
      EXPECT_EQ(*stored.read({k == 0 ? 0 : k % 30 + 10, k, 24}), rows_of(k));
  EXPECT_LE(std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()),
            static_cast<std::ptrdiff_t>(StoredBlocks::most_open) + 40);
}

TEST_F(BlockJournals, AreOneRunsAtATime) {
  const fs::path output = scratch.path() / "out.h5";
  EXPECT_EQ(SweepFolder::open(output, plan, SweepStart::fresh).errors()[0].code, "sweep_begun");
  const auto first = SweepFolder::open(output, plan, SweepStart::resume);
  ASSERT_TRUE(first.ok());
  for (const auto start : {SweepStart::fresh, SweepStart::resume, SweepStart::overwrite})
    EXPECT_EQ(SweepFolder::open(output, plan, start).errors()[0].code, "sweep_in_use");
}

TEST_F(BlockJournals, AreResumedByTheSameSweepOnly) {
  const fs::path output = scratch.path() / "out.h5";
  const auto other = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "random", "samples": 41})", R"([{"at": "/requirements/max_length", "from": 1, "to": 2}])"));
  const auto refused = SweepFolder::open(output, other, SweepStart::resume);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.errors()[0].message.find("/sweep/"), std::string::npos) << refused.errors()[0].message;
  ASSERT_TRUE(SweepFolder::open(output, other, SweepStart::overwrite).ok());
  EXPECT_FALSE(fs::exists(journal));
}

// Equal as numbers, not as what the journals are checked by: taken for another plan's they would be emptied.
TEST_F(BlockJournals, AreKeptFromASweepThatIsWrittenOtherwise) {
  const auto size = fs::file_size(journal);
  std::string text = plan.sweep_text();
  const auto from = text.find("\"from\":");
  ASSERT_NE(from, std::string::npos);
  const auto end = text.find_first_of(",}", from);
  ASSERT_EQ(text.substr(from, end - from).find('.'), std::string::npos);
  text.insert(end, ".0");
  text.insert(text.size() - 1, ",\"problem\":" + plan.base_text());
  const auto other = SweepPlan::read(text, {});
  ASSERT_TRUE(other.ok());
  const auto refused = SweepFolder::open(scratch.path() / "out.h5", *other, SweepStart::resume);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors()[0].code, "another_sweep");
  EXPECT_EQ(fs::file_size(journal), size);
}

TEST_F(BlockJournals, SayWhatTheyWereBegunWith) {
  const auto begun = read_begun_sweep(journal.parent_path());
  ASSERT_TRUE(begun.ok());
  EXPECT_EQ(begun->sweep_text(), plan.sweep_text());
}

TEST_F(BlockJournals, OfAnotherVersionAreLeftToIt) {
  const fs::path stored = journal.parent_path() / "sweep.json";
  std::ifstream file(stored);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string version = "\"version\":\"";
  ASSERT_NE(text.find(version), std::string::npos);
  text.insert(text.find(version) + version.size(), "0.");
  std::ofstream(stored) << text;
  EXPECT_EQ(read_begun_sweep(journal.parent_path()).errors()[0].code, "another_version");
}

TEST_F(BlockJournals, AreNotResumedWhereThePlanIsDamaged) {
  const fs::path stored = journal.parent_path() / "sweep.json";
  for (const std::string text : {"", "[]", "{\"version\": 1", "{\"version\": 1, \"problem\": {}, \"sweep\": 3}"}) {
    std::ofstream(stored) << text;
    EXPECT_EQ(read_begun_sweep(journal.parent_path()).errors()[0].code, "damaged_plan") << text;
    EXPECT_EQ(SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::resume).errors()[0].code, "damaged_plan");
  }
  fs::remove(stored);
  EXPECT_EQ(read_begun_sweep(journal.parent_path()).errors()[0].code, "no_sweep_begun");
}

// What a file may have, written out, is more than a file may have.
TEST(SweepFolder, ReadsBackWhateverItWasBegunWith) {
  std::string rows = "[9e14]";
  for (int row = 1; row < 900'000; ++row) rows += ",[9e14]";
  const SweepPlan plan = sweep_support::plan_of(sweep_support::sweep_text(
      "{\"method\": \"list\", \"rows\": [" + rows + "]}", R"([{"at": "/requirements/max_length"}])"));
  EXPECT_GT(plan.sweep_text().size(), 17u << 20);
  const ScratchFolder scratch;
  const auto folder = SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::fresh);
  ASSERT_TRUE(folder.ok());
  const auto begun = read_begun_sweep(folder->path());
  ASSERT_TRUE(begun.ok()) << begun.errors()[0].message;
  EXPECT_EQ(begun->sweep_text(), plan.sweep_text());
}

TEST(BlockJournal, IsWrittenByOneProcessAtATime) {
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  const auto folder = *SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::fresh);
  {
    const auto journal = BlockJournal::open(folder.path(), plan, 3);
    EXPECT_EQ(BlockJournal::open(folder.path(), plan, 3).errors()[0].code, "sweep_in_use");
    EXPECT_TRUE(BlockJournal::open(folder.path(), plan, 4).ok());
  }
  EXPECT_TRUE(BlockJournal::open(folder.path(), plan, 3).ok());
}

TEST(SweepFolder, LeavesOutputsAlone) {
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  const fs::path output = scratch.path() / "out.h5";
  std::ofstream(output) << "mine";
  EXPECT_EQ(SweepFolder::open(output, plan, SweepStart::fresh).errors()[0].code, "output_exists");
  EXPECT_EQ(SweepFolder::open(scratch.path(), plan, SweepStart::overwrite).errors()[0].code, "not_a_regular_file");
  EXPECT_EQ(SweepFolder::open(scratch.path() / "no" / "out.h5", plan, SweepStart::fresh).errors()[0].code,
            "unwritable_output");
  ASSERT_TRUE(SweepFolder::open(output, plan, SweepStart::overwrite).ok());
  EXPECT_EQ(fs::file_size(output), 4u);
}

}  // namespace
}  // namespace block_journal_test
}  // namespace linkwright
