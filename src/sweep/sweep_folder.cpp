#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/json/json.hpp"
#include "files/json/json_document.hpp"
#include "journal_records.hpp"
#include "linkwright/files/text_file.hpp"
#include "plan_base.hpp"

namespace linkwright {
namespace {

constexpr std::string_view plan_file = "sweep.json", lock_file = "sweep.lock", replaces = "replaces_output";
// A problem and a sweep, each as large and as deep as its file may be; numbers written anew can be some times as long.
constexpr JsonLimits plan_limits = {.max_bytes = 256u << 20, .deepest_nesting = 128, .kept = {}};

Json plan_tree(const SweepPlan& plan) {
  return {{"version", LINKWRIGHT_VERSION},
          {"problem", Json::parse(plan.base_text())},
          {"sweep", Json::parse(plan.sweep_text())}};
}

/// The first place where two trees differ, as a JSON pointer; empty where they do not.
std::string first_difference(const Json& a, const Json& b) {
  const Json patch = Json::diff(a, b);
  return patch.empty() ? "" : patch.front()["path"].get<std::string>();
}

Error another_sweep(const std::filesystem::path& folder, std::string_view what) {
  return {"another_sweep",
          "",
          fmt::format("what is done in {} is of another sweep: {}; --overwrite begins anew", folder.string(), what),
          {{"what", what}}};
}

Error damaged_plan(const std::filesystem::path& path, std::string_view why) {
  return {"damaged_plan", "", fmt::format("{} cannot be read: {}; --overwrite begins anew", path.string(), why)};
}

/// The tree that a folder was begun with.
Result<Json> stored_plan(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / plan_file;
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return Error{"no_sweep_begun", "", "no sweep is begun in the folder " + folder.string()};
  const auto text = read_text_file(path, plan_limits.max_bytes);
  auto tree = text ? parse_json(*text, plan_limits) : Result<Json>(text.errors());
  if (!tree) return damaged_plan(path, tree.errors().front().message);
  const auto has = [&](std::string_view key) { return tree->is_object() && tree->contains(key); };
  if (has("version") && has("problem") && has("sweep") && tree->at("sweep").is_object()) return tree;
  return damaged_plan(path, "it is not as it was written");
}

/// What differs between the plan of a folder and this one; nothing where they are the same.
std::optional<Error> difference(const std::filesystem::path& folder, const Json& stored, const SweepPlan& plan) {
  const Json wanted = plan_tree(plan);
  if (stored.dump() == wanted.dump()) return std::nullopt;  // as the journals compare it
  if (stored == wanted) return another_sweep(folder, "a number is written otherwise, such as 200.0 for 200");
  if (stored.at("version") != wanted["version"])
    return another_sweep(
        folder, fmt::format("it was begun by version {}, this is {}", stored.at("version").dump(), LINKWRIGHT_VERSION));
  return another_sweep(folder, fmt::format("they differ at {}", first_difference(stored, wanted)));
}

std::optional<Error> refuse_output(const std::filesystem::path& output, SweepStart start) {
  std::error_code error;
  const auto status = std::filesystem::status(output, error);
  if (!std::filesystem::exists(status)) return std::nullopt;
  if (!std::filesystem::is_regular_file(status))
    return Error{"not_a_regular_file", "", "this output path is no regular file; it was left alone, name another file"};
  if (start != SweepStart::fresh) return std::nullopt;
  return Error{"output_exists", "", "this file exists; --overwrite replaces it"};
}

/// A plan that was on its way to its name when the program was killed.
bool is_unfinished_plan(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with("." + std::string(plan_file)) && name.ends_with(".tmp");
}

/// What a sweep has put there but its lock, the plan first; nothing else.
void remove_own(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::remove(folder / plan_file, error);
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_journal(entry.path()) || is_unfinished_plan(entry.path())) std::filesystem::remove(entry.path(), error);
}

Error journals_without_plan(const std::filesystem::path& folder, std::string_view way_out) {
  return {"journals_without_plan", "",
          fmt::format("{} has journals, but not the plan that they are of; {}", folder.string(), way_out)};
}

/// Journals whose plan is gone: where this is it they are as good as ever.
std::optional<Error> refuse_orphans(const std::filesystem::path& folder, const SweepPlan& plan, SweepStart start) {
  if (start == SweepStart::overwrite) return std::nullopt;
  const auto scan = scan_journals(folder, plan);
  if (!scan) return scan.errors().front();
  if (scan->journals.empty()) return std::nullopt;
  if (start == SweepStart::fresh)
    return journals_without_plan(folder, "--resume goes on where it was this one, --overwrite begins anew");
  if (scan->blocks.empty() && scan->corrupt > 0)
    return journals_without_plan(folder, "it was another than this; --overwrite begins anew");
  return std::nullopt;
}

/// The descriptor of a folder's lock; the folder is made where it is missing. A mistake where another run has it. A run
/// that ends removes folder and lock: what is locked must still be what has the name.
Result<int> locked(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / lock_file;
  constexpr int most_ends = 100;  // of other runs meanwhile
  for (int round = 0; round < most_ends; ++round) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (error) return unwritable("cannot be made", folder, error.value());
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0 && errno == ENOENT) continue;
    if (descriptor < 0) return unwritable("cannot be written", path, errno);
    struct stat own {};
    struct stat named {};
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      ::close(descriptor);
      return sweep_in_use();
    }
    if (::fstat(descriptor, &own) == 0 && ::stat(path.c_str(), &named) == 0 && own.st_ino == named.st_ino &&
        own.st_dev == named.st_dev)
      return descriptor;
    ::close(descriptor);
  }
  return sweep_in_use();
}

}  // namespace

