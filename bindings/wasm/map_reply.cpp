#include "map_reply.hpp"

#include <algorithm>
#include <array>

#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "linkwright/files/number_text.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

template <class Counts>
void write_counts(JsonWriter& json, std::string_view key, const Counts& counts) {
  json.key(key);
  json.begin_list(JsonWriter::Layout::one_line);
  for (const std::int64_t count : counts) json.value(count);
  json.end_list();
}

template <class CountOf>
void write_by_requirement(JsonWriter& json, std::string_view key, RequirementKinds kinds, CountOf count_of) {
  std::vector<std::int64_t> counts;
  for (const RequirementKind kind : kinds) counts.push_back(count_of(kind));
  write_counts(json, key, counts);
}

void write_relaxation(JsonWriter& json, const Relaxation& relaxation) {
  json.begin_object(JsonWriter::Layout::one_line);
  json.member("requirement", key(relaxation.requirement));
  write_relaxed_value(json, relaxation);
  json.member("leaves", relaxation.leaves);
  json.end_object();
}

void write_missed_box(JsonWriter& json, const MissedBox& missed) {
  json.begin_object(JsonWriter::Layout::one_line);
  json.member("requirement", key(missed.box));
  json.key("nearest");
  write_numbers(json, std::array{missed.nearest.real(), missed.nearest.imag()});
  json.key("beyond");
  write_numbers(json, std::array{missed.beyond.real(), missed.beyond.imag()});
  json.end_object();
}

}  // namespace

void EvaluatedMap::classify(const std::function<void(RegionMap&)>& fill) {
  fill(map_);
  counts_ = map_.counts();
  values_.clear();
}

void EvaluatedMap::evaluate(const RequirementFilter& filter) {
  fails_.resize(map_.rows() * map_.columns());
  filter.failures_of_all(fails_);
  census_ = filter.census(fails_);
  relax_.clear();
  relax_together_.reset();
  missed_boxes_.clear();
  inside_ = {};
}

void EvaluatedMap::note_nothing_left(std::vector<MissedBox> missed, const InsideWindows& inside,
                                     std::vector<Relaxation> relax) {
  missed_boxes_ = std::move(missed);
  inside_ = inside;
  relax_ = std::move(relax);
  relax_together_ = relax_.empty() && inside.meeting == 0 ? census_.joint_relaxation() : std::nullopt;
}

void EvaluatedMap::measure(std::string_view key) {
  const std::vector<Measure> told = map_.reported_measures();
  const auto named = std::find(told.begin(), told.end(), Measure{key});
  const Measure& shown = named == told.end() ? told.front() : *named;
  values_.resize(map_.rows() * map_.columns());
  for (std::size_t row = 0; row < map_.rows(); ++row)
    row_values(map_, shown, row, std::span(values_).subspan(map_.index(row, 0), map_.columns()));
  ridges_ = linkwright::ridges(values_, fails_, map_.columns(), shown.larger_is_better);
}

void EvaluatedMap::show(const std::function<void(std::span<float> values)>& fill, bool larger_is_better) {
  values_.assign(map_.rows() * map_.columns(), 0);
  fill(values_);
  ridges_ = linkwright::ridges(values_, fails_, map_.columns(), larger_is_better);
}

std::string EvaluatedMap::census_json() const {
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    write_counts(json, "types", counts_.types);
    json.member("pairs", counts_.pairs);
    json.member("order", counts_.order);
    json.member("branch", counts_.branch);
    json.member("circuit", counts_.circuit);
    json.member("defect_free", counts_.defect_free);
    json.member("meeting", census_.meeting);
    write_counts(json, "meeting_types", census_.meeting_types);
    write_by_requirement(json, "only", census_.kinds, [&](RequirementKind kind) { return census_.failing_only(kind); });
    write_by_requirement(json, "left", census_.kinds, [&](RequirementKind kind) { return census_.left_after(kind); });
    json.key("relax");
    json.begin_list();
    for (const Relaxation& relaxation : relax_) write_relaxation(json, relaxation);
    json.end_list();
    json.key("relax_together");
    relax_together_ ? write_joint_relaxation(json, *relax_together_) : json.null();
    json.key("missed_boxes");
    json.begin_list();
    for (const MissedBox& missed : missed_boxes_) write_missed_box(json, missed);
    json.end_list();
    json.key("inside");
    json.begin_object(JsonWriter::Layout::one_line);
    json.member("looked_at", inside_.looked_at);
    json.member("meeting", inside_.meeting);
    json.member("is_empty", inside_.is_empty);
    json.end_object();
    json.end_object();
  });
}

}  // namespace linkwright::wasm
