#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// The kind of motion of a four-bar, input named first; the value is the code in region maps. Triple rockers
/// (non-Grashof) of the plane are named by their longest link; on the sphere, where a link may be replaced by its
/// supplement, they are one type.
enum class LinkageType : std::uint8_t {
  crank_rocker,
  rocker_crank,
  double_crank,
  double_rocker,
  triple_rocker_ground,
  triple_rocker_input,
  triple_rocker_coupler,
  triple_rocker_output,
  change_point,
  degenerate,
  triple_rocker,
};
inline constexpr std::size_t linkage_type_count = 11;

inline constexpr std::array<std::string_view, linkage_type_count> linkage_type_names = {
    "crank_rocker",         "rocker_crank",        "double_crank",          "double_rocker",
    "triple_rocker_ground", "triple_rocker_input", "triple_rocker_coupler", "triple_rocker_output",
    "change_point",         "degenerate",          "triple_rocker"};

/// Key in files: "crank_rocker", …
[[nodiscard]] inline std::string_view name(LinkageType type) {
  return linkage_type_names[static_cast<std::size_t>(type)];
}
/// The type of a key; nothing where there is none of that name.
[[nodiscard]] std::optional<LinkageType> linkage_type_named(std::string_view name);

/// The three excesses T₁ = g + h − a − b, T₂ = g + b − a − h, T₃ = h + b − g − a of ground g, input a, coupler h,
/// output b: the four-bar is Grashof iff T₁T₂T₃ > 0, and their signs tell the type
/// (Barker, "A complete classification of planar four-bar linkages", 1985).
struct GrashofExcesses {
  double t1 = 0, t2 = 0, t3 = 0;
};
/// In the unit of the lengths.
[[nodiscard]] GrashofExcesses grashof_excesses(const LinkLengths& lengths);
/// The smallest excess, as a share of the perimeter: how far the links are from another type.
[[nodiscard]] double change_point_margin(const LinkLengths& lengths);

/// Type by the signs of the excesses; change point where one is at most tolerance::change_point of the perimeter;
/// degenerate where a link is.
[[nodiscard]] LinkageType linkage_type(const LinkLengths& lengths);

/// Type of the same bars driven from the other grounded link.
[[nodiscard]] LinkageType swapped(LinkageType type);

/// True for the four Grashof types.
[[nodiscard]] inline bool is_grashof(LinkageType type) { return type <= LinkageType::double_rocker; }

/// True where the input turns fully: crank_rocker and double_crank.
[[nodiscard]] inline bool input_is_crank(LinkageType type) {
  return type == LinkageType::crank_rocker || type == LinkageType::double_crank;
}

/// Barker's subdivision of change points by the number of vanishing excesses and by the shortest link.
enum class ChangePointKind : std::uint8_t {
  none,
  crank_rocker,           ///< one excess vanishes, input shortest
  rocker_crank,           ///< output shortest
  double_crank,           ///< ground shortest
  double_rocker,          ///< coupler shortest
  parallelogram_or_kite,  ///< two excesses vanish
  rhombus,                ///< all three vanish
};
/// `none` unless linkage_type() is change_point.
[[nodiscard]] ChangePointKind change_point_kind(const LinkLengths& lengths);
/// "none", "crank_rocker", …
[[nodiscard]] std::string_view name(ChangePointKind kind);

}  // namespace linkwright
