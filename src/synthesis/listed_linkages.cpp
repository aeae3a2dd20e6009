#include "synthesis/listed_linkages.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "kinds/kinds.hpp"
#include "region/climb.hpp"

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

namespace {

template <class Item>
void move_behind(std::vector<Item>& items, std::vector<Item>& more) {
  items.insert(items.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// What has been found to meet the limits of analyses is not measured again.
Requirements without_analyses(Requirements wanted) {
  for (const Criterion& asked : criteria())
    if (asked.is_of_analysis()) asked.set(wanted, asked.any);
  return wanted;
}

/// A linkage of a list, judged again; no cell where rounding puts it beyond a limit.
struct JudgedAgain {
  std::size_t place;
  std::optional<Candidate> candidate;
  double score;
};

/// Of lists that are each best first: what is not judged ranks as the one before it.
template <class KindAnswer>
std::vector<JudgedAgain> judged_again(const KindAnswer& of, const Evaluator& evaluator, std::size_t first_list) {
  std::vector<JudgedAgain> all;
  for (std::size_t i = 0; i < of.linkages.size(); ++i) {
    const bool begins = i == 0 || i == first_list;
    JudgedAgain each{i, evaluator.candidate(of.point_of(of.linkages[i])), begins ? 1e300 : all.back().score};
    if (each.candidate) each.score = each.candidate->score;
    all.push_back(std::move(each));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const JudgedAgain& a, const JudgedAgain& b) { return a.score > b.score; });
  return all;
}

double usual_size(const std::vector<JudgedAgain>& all, const Evaluator& evaluator) {
  std::vector<double> sizes;
  for (const JudgedAgain& each : all)
    if (each.candidate) sizes.push_back(evaluator.size(*each.candidate));
  const auto middle = sizes.begin() + std::ssize(sizes) / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return sizes.empty() ? 0 : *middle;
}

template <class KindAnswer>
std::vector<std::size_t> distinct_places(const KindAnswer& of, std::size_t first_list) {
  const Evaluator evaluator(*of.family(), without_analyses(of.requirements), of.options.objective, {}, of.added);
  const std::vector<JudgedAgain> all = judged_again(of, evaluator, first_list);
  const double usual = usual_size(all, evaluator);
  std::vector<std::size_t> places;
  std::vector<Candidate> held;
  for (const JudgedAgain& each : all) {
    if (places.size() == static_cast<std::size_t>(of.options.best)) break;
    const auto is_same = [&](const Candidate& other) {
      return evaluator.distance(*each.candidate, other) < evaluator.same_within(*each.candidate, usual);
    };
    if (each.candidate && std::any_of(held.begin(), held.end(), is_same)) continue;
    places.push_back(each.place);
    if (each.candidate) held.push_back(*each.candidate);
  }
  return places;
}

}  // namespace

void merge_list(Answer& answer, Answer other) {
  const auto places = std::visit(
      [&](auto& of_kind) {
        auto& from = std::get<std::decay_t<decltype(of_kind)>>(other);
        const std::size_t first_list = of_kind.linkages.size();
        move_behind(of_kind.linkages, from.linkages);
        move_behind(of_kind.tolerance, from.tolerance);
        move_behind(of_kind.loads, from.loads);
        move_behind(of_kind.fails, from.fails);
        return distinct_places(of_kind, first_list);
      },
      answer);
  list_again(answer, places);
}

}  // namespace linkwright
