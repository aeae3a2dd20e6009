#include "synthesis/listed_linkages.hpp"

#include <utility>
#include <variant>

#include "kinds/kinds.hpp"

namespace linkwright {
namespace {

/// Nothing is told of any linkage where the list is empty.
template <class Item>
void pick(std::vector<Item>& items, std::span<const std::size_t> places) {
  if (items.empty()) return;
  std::vector<Item> picked;
  picked.reserve(places.size());
  for (const std::size_t place : places) picked.push_back(std::move(items[place]));
  items = std::move(picked);
}

}  // namespace

std::vector<std::optional<LinkageOutput>> listed_outputs(const Answer& answer, double turning_length) {
  std::vector<std::optional<LinkageOutput>> outputs;
  const auto append = [&](std::optional<LinkageOutput> output) {
    if (output) output = with_turning_length(*std::move(output), turning_length);
    outputs.push_back(std::move(output));
  };
  std::visit(
      [&](const auto& of_kind) {
        for (const auto& found : of_kind.linkages) append(output_of(of_kind, found));
      },
      answer);
  return outputs;
}

void list_again(Answer& answer, std::span<const std::size_t> places) {
  std::visit(
      [&](auto& of_kind) {
        pick(of_kind.linkages, places);
        pick(of_kind.tolerance, places);
        pick(of_kind.loads, places);
        pick(of_kind.fails, places);
      },
      answer);
}

void take_list(Answer& answer, Answer other) {
  std::visit(
      [&](auto& of_kind) {
        auto& from = std::get<std::decay_t<decltype(of_kind)>>(other);
        of_kind.linkages = std::move(from.linkages);
        of_kind.tolerance = std::move(from.tolerance);
        of_kind.loads = std::move(from.loads);
        of_kind.fails = std::move(from.fails);
      },
      answer);
}

}  // namespace linkwright
