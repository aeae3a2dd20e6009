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

/// A frame of a joint: z in its line.
Displacement joint_frame(Vector3 origin, Vector3 x, Vector3 z) {
  const Vector3 along = normalized(x - dot(x, z) * z);  // to the last digit at a right angle to z
  return {*Rotation::from_matrix(Matrix3x3::of_columns(along, cross(z, along), z)), origin};
}

/// Where the line k leaves for the next, given the normal by which the one before came.
Result<CommonNormal> normal_from(std::span<const Line> axes, std::size_t k, const CommonNormal& before) {
  const Vector3 start = k == 0 ? axes[0].point : before.foot_on_second;
  if (k + 1 == axes.size()) return CommonNormal{.direction = before.direction, .foot_on_first = start};
  Result<CommonNormal> normal = common_normal({start, axes[k].direction}, axes[k + 1]);
  if (normal && normal->lines == LinePair::coincident && k > 0) normal->direction = before.direction;
  return normal;
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

Result<LinkChain> hartenberg_denavit_of_axes(std::span<const Line> axes) {
  if (axes.empty()) return Error{"no_axes", "axes", "there is no axis: give the line of at least one joint"};
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (auto mistake = mistake_in(axes[k], fmt::format("axes[{}]", k))) return *mistake;
  LinkChain chain;
  CommonNormal normal{.direction = any_normal(axes[0].direction)};
  Displacement before;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Result<CommonNormal> next = normal_from(axes, k, normal);
    if (!next) return next.errors();
    normal = *next;
    const Displacement frame = joint_frame(normal.foot_on_first, normal.direction, normalized(axes[k].direction));
    if (k == 0) chain.base = before = frame;
    const auto fit = hartenberg_denavit_of(before.inverse() * frame, HartenbergDenavitForm::modified);
    if (!fit) return fit.errors();
    chain.links.push_back(k == 0 ? HartenbergDenavit{} : fit->link);
    before = frame;
  }
  return chain;
}

}  // namespace linkwright
