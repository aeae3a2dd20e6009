#include "files/four_bar/four_bar_writer.hpp"
#include "files/six_bar/six_bar_writer.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {
namespace {

/// What a result file says of a linkage.
std::string record_of(const std::function<void(JsonWriter&)>& write) {
  std::string text;
  JsonWriter json([&text](std::string_view piece) { text += piece; });
  write(json);
  return text;
}

StoredLinkage stored(const FourBarSolution& found, const FourBarAnswer& answer,
                     const std::vector<PrescribedPose>& poses) {
  const FourBarNotes notes = notes_on(found, answer.given);
  StoredLinkage linkage;
  linkage.four_bar = found.four_bar;
  linkage.poses = notes.poses.empty() ? poses : notes.poses;
  linkage.record = record_of([&](JsonWriter& json) { write_four_bar(json, found, answer.given.frame(), notes); });
  return linkage;
}

StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer) {
  return stored(found, answer, answer.task.poses);
}

StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer) { return stored(found, answer, {}); }

StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer) {
  StoredSixBar linkage;
  linkage.six_bar = found.member.six_bar;
  linkage.row = found.row;
  for (std::size_t j = 0; j < linkage.elbow.size(); ++j)
    linkage.elbow[j] = (found.chain.elbow[j] > 0 ? 1 : 0) - (found.chain.elbow[j] < 0 ? 1 : 0);
  linkage.poses = answer.task.poses;
  linkage.record = record_of([&](JsonWriter& json) { write_six_bar(json, found); });
  return linkage;
}

}  // namespace

std::vector<AnyStoredLinkage> stored_linkages(const Problem& problem, const Answer& answer) {
  std::vector<AnyStoredLinkage> linkages;
  std::visit(
      [&](const auto& of_kind) {
        for (const auto& found : of_kind.linkages) {
          auto linkage = stored(found, of_kind);
          linkage.title = problem.title;
          linkage.length_unit = problem.length_unit;
          linkages.push_back(std::move(linkage));
        }
      },
      answer);
  return linkages;
}

}  // namespace linkwright
