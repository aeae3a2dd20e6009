#include "pivot_path_family.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double shares_of_diagonal = 0.5;  // half of the places lie as near to the middle of the points, each way

MapAxis plane_axis(AxisQuantity quantity) { return {quantity, {{"range", 0, 1}}}; }

Point middle_of(std::span<const Point> points) {
  Point sum{};
  for (const Point p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

PivotPathFamily::PivotPathFamily(const NearestTarget& near, const CurveFitOptions& fit, std::span<const CurveFit> known,
                                 const Progress& progress)
    : FittedPathFamily(near, fit.measure, plane_axis(AxisQuantity::center_y), plane_axis(AxisQuantity::center_x)) {
  constexpr int nodes = 16;
  const Point middle = middle_of(near.target.points);
  const double spread = shares_of_diagonal * near.target.diagonal();
  ranges_ = {PivotRange{middle.real(), spread}, PivotRange{middle.imag(), spread}};
  std::vector<Point> lattice;
  for (int row = 0; row < nodes; ++row)
    for (int column = 0; column < nodes; ++column)
      lattice.push_back(pivot_at({(row + 0.5) / nodes, (column + 0.5) / nodes}));
  fits_ = std::make_unique<const PivotFits>(near.target, fit, lattice, known, progress);
  for (const CurveFit& one : known) {
    const Point pivot = one.linkage().bars.input_fixed;
    known_.push_back({ranges_[1].coordinate_of(pivot.imag()), ranges_[0].coordinate_of(pivot.real())});
  }
}

double PivotPathFamily::axis_value(Side side, double tau) const {
  return side == Side::output ? ranges_[0].at(tau) : ranges_[1].at(tau);
}

std::vector<double> PivotPathFamily::samples(Side side, int count, Spacing spacing) const {
  return FittedPathFamily::samples(side, std::min(count, most_samples_over_pivots), spacing);
}

Point PivotPathFamily::pivot_at(MapPoint place) const {
  return {ranges_[0].at(place.output), ranges_[1].at(place.input)};
}

std::optional<FittedPathFamily::Traced> PivotPathFamily::traced_at(MapPoint place) const {
  constexpr std::size_t most_kept = 64;
  const Point pivot = pivot_at(place);
  if (!(place.input > 0 && place.input < 1 && place.output > 0 && place.output < 1) || !is_finite(pivot))
    return std::nullopt;
  const auto answer = [](const std::shared_ptr<const CurveFit>& fit) {
    return fit ? std::optional(Traced{fit, 0}) : std::nullopt;
  };
  const std::pair key{place.input, place.output};
  {
    const std::lock_guard lock(recent_.using_it);
    if (const auto known = recent_.fits.find(key); known != recent_.fits.end()) return answer(known->second);
  }
  const auto found = fits_->at(pivot);
  const auto fit = found ? std::make_shared<const CurveFit>(*found) : nullptr;
  const std::lock_guard lock(recent_.using_it);
  if (recent_.fits.emplace(key, fit).second) {
    if (recent_.order.size() < most_kept) {
      recent_.order.push_back(key);
    } else {
      recent_.fits.erase(std::exchange(recent_.order[recent_.next], key));
      recent_.next = (recent_.next + 1) % most_kept;
    }
  }
  return answer(fit);
}

}  // namespace linkwright
