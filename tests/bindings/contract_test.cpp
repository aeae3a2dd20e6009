#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "files/fields/field_schema.hpp"
#include "files/fields/result_forms.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/files/problem_file.hpp"
#include "replies.hpp"
#include "support/file_support.hpp"

// What the page is told by the engine: its types, and the numbers by which both count.
namespace linkwright::contract_test {
namespace {

using namespace linkwright::wasm;
using Json = OrderedJson;

/// One member to each reply, so that all of them are described.
struct Replies {};
template <class Reply>
void reply_member(FieldVisitor& v, std::string_view key, const Reply& reply) {
  v.member(Field(key), true, [&](FieldVisitor& to) { fields(to, reply); });
}
void fields(FieldVisitor& v, const Replies& /*of*/) {
  const Findings known;
  const ShownAxes axes;
  const ColouredMap map{};
  const PickedLinkage picked{};
  v.object({}, [&](FieldVisitor& to) {
    reply_member(to, "notice", WordedNotice{});
    reply_member(to, "mistake", WordedMistake{});
    reply_member(to, "task", TaskReply{known, axes, planar_linkages});
    reply_member(to, "census", CensusReply{map});
    reply_member(to, "linkage", PlacedLinkage{picked});
    reply_member(to, "best", BestReply{});
    reply_member(to, "improve", ImprovedReply{});
    reply_member(to, "verify", VerifiedReply{});
    reply_member(to, "tolerance", ToleranceFigures{});
    reply_member(to, "loads", LoadFigures{});
    reply_member(to, "stud_map", StudMapReply{});
    reply_member(to, "yields", YieldsReply{});
    reply_member(to, "front", FrontReply{});
    reply_member(to, "fits", FitSearchReply{});
    reply_member(to, "machine", MachinePlan{});
    reply_member(to, "outlines", OutlinesReply{});
  });
}

template <class Names>
std::string list(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\"";
  return "[" + text + "]";
}

std::string state_columns_text() {
  return fmt::format(
      "/** Of a state of a drive, whatever the kind of linkage: the driver's angle from position 1, in the sense of "
      "travel positive; the moving pivots of input and output; the pose of the moving frame; the angles of coupler and "
      "output from position 1; dψ/dφ, output by input, 0 at a dead point; output torque over input torque, |dφ/dψ|, 0 "
      "where unbounded. */\nexport const state_columns = {} as const;\nexport const state_width = "
      "state_columns.length;\n",
      list(state_columns));
}

std::string defect_bits_text() {
  return fmt::format("export const defect_bits = {{ order: {}, branch: {}, circuit: {} }} as const;\n",
                     Defects::order_bit, Defects::branch_bit, Defects::circuit_bit);
}

// Of some tasks of the kind there are more, at the end.
template <class Task>
RequirementKinds most_requirements() {
  return linkages(linkwright::Task(Task{})).requirements;
}
template <>
RequirementKinds most_requirements<MotionTask>() {
  return near_motion_linkages.requirements;
}
template <>
RequirementKinds most_requirements<PathTask>() {
  return near_path_linkages.requirements;
}

template <class Task>
void add_requirements(std::string& text) {
  const Json task = Json::parse(write_problem(Problem{.task = Task{}})).at("task");
  const std::string kind = task.at("kind"), mechanism = task.at("mechanism");
  std::vector<std::string_view> keys;
  for (const RequirementKind each : most_requirements<Task>()) keys.push_back(key(each));
  text += fmt::format("\"{} {}\": {},\n", kind, mechanism, list(keys));
}
template <class... Tasks>
std::string requirements_text(const std::variant<Tasks...>* /*of*/) {
  std::string text;
  (add_requirements<Tasks>(text), ...);
  return fmt::format(
      "/** What can be required, by kind and mechanism of the task: in this order are the bits of what a linkage or a "
      "cell fails (a degenerate cell has all set). */\nexport const requirement_keys_of = {{\n{}}} as const satisfies "
      "Record<string, readonly RequirementKey[]>;\n",
      text);
}

std::string contract() {
  FieldSchema visitor(FieldSchema::Defaults::left_out);
  fields(visitor, Replies{});
  return "// What the engine says to the page: generated from its fields (docs/architecture.md), not written.\n"
         "import type {Chain, Requirements} from \"./problem\";\n"
         "import type {Dyad, FourBar, InsideWindows, JointRelaxation, LoadReport, Relaxation, SixBar, "
         "SphericalDyad, SphericalFourBar, StraightLineFourBar, Tolerance} from \"./result\";\n\n" +
         typescript(visitor.take(), "ToldAsText") + state_columns_text() + defect_bits_text() +
         requirements_text(static_cast<const Task*>(nullptr));
}

TEST(Contract, IsInTheTypesOfThePage) {
  const std::string path = std::string(LINKWRIGHT_SCHEMA_DIR) + "/../web/src/contract/replies.ts", text = contract();
  if (std::getenv("LINKWRIGHT_GENERATE") != nullptr) std::ofstream(path) << text;
  EXPECT_EQ(testing::text_of(path), text) << "run LINKWRIGHT_GENERATE=1 build/release/bin/tests_bindings";
}

// Maps hold types as numbers: the list by which the page reads them is in their order.
TEST(Contract, HasTheTypesOfLinkagesInTheOrderOfTheirCodes) {
  for (std::size_t code = 0; code < linkage_type_count; ++code)
    EXPECT_EQ(forms::linkage_types.choices.at(code), static_cast<LinkageType>(code));
}

}  // namespace
}  // namespace linkwright::contract_test
