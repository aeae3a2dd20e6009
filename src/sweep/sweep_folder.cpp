#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "files/json/json_document.hpp"
#include "journal_records.hpp"
#include "linkwright/files/atomic_file.hpp"
#include "linkwright/files/text_file.hpp"

namespace linkwright {
namespace {

using Json = nlohmann::json;

constexpr std::string_view plan_file = "sweep.json", lock_file = "lock";
constexpr std::size_t max_plan_bytes = 64u << 20;

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

/// What differs between the plan of a folder and this one; nothing where they are the same.
std::optional<Error> difference(const std::filesystem::path& folder, const SweepPlan& plan) {
  const auto text = read_text_file(folder / plan_file, max_plan_bytes);
  const auto stored = text ? parse_json(*text, {.max_bytes = max_plan_bytes, .kept = {}}) : Result<Json>(text.errors());
  if (!stored) return another_sweep(folder, fmt::format("its {} cannot be read", plan_file));
  const Json wanted = plan_tree(plan);
  if (stored->dump() == wanted.dump()) return std::nullopt;  // as the journals compare it
  if (*stored == wanted) return another_sweep(folder, "a number is written otherwise, such as 200.0 for 200");
  if (stored->is_object() && stored->contains("version") && stored->at("version") != wanted["version"])
    return another_sweep(folder, fmt::format("it was begun by version {}, this is {}", stored->at("version").dump(),
                                             LINKWRIGHT_VERSION));
  return another_sweep(folder, fmt::format("they differ at {}", first_difference(*stored, wanted)));
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

void remove_journals(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::remove(folder / plan_file, error);
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".journal") std::filesystem::remove(entry.path(), error);
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
  std::error_code error;
  std::filesystem::create_directory(folder.path_, error);
  if (error) return unwritable("cannot be made", folder.path_, error.value());
  const std::filesystem::path lock = folder.path_ / lock_file;
  folder.lock_ = std::make_shared<Lock>(::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (folder.lock_->descriptor() < 0) return unwritable("cannot be written", lock, errno);
  if (::flock(folder.lock_->descriptor(), LOCK_EX | LOCK_NB) != 0) return sweep_in_use();
  const bool begun = is_begun(output);
  if (begun && start == SweepStart::fresh)
    return Error{"sweep_begun", "",
                 "a sweep to this file was begun; --resume goes on with it, --overwrite begins anew"};
  if (begun && start == SweepStart::resume) {
    if (const auto refusal = difference(folder.path_, plan)) return *refusal;
    return folder;
  }
  remove_journals(folder.path_);
  if (auto failure = write_atomically(folder.path_ / plan_file, plan_tree(plan).dump(2) + "\n")) return *failure;
  return folder;
}

Result<JournalScan> SweepFolder::scan(const SweepPlan& plan) const { return scan_journals(path_, plan); }

void SweepFolder::remove() {
  remove_journals(path_);
  std::error_code error;
  std::filesystem::remove(path_ / lock_file, error);
  std::filesystem::remove(path_, error);
  lock_.reset();
}

Result<SweepPlan> read_begun_sweep(const std::filesystem::path& folder) {
  const auto text = read_text_file(folder / plan_file, max_plan_bytes);
  if (!text) return text.errors();
  const auto stored = parse_json(*text, {.max_bytes = max_plan_bytes, .kept = {}});
  if (!stored) return stored.errors();
  if (!stored->is_object() || !stored->contains("sweep") || !stored->at("sweep").is_object())
    return another_sweep(folder, fmt::format("its {} cannot be read", plan_file));
  Json sweep = stored->at("sweep");
  sweep["problem"] = stored->value("problem", Json());
  return SweepPlan::read(sweep.dump(), {});
}

}  // namespace linkwright
