#pragma once

#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/region/criterion.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// `"tolerance"` of a linkage: what tolerances do to it.
void write_tolerance_report(JsonWriter& json, const ToleranceReport& report, const Tolerances& tolerances);

/// What a list says of a linkage beside the linkage: at a picked place what it fails, with tolerances what they do.
class ListedNotes {
 public:
  /// Of a linkage that is in no list.
  ListedNotes() = default;
  /// Of the linkage number `place` of an answer. Refers to the findings.
  ListedNotes(const Findings& found, std::size_t place);

  void write(JsonWriter& json) const;

 private:
  const std::vector<RequirementKind>* fails_ = nullptr;
  const std::optional<ToleranceReport>* tolerance_ = nullptr;
  const Tolerances* tolerances_ = nullptr;
};

}  // namespace linkwright
