#include "linkwright/function/wanted_function.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::string place_of_pair(std::size_t pair) { return fmt::format("task.pairs[{}]", pair); }

// A first derivative must move the input: the output is a function of it.
void check_first_derivative(const AngleDerivative& first, const std::string& place, std::vector<Error>& found) {
  if (std::abs(first.input) >= tolerance::smallest_direction) return;
  if (std::abs(first.output) < tolerance::smallest_direction)
    found.push_back({"zero_rates", place,
                     "the first derivative is zero: neither link moves; give the rates of both, of any size, or leave "
                     "derivatives out"});
  else
    found.push_back({"input_at_rest", place + ".input",
                     "the output moves while the input stands still: no function of the input does that; give the "
                     "input a rate, or exchange input and output"});
}

void check_numbers(const WantedFunction& wanted, std::vector<Error>& found) {
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i) {
    const AnglePair& pair = wanted.pairs[i];
    const std::size_t before = found.size();
    check_angle(pair.input, "input_deg", place_of_pair(i) + ".input_deg", found);
    check_angle(pair.output, "output_deg", place_of_pair(i) + ".output_deg", found);
    for (std::size_t m = 0; m < pair.derivatives.size(); ++m) {
      const std::string here = fmt::format("{}.derivatives[{}]", place_of_pair(i), m);
      check_number(pair.derivatives[m].input, "input", here + ".input", found);
      check_number(pair.derivatives[m].output, "output", here + ".output", found);
    }
    if (found.size() == before && !pair.derivatives.empty())
      check_first_derivative(pair.derivatives.front(), place_of_pair(i) + ".derivatives[0]", found);
  }
}

std::string count_words(const WantedFunction& wanted, int count) {
  const std::size_t pairs = wanted.pairs.size(), derivatives = static_cast<std::size_t>(count) - pairs;
  if (derivatives == 0) return fmt::format("{} {} given", pairs, pairs == 1 ? "pair was" : "pairs were");
  return fmt::format("{} positions were given ({} pair{} and {} derivative{}, each counting as one)", count, pairs,
                     pairs == 1 ? "" : "s", derivatives, derivatives == 1 ? "" : "s");
}

void check_count(const WantedFunction& wanted, std::vector<Error>& found) {
  constexpr int fewest = 4, most = 5;
  const int count = position_count(wanted.pairs), pairs = static_cast<int>(wanted.pairs.size());
  const bool plain = count == pairs;
  const Values values = {{"count", count},   {"pairs", pairs}, {"derivatives", count - pairs},
                         {"fewest", fewest}, {"most", most},   {"change", std::max(fewest - count, count - most)}};
  if (count < fewest)
    found.push_back({plain ? "too_few_pairs" : "too_few_pair_positions", "task.pairs",
                     fmt::format("{} and {} or {} are needed; add {} (rates at a pair, \"derivatives\", count as one "
                                 "more)",
                                 count_words(wanted, count), fewest, most, fewest - count),
                     values});
  if (count > most)
    found.push_back({plain ? "too_many_pairs" : "too_many_pair_positions", "task.pairs",
                     fmt::format("{} and {} can be met; remove {}", count_words(wanted, count), most, count - most),
                     values});
}

