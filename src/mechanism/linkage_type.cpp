#include "linkwright/mechanism/linkage_type.hpp"

#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 7> change_point_kind_names = {
    "none", "crank_rocker", "rocker_crank", "double_crank", "double_rocker", "parallelogram_or_kite", "rhombus"};

bool all_finite(const LinkLengths& l) { return std::isfinite(l.perimeter()); }

// Indexed by the signs (T₁ > 0, T₂ > 0, T₃ > 0) as a three-bit number.
constexpr std::array<LinkageType, 8> type_of_signs = {
    LinkageType::triple_rocker_input,  LinkageType::double_crank, LinkageType::double_rocker,
    LinkageType::triple_rocker_output, LinkageType::rocker_crank, LinkageType::triple_rocker_coupler,
    LinkageType::triple_rocker_ground, LinkageType::crank_rocker};

}  // namespace

std::optional<LinkageType> linkage_type_named(std::string_view name) {
  for (std::size_t i = 0; i < linkage_type_names.size(); ++i)
    if (linkage_type_names[i] == name) return static_cast<LinkageType>(i);
  return std::nullopt;
}

GrashofExcesses grashof_excesses(const LinkLengths& l) {
  return {l.ground + l.coupler - l.input - l.output, l.ground + l.output - l.input - l.coupler,
          l.coupler + l.output - l.ground - l.input};
}

double change_point_margin(const LinkLengths& lengths) {
  const GrashofExcesses t = grashof_excesses(lengths);
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / lengths.perimeter();
}

LinkageType linkage_type(const LinkLengths& lengths) {
  const double zero = tolerance::change_point * lengths.perimeter();
  if (!all_finite(lengths) || !(lengths.shortest() > zero)) return LinkageType::degenerate;
  const GrashofExcesses t = grashof_excesses(lengths);
  if (std::abs(t.t1) <= zero || std::abs(t.t2) <= zero || std::abs(t.t3) <= zero) return LinkageType::change_point;
  const std::size_t signs = (t.t1 > 0 ? 4u : 0u) | (t.t2 > 0 ? 2u : 0u) | (t.t3 > 0 ? 1u : 0u);
  return type_of_signs[signs];
}

LinkageType swapped(LinkageType type) {
  switch (type) {
    case LinkageType::crank_rocker:
      return LinkageType::rocker_crank;
    case LinkageType::rocker_crank:
      return LinkageType::crank_rocker;
    case LinkageType::triple_rocker_input:
      return LinkageType::triple_rocker_output;
    case LinkageType::triple_rocker_output:
      return LinkageType::triple_rocker_input;
    default:
      return type;
  }
}

ChangePointKind change_point_kind(const LinkLengths& l) {
  if (linkage_type(l) != LinkageType::change_point) return ChangePointKind::none;
  const double zero = tolerance::change_point * l.perimeter();
  const GrashofExcesses t = grashof_excesses(l);
  const int vanishing = (std::abs(t.t1) <= zero) + (std::abs(t.t2) <= zero) + (std::abs(t.t3) <= zero);
  if (vanishing == 3) return ChangePointKind::rhombus;
  if (vanishing == 2) return ChangePointKind::parallelogram_or_kite;
  const double shortest = l.shortest();
  if (l.input == shortest) return ChangePointKind::crank_rocker;
  if (l.output == shortest) return ChangePointKind::rocker_crank;
  return l.ground == shortest ? ChangePointKind::double_crank : ChangePointKind::double_rocker;
}

std::string_view name(ChangePointKind kind) { return change_point_kind_names[static_cast<std::size_t>(kind)]; }

}  // namespace linkwright
