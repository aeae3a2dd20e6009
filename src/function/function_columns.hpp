#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// The map's axis of a free parameter; of nothing: one place.
[[nodiscard]] MapAxis axis_of(const std::optional<FreeParameter>& free);
/// What people read there: the factor, degrees.
[[nodiscard]] double axis_value_of(const std::optional<FreeParameter>& free, double tau);

/// The columns of the map of a function: pairs and couplers at each place τ of the free parameter, where there is one,
/// otherwise the same everywhere. `Couplers` has a `curve` (null where there is none) with branches() and
/// coordinate_length(), or `points`.
template <class Couplers>
class FunctionColumns {
 public:
  struct Column {
    std::vector<AnglePair> pairs;
    std::shared_ptr<const Couplers> couplers;
  };
  using Finder = std::function<Couplers(const std::vector<AnglePair>& pairs)>;

  /// `wanted` without mistakes, `couplers` those of its pairs; `find` is called from several threads.
  FunctionColumns(const WantedFunction& wanted, std::shared_ptr<const Couplers> couplers, Finder find)
      : wanted_{wanted.pairs, std::nullopt, wanted.free},
        scaled_function_(wanted.function ? std::optional(ScaledFunction(*wanted.function)) : std::nullopt),
        couplers_(std::move(couplers)),
        find_(std::move(find)) {}

  [[nodiscard]] const std::optional<FreeParameter>& free() const { return wanted_.free; }
  [[nodiscard]] const std::vector<AnglePair>& pairs() const { return wanted_.pairs; }
  [[nodiscard]] const Couplers& couplers() const { return *couplers_; }
  [[nodiscard]] bool has_function() const { return scaled_function_.has_value(); }

  /// Value of the free parameter, which there is.
  [[nodiscard]] double value_at(double tau) const { return wanted_.free->at(wrap_period(tau, 1)); }
  [[nodiscard]] std::vector<AnglePair> pairs_at(double tau) const {
    return wanted_.free ? wanted_at(wanted_, value_at(tau)).pairs : wanted_.pairs;
  }

  [[nodiscard]] Column at(double tau) const {
    if (!wanted_.free) return {wanted_.pairs, couplers_};
    std::vector<AnglePair> pairs = pairs_at(tau);
    auto couplers = std::make_shared<const Couplers>(find_(pairs));
    return {std::move(pairs), std::move(couplers)};
  }

  /// The same, kept for a while: a climb asks for the same column again and again, and each takes as long as a hundred
  /// linkages of it.
  [[nodiscard]] Column recent_at(double tau) const {
    if (!wanted_.free) return at(tau);
    const std::size_t place = std::hash<double>{}(tau) % recent_.size();
    {
      const std::lock_guard lock(using_);
      if (const auto& kept = recent_[place]; kept && kept->first == tau) return kept->second;
    }
    Column column = at(tau);
    const std::lock_guard lock(using_);
    recent_[place] = std::pair(tau, column);
    return column;
  }

  /// Where `progress` was cancelled, the column at 0 again and again.
  [[nodiscard]] std::vector<Column> along(std::span<const double> tau, int threads,
                                          const Progress& progress = {}) const {
    std::vector<Column> columns(tau.size());
    parallel_for(tau.size(), wanted_.free ? threads : 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end && !progress.is_cancelled(); ++k) columns[k] = at(tau[k]);
    });
    if (progress.is_cancelled()) columns.assign(tau.size(), at(0));
    return columns;
  }

  /// The axis along the couplers. Where the free parameter changes the number of the curve's branches, it has the most
  /// that occur.
  [[nodiscard]] MapAxis coupler_axis() const {
    if (!couplers_->curve) {
      MapAxis axis{AxisQuantity::burmester_point, {}};
      for (std::size_t i = 0; i < couplers_->points.size(); ++i)
        axis.branches.push_back({"point", static_cast<double>(i), static_cast<double>(i + 1)});
      return axis;
    }
    constexpr int looks_along_the_range = 33;
    MapAxis axis{AxisQuantity::curve_coordinate, couplers_->curve->branches()};
    for (int i = 0; wanted_.free && i < looks_along_the_range; ++i) {
      const Column there = at((i + 0.5) / looks_along_the_range);
      if (there.couplers->curve && there.couplers->curve->coordinate_length() > axis.coordinate_length())
        axis.branches = there.couplers->curve->branches();
    }
    return axis;
  }

  /// How well the linkage of a column generates its pairs and the named function; `generated_from(first)` is what it
  /// generates, standing at the first pair.
  template <class GeneratedFrom>
  [[nodiscard]] FunctionError error_of(const GeneratedFrom& generated_from, double tau,
                                       const ErrorSampling& sampling) const {
    const std::vector<AnglePair> pairs = pairs_at(tau);
    const GeneratedFunction generated = generated_from(pairs.front());
    if (!scaled_function_ || !wanted_.free || wanted_.free->kind != FreeParameter::Kind::output_scale)
      return function_error(generated, pairs, scaled_function_ ? &*scaled_function_ : nullptr, sampling);
    const ScaledFunction stretched = scaled_function_->stretched(pairs.front().output, value_at(tau));
    return function_error(generated, pairs, &stretched, sampling);
  }

 private:
  WantedFunction wanted_;  ///< without its function, whose table may be long
  std::optional<ScaledFunction> scaled_function_;
  std::shared_ptr<const Couplers> couplers_;
  Finder find_;
  mutable std::mutex using_;
  mutable std::array<std::optional<std::pair<double, Column>>, 256> recent_;
};

}  // namespace linkwright
