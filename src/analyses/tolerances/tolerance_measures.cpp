#include <algorithm>
#include <cmath>
#include <limits>

#include "four_bar_errors.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "robust/tolerance_error.hpp"
#include "spherical_errors.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

/// How a linkage lies in the positions of its task, turns counted by the turning length.
std::optional<LinkageOutput> output_at(const LinkageFamily& family, MapPoint place, const Tolerances& tolerances) {
  auto output = family.output(place);
  if (!output) return std::nullopt;
  return with_turning_length(*std::move(output), tolerances.turning_length.value_or(0));
}

/// Infinite at a dead point.
double error_of(const LinkageOutput& output, const Tolerances& tolerances) {
  const auto error = first_order_error(output, tolerances);
  return error ? readable_error(output, *error) : std::numeric_limits<double>::infinity();
}

class OutputError : public CellMeasure {
 public:
  OutputError(const LinkageFamily& family, const Tolerances& tolerances)
      : CellMeasure(measures::tolerance_error), family_(family), tolerances_(tolerances) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    const auto output = output_at(family_, place, tolerances_);
    return output ? std::optional(error_of(*output, tolerances_)) : std::nullopt;
  }

  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    if (auto links = family_.four_bar_cells(map)) return four_bar_errors(std::move(links), map, tolerances_);
    if (const auto dyads = family_.spherical_cells(map)) return spherical_errors(*dyads, map, tolerances_);
    return [this, &map, output_of = family_.outputs_of(map)](std::size_t row, std::span<float> values) {
      for (std::size_t column = 0; column < values.size(); ++column) {
        const bool is_whole = map.type(map.index(row, column)) != LinkageType::degenerate;
        auto output = is_whole ? output_of(row, column) : std::nullopt;
        values[column] =
            output
                ? static_cast<float>(error_of(with_turning_length(*std::move(output), turning_length()), tolerances_))
                : 0.0F;
      }
    };
  }

 private:
  [[nodiscard]] double turning_length() const { return tolerances_.turning_length.value_or(0); }

  const LinkageFamily& family_;
  Tolerances tolerances_;
};

class OutputYield : public CellMeasure {
 public:
  OutputYield(const LinkageFamily& family, const Tolerances& tolerances)
      : CellMeasure(measures::yield), family_(family), tolerances_(tolerances) {
    if (const auto form = family.output_form()) sampler_.emplace(*form, tolerances);
  }

  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    const auto output = output_at(family_, place, tolerances_);
    if (!output) return std::nullopt;
    constexpr int one_thread = 1;
    const SampledErrors errors =
        sampler_ ? sampler_->errors_of(*output) : sample_errors(*output, tolerances_, one_thread);
    return errors.yield ? std::optional(errors.yield->share) : std::nullopt;
  }

 private:
  const LinkageFamily& family_;
  Tolerances tolerances_;
  std::optional<ToleranceSampler> sampler_;  ///< nothing where linkages differ in their dimensions
};

/// Of a linkage of a map: those listed are sampled as often as the tolerances say.
constexpr int map_samples = 1000;

/// By how much a yield by map_samples has to be above the one that is required, so that nearly all that do are met by
/// as many samples as the tolerances say; 0 where these are no more.
double margin_of_yield(double required, int samples) {
  constexpr double deviations = 2.5;
  if (!(required > 0) || samples <= map_samples) return 0;
  return std::min(deviations * std::sqrt(required * (1 - required) / map_samples), 1 - required);
}

}  // namespace

AddedMeasures tolerance_measures(const LinkageFamily& family, const Tolerances& tolerances, bool with_sampled) {
  using Cost = AddedMeasure::Cost;
  const Cost of_error = family.outputs_take_long() ? Cost::heavy : Cost::light;
  AddedMeasures added;
  added.all.push_back({.measure = std::make_shared<OutputError>(family, tolerances), .cost = of_error});
  if (!tolerances.limit || !with_sampled) return added;
  Tolerances coarse = tolerances;
  coarse.samples = std::min(tolerances.samples, map_samples);
  const auto margin_of = [samples = tolerances.samples](double required) { return margin_of_yield(required, samples); };
  added.all.push_back({.measure = std::make_shared<OutputYield>(family, coarse),
                       .cost = Cost::sampled,
                       .margin_of = margin_of,
                       .tie = &measures::tolerance_error});
  return added;
}

double readable_error(const LinkageOutput& output, double error) { return is_angle(output) ? degrees(error) : error; }

}  // namespace linkwright