void check_repetitions(const WantedFunction& wanted, std::vector<Error>& found) {
  for (std::size_t j = 1; j < wanted.pairs.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (std::abs(wrap_signed(wanted.pairs[j].input - wanted.pairs[i].input)) < tolerance::repeated_input_angle) {
        found.push_back({"repeated_input",
                         place_of_pair(j) + ".input_deg",
                         fmt::format("pairs[{}] and pairs[{}] have the same input angle, and one input has one output; "
                                     "change one of them, or give rates (\"derivatives\") at one pair instead",
                                     i, j),
                         {{"i", i}, {"j", j}}});
        break;
      }
}

void check_output_moves(const WantedFunction& wanted, std::vector<Error>& found) {
  const auto stands = [&](const AnglePair& pair) {
    return std::abs(wrap_signed(pair.output - wanted.pairs.front().output)) < tolerance::repeated_input_angle &&
           std::all_of(pair.derivatives.begin(), pair.derivatives.end(),
                       [](const AngleDerivative& d) { return std::abs(d.output) < tolerance::smallest_direction; });
  };
  if (std::all_of(wanted.pairs.begin(), wanted.pairs.end(), stands))
    found.push_back({"constant_output", "task.pairs",
                     "the output link stands still at all pairs: that needs no linkage; change an output angle"});
}

void check_function(const WantedFunction& wanted, std::vector<Error>& found) {
  if (!wanted.function) return;
  const auto mistakes = mistakes_in(*wanted.function);
  found.insert(found.end(), mistakes.begin(), mistakes.end());
}

void check_free(const WantedFunction& wanted, std::vector<Error>& found) {
  if (!wanted.free) return;
  const auto [low, high] = wanted.free->range;
  const bool scales = wanted.free->kind == FreeParameter::Kind::output_scale;
  const double most = scales ? largest_coordinate : radians(largest_coordinate);
  if (position_count(wanted.pairs) != 4)
    found.push_back({"free_number_of_five", "task.free",
                     "a number can be left free with four positions; five already leave nothing to choose"});
  if (!(std::abs(low) <= most && std::abs(high) <= most && low < high))
    found.push_back({"range_order",
                     "task.free.range",
                     fmt::format("the range is [low, high] with low below high, both numbers between −{0} and {0}",
                                 limit_text(largest_coordinate)),
                     {{"most", limit_text(largest_coordinate)}}});
  else if (scales && low < 1 / largest_coordinate)
    found.push_back({"scale_range", "task.free.range",
                     "the output's travel is multiplied by a positive number; turn the signs of the outputs round to "
                     "let it turn the other way"});
  if (!scales && wanted.free->pair >= wanted.pairs.size())
    found.push_back({"no_such_pair",
                     "task.free.pair",
                     fmt::format("there are only {} pairs; name one of them", wanted.pairs.size()),
                     {{"count", wanted.pairs.size()}}});
}

constexpr std::array<std::string_view, 2> free_names = {"output_scale", "pair_output"};

}  // namespace

std::vector<Error> mistakes_in(const WantedFunction& wanted) {
  std::vector<Error> found;
  check_function(wanted, found);
  if (!found.empty() && wanted.pairs.empty()) return found;  // the pairs would have come from the function
  check_count(wanted, found);
  check_numbers(wanted, found);
  if (found.empty()) {
    check_repetitions(wanted, found);
    check_output_moves(wanted, found);
  }
  check_free(wanted, found);
  return found;
}

std::vector<AnglePair> precision_pairs(const NamedFunction& function) {
  const ScaledFunction scaled(function);
  std::vector<AnglePair> pairs;
  for (const double x : scaled.precision_points()) {
    const double input = scaled.input_at(x);
    pairs.push_back({input, scaled.output_of(x), {}});
  }
  return pairs;
}

WantedFunction wanted_at(WantedFunction wanted, double value) {
  if (!wanted.free) return wanted;
  const double datum = wanted.pairs.front().output;
  switch (wanted.free->kind) {
    case FreeParameter::Kind::output_scale:
      for (AnglePair& pair : wanted.pairs) {
        pair.output = datum + value * (pair.output - datum);
        for (AngleDerivative& derivative : pair.derivatives) derivative.output *= value;
      }
      if (wanted.function)
        for (double& end : wanted.function->output_range) end = datum + value * (end - datum);
      break;
    case FreeParameter::Kind::pair_output:
      wanted.pairs[wanted.free->pair].output = value;
      break;
  }
  wanted.free.reset();
  return wanted;
}

double FreeParameter::at(double t) const {
  const auto [low, high] = range;
  return kind == Kind::output_scale ? low * std::pow(high / low, t) : low + (high - low) * t;
}

double FreeParameter::place_of(double value) const {
  const auto [low, high] = range;
  return kind == Kind::output_scale ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::string_view name(FreeParameter::Kind kind) { return free_names[static_cast<std::size_t>(kind)]; }

}  // namespace linkwright
