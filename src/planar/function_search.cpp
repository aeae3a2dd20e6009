#include "linkwright/planar/function_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/function_error.hpp"
#include "linkwright/region/hill_tops.hpp"
#include "planar/candidate.hpp"
#include "region/ordered_axes.hpp"

namespace linkwright {
namespace {

// Two linkages are alike when no pivot differs by more than this share of the ground link.
constexpr double alike = 0.02;

// The last word looks at every row of a table, the search at some.
constexpr int last_word = 181;
ErrorSampling sampling_of(int error_samples) {
  return {error_samples, error_samples < last_word ? ErrorSampling::coarse().max_rows : ErrorSampling::every_row};
}

struct Generator {
  RankedGenerator ranked;
  LinkageType type = LinkageType::degenerate;

  [[nodiscard]] double error() const { return ranked.max_structural_error; }
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
        evaluator_(family, requirements, Objective::min_transmission_angle, options.window),
        options_(options),
        inputs_(samples_within(family, Side::input, options.window, options.input_samples, Spacing::coordinate)),
        values_(samples_within(family, Side::output, options.window, options.free_samples, Spacing::coordinate)) {}

  [[nodiscard]] std::optional<Generator> at(MapPoint place, int error_samples) const {
    const auto candidate = evaluator_.candidate(place);
    if (!candidate) return std::nullopt;
    const FourBar bars = to_user(family_.frame(), candidate->bars);
    const FunctionError error = family_.error_of(bars, place, sampling_of(error_samples));
    if (!error.max_structural_error || !error.unreached.empty()) return std::nullopt;
    return Generator{{place, bars, *error.max_structural_error}, candidate->report.type};
  }

  /// The best cells of the grid that no neighbour of the same type betters, best first.
  [[nodiscard]] std::vector<Generator> hills(const Progress& progress) const {
    const std::size_t rows = inputs_.size(), columns = values_.size();
    std::vector<std::optional<Generator>> cells(rows * columns);
    parallel_for(cells.size(), options_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t cell = begin; cell < end && !progress.is_cancelled(); ++cell)
        cells[cell] = at({inputs_[cell / columns], values_[cell % columns]}, options_.error_samples);
    });
    const auto cell_at = [&](std::size_t row, std::size_t column) -> const std::optional<Generator>& {
      return cells[row * columns + column];
    };
    const auto score = [&](std::size_t row, std::size_t column) {
      const auto& cell = cell_at(row, column);
      return cell ? -cell->error() : no_score;
    };
    const auto same_type = [&](std::size_t row, std::size_t column, std::size_t other_row, std::size_t other_column) {
      return cell_at(row, column)->type == cell_at(other_row, other_column)->type;
    };
    const HillTopOptions tops = {1, 3 * static_cast<std::size_t>(options_.max_count), options_.threads};
    std::vector<Generator> found;
    for (const RankedCell& cell : hill_tops(rows, columns, tops, score, same_type))
      found.push_back(*cell_at(cell.row, cell.column));
    return found;
  }

  /// From there to the least error near, the type kept, found to that share of the grid's steps.
  [[nodiscard]] Generator climbed(const Generator& start, double resolution, const Progress& progress) const {
    const OrderedAxes axes(family_);
    const auto score_at = [&](double first, double second) -> std::optional<double> {
      const auto there = at(axes.place({first, second}), options_.error_samples);
      return there && there->type == start.type ? std::optional(-there->error()) : std::nullopt;
    };
    const MapPoint from = start.ranked.place;
    const std::array<double, 2> steps = axes.both(step(Side::input, inputs_), step(Side::output, values_));
    const HillTop top =
        climb_hill(axes.hill(score_at, from), axes.coordinates(from), -start.error(), {steps, resolution}, progress);
    return at(axes.place(top.place), options_.error_samples).value_or(start);
  }

 private:
  [[nodiscard]] double step(Side side, const std::vector<double>& samples) const {
    const MapAxis& axis = family_.axis(side);
    return axis.is_discrete() ? 0 : axis.coordinate_length() / static_cast<double>(samples.size());
  }

  const FunctionFamily& family_;
  CellEvaluator evaluator_;
  GeneratorSearchOptions options_;
  std::vector<double> inputs_, values_;
};

bool more_precise(const Generator& a, const Generator& b) {
  if (a.error() != b.error()) return a.error() < b.error();
  const MapPoint &x = a.ranked.place, &y = b.ranked.place;
  return x.input != y.input ? x.input < y.input : x.output < y.output;
}

bool are_alike(const FourBar& a, const FourBar& b) {
  const double most = alike * a.lengths().ground;
  return std::abs(a.input_circle - b.input_circle) < most && std::abs(a.output_circle - b.output_circle) < most;
}

/// The best of them, no two alike.
std::vector<Generator> distinct(std::vector<Generator> generators, std::size_t most) {
  std::sort(generators.begin(), generators.end(), more_precise);
  std::vector<Generator> held;
  for (const Generator& generator : generators) {
    const bool known = std::any_of(held.begin(), held.end(), [&](const Generator& other) {
      return are_alike(other.ranked.four_bar, generator.ranked.four_bar);
    });
    if (!known && held.size() < most) held.push_back(generator);
  }
  return held;
}

// Resolution of a climb that tells which hill is the lower, and of the one that makes the numbers exact.
constexpr double coarse_resolution = 1e-2, fine_resolution = 1e-7;

}  // namespace

std::vector<RankedGenerator> best_generators(const FunctionFamily& family, const Requirements& requirements,
                                             const GeneratorSearchOptions& options, const Progress& progress) {
  if (!family.task_at({}).function || options.max_count <= 0) return {};
  const GeneratorSearch search(family, requirements, options);
  const auto most = static_cast<std::size_t>(options.max_count);
  const auto climbed = [&](std::vector<Generator> hills, double resolution) {
    parallel_for(hills.size(), options.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i)
        hills[i] = search.climbed(hills[i], resolution, progress);
    });
    return distinct(std::move(hills), most);
  };
  std::vector<Generator> best = climbed(climbed(search.hills(progress), coarse_resolution), fine_resolution);
  if (progress.is_cancelled()) return {};
  for (Generator& generator : best)
    if (const auto exact = search.at(generator.ranked.place, last_word)) generator = *exact;
  std::sort(best.begin(), best.end(), more_precise);
  std::vector<RankedGenerator> ranked;
  for (const Generator& generator : best) ranked.push_back(generator.ranked);
  return ranked;
}

std::optional<MapPoint> improved_generator(const FunctionFamily& family, const Requirements& requirements,
                                           MapPoint start) {
  const GeneratorSearch search(family, requirements, {});
  const auto foot = search.at(start, GeneratorSearchOptions{}.error_samples);
  if (!foot) return std::nullopt;
  const Generator top = search.climbed(*foot, fine_resolution, {});
  return top.error() < foot->error() ? std::optional(top.ranked.place) : std::nullopt;
}

}  // namespace linkwright
