#include "generator_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "linkwright/core/parallel.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "region/climb.hpp"
#include "region/ordered_axes.hpp"

namespace linkwright {
namespace {

// The last word looks at every row of a table, the search at some.
constexpr int last_word = 181;
ErrorSampling sampling_of(int error_samples) {
  return {error_samples, error_samples < last_word ? ErrorSampling::coarse().max_rows : ErrorSampling::every_row};
}

/// The grid, and what stands at any place.
class GeneratorSearch {
 public:
  GeneratorSearch(const GeneratorFamily& family, const Requirements& requirements,
                  const GeneratorSearchOptions& options)
      : generators_(family),
        family_(family.linkage_family()),
        evaluator_(family_, requirements, Objective::min_transmission_angle, options.window, options.added),
        options_(options),
        inputs_(samples_within(family_, Side::input, options.window, options.input_samples, Spacing::coordinate)),
        values_(samples_within(family_, Side::output, options.window, options.free_samples, Spacing::coordinate)) {}

  [[nodiscard]] std::optional<RankedGenerator> at(MapPoint place, int error_samples) const {
    const auto found = evaluator_.candidate(place);
    if (!found) return std::nullopt;
    const Cell& cell = found->cell;
    const FunctionError error = generators_.error_of(cell.pivots, place, sampling_of(error_samples));
    if (!error.max_structural_error || !error.unreached.empty()) return std::nullopt;
    return RankedGenerator{place, cell.type, cell.pivots, *error.max_structural_error};
  }

  /// The best cells of the grid that no neighbour of the same type betters, best first.
  [[nodiscard]] std::vector<RankedGenerator> hills(const Progress& progress) const {
    const std::size_t rows = inputs_.size(), columns = values_.size();
    std::vector<std::optional<RankedGenerator>> cells(rows * columns);
    parallel_for(cells.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t cell = begin; cell < end && !progress.is_cancelled(); ++cell)
        cells[cell] = at({inputs_[cell / columns], values_[cell % columns]}, options_.error_samples);
    });
    const auto cell_at = [&](std::size_t row, std::size_t column) -> const std::optional<RankedGenerator>& {
      return cells[row * columns + column];
    };
    const auto score = [&](std::size_t row, std::size_t column) {
      const auto& cell = cell_at(row, column);
      return cell ? -cell->max_structural_error : no_score;
    };
    const auto same_type = [&](std::size_t row, std::size_t column, std::size_t other_row, std::size_t other_column) {
      return cell_at(row, column)->type == cell_at(other_row, other_column)->type;
    };
    const HillTopOptions tops = {1, 3 * static_cast<std::size_t>(options_.max_count), options_.threads};
    std::vector<RankedGenerator> found;
    for (const RankedCell& cell : hill_tops(rows, columns, tops, score, same_type))
      found.push_back(*cell_at(cell.row, cell.column));
    for (const MapPoint start : options_.starts)
      if (const auto known = at(start, options_.error_samples)) found.push_back(*known);
    return found;
  }

  /// From there to the least error near, the type kept, found to that share of the grid's steps.
  [[nodiscard]] RankedGenerator climbed(const RankedGenerator& start, double resolution,
                                        const Progress& progress) const {
    const OrderedAxes axes(family_);
    const auto score_at = [&](double first, double second) -> std::optional<double> {
      const auto there = at(axes.place({first, second}), options_.error_samples);
      return there && there->type == start.type ? std::optional(-there->max_structural_error) : std::nullopt;
    };
    const MapPoint from = start.place;
    const std::array<double, 2> steps = axes.both(step(Side::input, inputs_), step(Side::output, values_));
    const HillTop top = climb_hill(axes.hill(score_at, from), axes.coordinates(from), -start.max_structural_error,
                                   {steps, resolution}, progress);
    return at(axes.place(top.place), options_.error_samples).value_or(start);
  }

 private:
  [[nodiscard]] double step(Side side, const std::vector<double>& samples) const {
    const MapAxis& axis = family_.axis(side);
    return axis.is_discrete() ? 0 : axis.coordinate_length() / static_cast<double>(samples.size());
  }

  const GeneratorFamily& generators_;
  const LinkageFamily& family_;
  Evaluator evaluator_;
  GeneratorSearchOptions options_;
  std::vector<double> inputs_, values_;
};

bool more_precise(const RankedGenerator& a, const RankedGenerator& b) {
  if (a.max_structural_error != b.max_structural_error) return a.max_structural_error < b.max_structural_error;
  const MapPoint &x = a.place, &y = b.place;
  return x.input != y.input ? x.input < y.input : x.output < y.output;
}

/// The best of them, no two alike.
std::vector<RankedGenerator> distinct(const GeneratorFamily& family, std::vector<RankedGenerator> generators,
                                      std::size_t most) {
  std::sort(generators.begin(), generators.end(), more_precise);
  std::vector<RankedGenerator> held;
  for (const RankedGenerator& generator : generators) {
    const bool known = std::any_of(held.begin(), held.end(), [&](const RankedGenerator& other) {
      return family.are_alike(other.hinges, generator.hinges);
    });
    if (!known && held.size() < most) held.push_back(generator);
  }
  return held;
}

// Resolution of a climb that tells which hill is the lower, and of the one that makes the numbers exact.
constexpr double coarse_resolution = 1e-2, fine_resolution = 1e-7;

}  // namespace

std::vector<RankedGenerator> best_generators(const GeneratorFamily& family, const Requirements& requirements,
                                             const GeneratorSearchOptions& options, const Progress& progress) {
  if (options.max_count <= 0) return {};
  const GeneratorSearch search(family, requirements, options);
  const auto most = static_cast<std::size_t>(options.max_count);
  const auto climbed = [&](std::vector<RankedGenerator> hills, double resolution) {
    parallel_for(hills.size(), options.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i)
        hills[i] = search.climbed(hills[i], resolution, progress);
    });
    return distinct(family, std::move(hills), most);
  };
  std::vector<RankedGenerator> best = climbed(climbed(search.hills(progress), coarse_resolution), fine_resolution);
  if (progress.is_cancelled()) return {};
  for (RankedGenerator& generator : best)
    if (const auto exact = search.at(generator.place, last_word)) generator = *exact;
  std::sort(best.begin(), best.end(), more_precise);
  return best;
}

std::optional<MapPoint> improved_generator(const GeneratorFamily& family, const Requirements& requirements,
                                           MapPoint start, const AddedMeasures& added) {
  GeneratorSearchOptions options;
  options.added = added;
  const GeneratorSearch search(family, requirements, options);
  const auto foot = search.at(start, GeneratorSearchOptions{}.error_samples);
  if (!foot) return std::nullopt;
  const RankedGenerator top = search.climbed(*foot, fine_resolution, {});
  return top.max_structural_error < foot->max_structural_error ? std::optional(top.place) : std::nullopt;
}

}  // namespace linkwright
