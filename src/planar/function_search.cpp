#include "linkwright/planar/function_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/function_error.hpp"
#include "planar/candidate.hpp"

namespace linkwright {
namespace {

using Side = LinkageFamily::Side;

// Two linkages are alike when no pivot differs by more than this share of the ground link.
constexpr double alike = 0.02;

struct Generator {
  RankedGenerator ranked;
  LinkageType type = LinkageType::degenerate;
};

FourBar to_user(const WorkingFrame& frame, const FourBar& bars) {
  return {frame.to_user(bars.input_center), frame.to_user(bars.input_circle), frame.to_user(bars.output_center),
          frame.to_user(bars.output_circle)};
}

/// The grid, and what stands at any place.
class GeneratorSearch {
 public:
  GeneratorSearch(const FunctionFamily& family, const Requirements& requirements, const GeneratorSearchOptions& options)
      : family_(family),
        judge_(family, requirements, Objective::min_transmission_angle, options.window),
        options_(options),
        inputs_(samples_within(family, Side::input, options.window, options.input_samples, Spacing::coordinate)),
        values_(samples_within(family, Side::output, options.window, options.free_samples, Spacing::coordinate)) {}

  [[nodiscard]] std::optional<Generator> at(RegionPlace place, int error_samples) const {
    const auto candidate = judge_.candidate(place);
    if (!candidate) return std::nullopt;
    const FourBar bars = to_user(family_.frame(), candidate->bars);
    const FunctionError error = function_error(bars, family_.task_at(place), error_samples);
    if (!error.max_structural_error || !error.unreached.empty()) return std::nullopt;
    return Generator{{place, bars, *error.max_structural_error}, candidate->report.type};
  }

  /// Cells of the grid that none of the eight around betters.
  [[nodiscard]] std::vector<Generator> hills(const Progress& progress) const {
    std::vector<std::optional<Generator>> cells;
    for (const double input : inputs_)
      for (const double value : values_) {
        if (progress.is_cancelled()) return {};
        cells.push_back(at({input, value}, options_.error_samples));
      }
    std::vector<Generator> found;
    for (std::size_t row = 0; row < inputs_.size(); ++row)
      for (std::size_t column = 0; column < values_.size(); ++column)
        if (const auto& cell = cells[row * values_.size() + column]; cell && is_top(cells, row, column, *cell))
          found.push_back(*cell);
    return found;
  }

  /// For each value of the free number the best place on the curve is sought: the largest error is the largest of
  /// several smooth functions, on whose ridges steps in fixed directions get stuck.
  [[nodiscard]] Generator climbed(const Generator& start) const {
    Generator best = along_curve(start, start.ranked.place.output, input_step());
    if (values_.size() == 1) return best;
    const double first = 1.0 / static_cast<double>(values_.size());
    for (double step = first; step > 1e-5;) {
      const double before = best.ranked.max_structural_error, from = best.ranked.place.output;
      for (const double value : {from + step, from - step}) {
        if (value < 0 || value >= 1) continue;
        const Generator tried = along_curve(best, value, input_step());
        if (tried.ranked.max_structural_error < best.ranked.max_structural_error) best = tried;
      }
      if (best.ranked.max_structural_error >= before) step *= 0.4;
    }
    return best;
  }

 private:
  [[nodiscard]] double input_step() const {
    return family_.axis(Side::input).coordinate_length() / static_cast<double>(inputs_.size());
  }

  [[nodiscard]] bool is_top(const std::vector<std::optional<Generator>>& cells, std::size_t row, std::size_t column,
                            const Generator& here) const {
    const std::size_t row_end = std::min(row + 2, inputs_.size()), column_end = std::min(column + 2, values_.size());
    for (std::size_t i = row > 0 ? row - 1 : 0; i < row_end; ++i)
      for (std::size_t k = column > 0 ? column - 1 : 0; k < column_end; ++k) {
        const auto& other = cells[i * values_.size() + k];
        if (other && other->type == here.type && other->ranked.max_structural_error < here.ranked.max_structural_error)
          return false;
      }
    return true;
  }

