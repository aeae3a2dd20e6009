#include "linkwright/attitude/hartenberg_denavit.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

namespace linkwright {
namespace {

/// The name of the first parameter that is not finite.
std::optional<std::string> not_finite(const HartenbergDenavit& link) {
  const std::array<std::pair<double, const char*>, 4> parameters{
      {{link.theta, "theta"}, {link.d, "d"}, {link.a, "a"}, {link.alpha, "alpha"}}};
  for (const auto& [value, name] : parameters)
    if (!std::isfinite(value)) return name;
  return std::nullopt;
}

Error not_finite_error(std::string place) {
  return {"not_finite", std::move(place), "not a number or infinite: give a finite number"};
}

/// Rz(θ) Rx(α) and (a cos θ, a sin θ, d), or Rx(α) Rz(θ) and (a, −d sin α, d cos α).
Displacement transform(const HartenbergDenavit& link, HartenbergDenavitForm form) {
  const Rotation about_z = Rotation::about_z(link.theta), about_x = Rotation::about_x(link.alpha);
  if (form == HartenbergDenavitForm::classic)
    return {about_z * about_x, about_z.apply({link.a, 0, 0}) + Vector3{0, 0, link.d}};
  return {about_x * about_z, about_x.apply({0, 0, link.d}) + Vector3{link.a, 0, 0}};
}

}  // namespace

Result<Displacement> hartenberg_denavit(const HartenbergDenavit& link, HartenbergDenavitForm form) {
  if (const auto name = not_finite(link)) return not_finite_error(*name);
  return transform(link, form);
}

Result<std::vector<Displacement>> hartenberg_denavit_frames(std::span<const HartenbergDenavit> links,
                                                            HartenbergDenavitForm form) {
  std::vector<Displacement> frames;
  frames.reserve(links.size());
  Displacement pose;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (const auto name = not_finite(links[i])) return not_finite_error(fmt::format("links[{}].{}", i, *name));
    pose = pose * transform(links[i], form);
    if (!is_finite(pose.translation)) return not_finite_error(fmt::format("links[{}]", i));
    frames.push_back(pose);
  }
  return frames;
}

Result<Displacement> hartenberg_denavit_chain(std::span<const HartenbergDenavit> links, HartenbergDenavitForm form) {
  const Result<std::vector<Displacement>> frames = hartenberg_denavit_frames(links, form);
  if (!frames) return frames.errors();
  return frames->empty() ? Displacement{} : frames->back();
}

Result<HartenbergDenavitFit> hartenberg_denavit_of(const Displacement& t_ij, HartenbergDenavitForm form) {
  const Matrix3x3& c = t_ij.rotation.matrix();
  const Vector3 t = t_ij.translation;
  if (!is_finite(c) || !is_finite(t)) return not_finite_error("displacement");
  HartenbergDenavitFit fit;
  HartenbergDenavit& link = fit.link;
  if (form == HartenbergDenavitForm::classic) {
    link.theta = std::atan2(c(1, 0), c(0, 0));
    link.alpha = std::atan2(c(2, 1), c(2, 2));
    const Vector3 in_turned = Rotation::about_z(link.theta).apply_inverse(t);
    link.a = in_turned.x;
    link.d = in_turned.z;
    fit.angle_defect = std::fabs(c(2, 0));
    fit.distance_defect = std::fabs(in_turned.y);
  } else {
    link.theta = std::atan2(-c(0, 1), c(0, 0));
    link.alpha = std::atan2(-c(1, 2), c(2, 2));
    const Vector3 in_turned = Rotation::about_x(link.alpha).apply_inverse(t);
    link.a = in_turned.x;
    link.d = in_turned.z;
    fit.angle_defect = std::fabs(c(0, 2));
    fit.distance_defect = std::fabs(in_turned.y);
  }
  return fit;
}

}  // namespace linkwright