struct SweepFolder::Lock : OpenFile {
  using OpenFile::OpenFile;
};

std::filesystem::path SweepFolder::beside(const std::filesystem::path& output) { return output.string() + ".partial"; }

bool SweepFolder::is_begun(const std::filesystem::path& output) {
  std::error_code error;
  return std::filesystem::exists(beside(output) / plan_file, error);
}

Result<SweepFolder> SweepFolder::open(const std::filesystem::path& output, const SweepPlan& plan, SweepStart start) {
  if (const auto refusal = refuse_output(output, start)) return *refusal;
  SweepFolder folder;
  folder.path_ = beside(output);
  const auto lock = locked(folder.path_);
  if (!lock) return lock.errors();
  folder.lock_ = std::make_shared<Lock>(*lock);
  if (const auto refusal = refuse_output(output, start)) return *refusal;  // another run may have ended meanwhile
  const bool begun = is_begun(output);
  if (begun && start == SweepStart::fresh)
    return Error{"sweep_begun", "",
                 "a sweep to this file was begun; --resume goes on with it, --overwrite begins anew"};
  if (begun && start == SweepStart::resume) {
    auto stored = stored_plan(folder.path_);
    if (!stored) return stored.errors();
    folder.replaces_output_ = stored->erase(std::string(replaces)) > 0;
    if (const auto refusal = difference(folder.path_, *stored, plan)) return *refusal;
    return folder;
  }
  if (const auto refusal = begun ? std::nullopt : refuse_orphans(folder.path_, plan, start)) return *refusal;
  folder.replaces_output_ = start == SweepStart::overwrite;
  if (start == SweepStart::overwrite) remove_own(folder.path_);
  Json tree = plan_tree(plan);
  if (folder.replaces_output_) tree[replaces] = true;
  if (auto failure = write_atomically(folder.path_ / plan_file, tree.dump() + "\n")) return *failure;
  return folder;
}

void SweepFolder::tidy_up(const std::filesystem::path& output) {
  std::error_code error;
  if (!std::filesystem::is_directory(beside(output), error) || is_begun(output)) return;
  const auto lock = locked(beside(output));
  if (!lock) return;
  SweepFolder folder;
  folder.path_ = beside(output);
  folder.lock_ = std::make_shared<Lock>(*lock);
  if (!is_begun(output)) folder.remove();
}

Result<JournalScan> SweepFolder::scan(const SweepPlan& plan) const { return scan_journals(path_, plan); }

void SweepFolder::remove() {
  remove_own(path_);
  std::error_code error;
  std::filesystem::remove(path_ / lock_file, error);
  std::filesystem::remove(path_, error);
  lock_.reset();
}

Result<SweepPlan> read_begun_sweep(const std::filesystem::path& folder) {
  const auto stored = stored_plan(folder);
  if (!stored) return stored.errors();
  if (stored->at("version") != LINKWRIGHT_VERSION)
    return Error{"another_version", "",
                 fmt::format("what is done in {} was begun by version {}, this is {}; that version goes on with it",
                             folder.string(), stored->at("version").dump(), LINKWRIGHT_VERSION)};
  Json sweep = stored->at("sweep");
  sweep["problem"] = stored->at("problem");
  return read_sweep_tree(sweep, {});
}

}  // namespace linkwright
