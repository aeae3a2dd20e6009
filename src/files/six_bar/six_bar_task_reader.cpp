#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/four_bar/pose_reader.hpp"
#include "files/six_bar/six_bar_kind.hpp"

namespace linkwright {
namespace {

bool read_assembly_modes(const JsonObject& object, std::array<int, 4>& assembly_mode) {
  const auto found = object.find("elbow");
  if (!found) return true;
  std::size_t count = 0;
  bool complete = true;
  const bool is_list = found->for_each({"signs", "a list of four signs"}, [&](const JsonValue& item) {
    const auto sign = item.as_whole_number();
    if (sign && count < assembly_mode.size()) assembly_mode[count] = *sign;
    complete = complete && sign;
    ++count;
  });
  if (is_list && complete && count != assembly_mode.size()) {
    found->mistake("elbow_count", fmt::format("{} signs are given; one to each of the four poses belongs here", count),
                   {{"count", count}});
    return false;
  }
  return is_list && complete;
}

bool read_added(const JsonObject& object, std::array<BodyPair, 2>& added) {
  const auto found = object.require("added", {"\"added\": [\"0-2\", \"0-3\"]"});
  if (!found) return false;
  std::vector<BodyPair> pairs;
  bool complete = true;
  const bool is_list = found->for_each({"bodies", "two pairs of bodies"}, [&](const JsonValue& item) {
    const auto text = item.as_text();
    const auto pair = text ? body_pair_from(*text) : std::nullopt;
    if (text && !pair)
      item.mistake("unknown_bodies", fmt::format("{} names no two bodies; write them as in \"0-2\"", in_quotes(*text)),
                   {{"given", in_quotes(*text)}});
    if (pair) pairs.push_back(*pair);
    complete = complete && pair;
  });
  if (!is_list || !complete) return false;
  if (pairs.size() != added.size()) {
    found->mistake("added_count",
                   fmt::format("{} added links are given; a six-bar has two beside the chain", pairs.size()),
                   {{"count", pairs.size()}});
    return false;
  }
  added = {pairs[0], pairs[1]};
  return true;
}

}  // namespace

Task read_six_bar_task(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "poses", "chain", "added"});
  SixBarTask task;
  task.box = options_box;
  bool complete = read_poses(object, mistakes, task.poses, task.points);
  complete = read_added(object, task.added) && complete;
  if (const auto chain = object.find("chain"); chain && !chain->is_null()) {
    task.chain = read_chain(*chain, mistakes);
    complete = complete && task.chain;
  }
  if (complete) mistakes.add_new(mistakes_in(task));  // the box is also the options'
  return task;
}

std::optional<ThreeLinkChain> read_chain(const JsonValue& value, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"a", "b", "d", "elbow"});
  const auto a = object.require_point("a"), b = object.require_point("b"), d = object.require_point("d");
  ThreeLinkChain chain;
  if (!read_assembly_modes(object, chain.assembly_mode) || !a || !b || !d) return std::nullopt;
  chain.a = *a;
  chain.b = *b;
  chain.d = *d;
  return chain;
}

}  // namespace linkwright
