#pragma once

#include <filesystem>
#include <string>

#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright::sweep_support {

/// A small problem: five precision points, a fraction of a millisecond.
[[nodiscard]] std::string sweep_text(const std::string& sampling, const std::string& vary,
                                     const std::string& keep = "");

/// The plan of a sweep file's text; the test ends where it has mistakes.
[[nodiscard]] SweepPlan plan_of(const std::string& text);
/// 40 samples, some of them without a linkage and some invalid.
[[nodiscard]] SweepPlan small_plan();

/// A new empty folder that goes when the object does.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace linkwright::sweep_support
