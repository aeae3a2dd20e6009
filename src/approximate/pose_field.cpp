#include "approximate/pose_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr std::size_t rings = 40, rays = 72;

// c0 + c1 x + c2 y.
using Affine = std::array<double, 3>;

double value_at(const std::array<double, 6>& c, Point z) {
  const double x = z.real(), y = z.imag();
  return c[0] + x * (c[1] + c[3] * x + c[4] * y) + y * (c[2] + c[5] * y);
}

// The plane on the disc of radius 1.
Point on_disc(Point z) { return z / (1 + std::abs(z)); }

// q, X and Y of a pose.
std::array<Affine, 3> affine_of(const BodyPose& pose) {
  const Point d = pose.origin, r = pose.axis, turned = product(std::conj(d), r);
  return {{{std::norm(d), 2 * turned.real(), -2 * turned.imag()},
           {d.real(), r.real(), -r.imag()},
           {d.imag(), r.imag(), r.real()}}};
}

}  // namespace

PoseField::PoseField(std::span<const BodyPose> poses, std::span<const double> weights) {
  double sum = 0;
  std::array<Affine, 3> mean{};
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const auto here = affine_of(poses[j]);
    sum += weights[j];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) mean[k][i] += weights[j] * here[k][i];
  }
  for (Affine& of : mean)
    for (double& c : of) c /= sum;
  constexpr std::array<std::array<std::size_t, 2>, 6> entries = {{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  for (std::size_t j = 0; j < poses.size(); ++j) {
    auto here = affine_of(poses[j]);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) here[k][i] -= mean[k][i];
    const double share = weights[j] / sum;
    for (std::size_t entry = 0; entry < entries.size(); ++entry) {
      const Affine &f = here[entries[entry][0]], &g = here[entries[entry][1]];
      const Quadratic terms = {f[0] * g[0], f[0] * g[1] + f[1] * g[0], f[0] * g[2] + f[2] * g[0],
                               f[1] * g[1], f[1] * g[2] + f[2] * g[1], f[2] * g[2]};
      for (std::size_t i = 0; i < terms.size(); ++i) scatter_[entry][i] += share * terms[i];
    }
  }
  mean_square_origin_ = mean[0][0];
  mean_turned_ = {mean[0][1] / 2, -mean[0][2] / 2};
  mean_origin_ = {mean[1][0], mean[2][0]};
  mean_axis_ = {mean[1][1], mean[2][1]};
}

PoseField::Scatter PoseField::scatter(Point z) const {
  return {value_at(scatter_[0], z), value_at(scatter_[1], z), value_at(scatter_[2], z),
          value_at(scatter_[3], z), value_at(scatter_[4], z), value_at(scatter_[5], z)};
}

BodyDyad PoseField::dyad(Point z) const {
  const Scatter s = scatter(z);
  const double two = s.two();
  const Point center{0.5 * (s.yy * s.qx - s.xy * s.qy) / two, 0.5 * (s.xx * s.qy - s.xy * s.qx) / two};
  const Point mean = mean_origin_ + product(mean_axis_, z);
  const double mean_q = mean_square_origin_ + 2 * product(mean_turned_, z).real() + std::norm(z);
  const double radius = std::sqrt(std::max(mean_q - 2 * linkwright::dot(center, mean) + std::norm(center), 0.0));
  return {z, center, radius, std::sqrt(std::max(s.three() / two, 0.0)) / (2 * radius)};
}

double PoseField::mean_square(Point z) const {
  const BodyDyad found = dyad(z);
  const double square = found.error * found.error;
  return std::isfinite(square) ? square : std::numeric_limits<double>::infinity();
}

std::vector<PoseField::GridPlace> PoseField::grid() const {
  std::vector<GridPlace> places;
  places.reserve(rings * rays);
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const double on_disc = (static_cast<double>(ring) + 0.5) / rings, radius = on_disc / (1 - on_disc);
    for (std::size_t ray = 0; ray < rays; ++ray) {
      const Point z = radius * direction(two_pi * static_cast<double>(ray) / rays);
      places.push_back({z, mean_square(z)});
    }
  }
  return places;
}

// Damped Newton steps, the derivatives by differences: what is looked for are places to start from.
Point PoseField::descended(Point z) const {
  constexpr int most_steps = 25;
  constexpr double there = 1e-7;
  double value = mean_square(z), damping = 1e-2;
  for (int step = 0; step < most_steps && damping < 1e8; ++step) {
    const double h = 1e-4 * (1 + std::abs(z));
    const auto v = [&](double x, double y) { return mean_square(z + Point{h * x, h * y}); };
    const double east = v(1, 0), west = v(-1, 0), north = v(0, 1), south = v(0, -1);
    const double gx = 0.5 * (east - west), gy = 0.5 * (north - south);
    const double xx = east + west - 2 * value, yy = north + south - 2 * value;
    const double xy = 0.25 * (v(1, 1) - v(1, -1) - v(-1, 1) + v(-1, -1));
    const double turn = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy), least = 0.5 * (xx + yy) - turn;
    const double shift = std::max(-1.1 * least, 0.0) + damping * (std::abs(xx) + std::abs(yy)) + 1e-300;
    const double det = (xx + shift) * (yy + shift) - xy * xy;
    const Point by = h / det * Point{xy * gy - (yy + shift) * gx, xy * gx - (xx + shift) * gy};
    const double now = std::isfinite(std::norm(by)) ? mean_square(z + by) : value;
    const bool lower = now < value;
    damping *= lower ? 0.2 : 8;
    if (!lower) continue;
    z += by;
    value = now;
    if (std::abs(by) < there * (1 + std::abs(z))) break;
  }
  return z;
}

std::vector<Point> PoseField::minima() const {
  const std::vector<GridPlace> places = grid();
  const auto value = [&](std::size_t ring, std::size_t ray) { return places[ring * rays + ray % rays].value; };
  std::vector<GridPlace> found;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t ray = 0; ray < rays; ++ray) {
      const double here = value(ring, ray);
      bool least = std::isfinite(here);
      for (std::size_t r = ring == 0 ? 0 : ring - 1; r <= std::min(ring + 1, rings - 1); ++r)
        for (const std::size_t k : {ray + rays - 1, ray, ray + 1}) least = least && here <= value(r, k);
      if (!least) continue;
      const Point z = descended(places[ring * rays + ray].z);
      constexpr double same = 1e-3;
      const auto is_same = [&](const GridPlace& known) { return std::abs(on_disc(known.z) - on_disc(z)) < same; };
      if (std::none_of(found.begin(), found.end(), is_same)) found.push_back({z, mean_square(z)});
    }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  std::vector<Point> minima;
  for (const GridPlace& place : found) minima.push_back(place.z);
  return minima;
}

std::vector<Point> PoseField::valleys(std::size_t count) const {
  constexpr double apart = 0.05;  // on the disc
  constexpr double farthest = 6;  // beyond it valleys are those of straight lines, and all but one
  std::vector<GridPlace> places = grid();
  // Far from the body an error matters the less, the body being turned the less by it.
  for (GridPlace& place : places) place.value /= 1 + 0.5 * std::norm(place.z);
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  std::vector<Point> chosen;
  for (const GridPlace& place : places) {
    if (chosen.size() == count || !std::isfinite(place.value)) break;
    if (std::abs(place.z) > farthest) continue;
    const auto is_near = [&](Point other) { return std::abs(on_disc(other) - on_disc(place.z)) < apart; };
    if (std::none_of(chosen.begin(), chosen.end(), is_near)) chosen.push_back(place.z);
  }
  return chosen;
}

}  // namespace linkwright