  /// The best place along the curve near the start's, the free number at `value`; the start where there is none.
  [[nodiscard]] Generator along_curve(const Generator& start, double value, double first_step) const {
    Generator best = start;
    const bool moved = value != start.ranked.place.output;
    bool found = !moved;
    if (moved)
      if (const auto there = allowed({start.ranked.place.input, value}, start.type)) {
        best = *there;
        found = true;
      }
    if (!found || family_.axis(Side::input).is_discrete()) return found ? best : start;
    for (double step = first_step; step > 1e-9;) {
      const double before = best.ranked.max_structural_error, from = best.ranked.place.input;
      for (const double input : {on_branch(start, from + step), on_branch(start, from - step)})
        if (const auto there = allowed({input, value}, start.type);
            there && there->ranked.max_structural_error < best.ranked.max_structural_error)
          best = *there;
      step *= best.ranked.max_structural_error < before ? 1.5 : 0.4;
    }
    return best;
  }

  /// Leaving a closed branch at its end is entering it at its beginning.
  [[nodiscard]] static double on_branch(const Generator& start, double tau) {
    const double branch = std::floor(start.ranked.place.input);
    return branch + wrap_period(tau - branch, 1);
  }

  [[nodiscard]] std::optional<Generator> allowed(RegionPlace place, LinkageType type) const {
    const auto there = at(place, options_.error_samples);
    return there && there->type == type ? there : std::nullopt;
  }

  const FunctionFamily& family_;
  Judge judge_;
  GeneratorSearchOptions options_;
  std::vector<double> inputs_, values_;
};

bool better(const Generator& a, const Generator& b) {
  const RankedGenerator &x = a.ranked, &y = b.ranked;
  if (x.max_structural_error != y.max_structural_error) return x.max_structural_error < y.max_structural_error;
  return x.place.input != y.place.input ? x.place.input < y.place.input : x.place.output < y.place.output;
}

bool are_alike(const FourBar& a, const FourBar& b) {
  const double most = alike * a.lengths().ground;
  return std::abs(a.input_circle - b.input_circle) < most && std::abs(a.output_circle - b.output_circle) < most;
}

}  // namespace

std::vector<RankedGenerator> best_generators(const FunctionFamily& family, const Requirements& requirements,
                                             const GeneratorSearchOptions& options, const Progress& progress) {
  if (!family.task_at({}).function || options.most <= 0) return {};
  const GeneratorSearch search(family, requirements, options);
  std::vector<Generator> hills = search.hills(progress);
  std::sort(hills.begin(), hills.end(), better);
  hills.resize(std::min(hills.size(), 3 * static_cast<std::size_t>(options.most)));
  for (Generator& hill : hills) {
    if (progress.is_cancelled()) return {};
    constexpr int last_word = 181;
    hill = search.climbed(hill);
    if (const auto exact = search.at(hill.ranked.place, last_word)) hill = *exact;
  }
  std::sort(hills.begin(), hills.end(), better);
  std::vector<RankedGenerator> ranked;
  for (const Generator& hill : hills) {
    const bool known = std::any_of(ranked.begin(), ranked.end(), [&](const RankedGenerator& other) {
      return are_alike(other.four_bar, hill.ranked.four_bar);
    });
    if (!known && static_cast<int>(ranked.size()) < options.most) ranked.push_back(hill.ranked);
  }
  return ranked;
}

std::optional<RegionPlace> improved_generator(const FunctionFamily& family, const Requirements& requirements,
                                              RegionPlace start) {
  const GeneratorSearch search(family, requirements, {});
  const auto foot = search.at(start, GeneratorSearchOptions{}.error_samples);
  if (!foot) return std::nullopt;
  const Generator top = search.climbed(*foot);
  const bool better = top.ranked.max_structural_error < foot->ranked.max_structural_error;
  return better ? std::optional(top.ranked.place) : std::nullopt;
}

}  // namespace linkwright
