#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/region/criterion.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// What linkages of a class can be, what can be required of them, and what ranks them.
struct LinkageClass {
  std::span<const LinkageType> types;  ///< in the order in which they are told
  RequirementKinds requirements;       ///< at most max_requirements
  std::span<const Objective> objectives;
};

namespace class_members {
inline constexpr std::array planar_types = {LinkageType::crank_rocker,          LinkageType::rocker_crank,
                                            LinkageType::double_crank,          LinkageType::double_rocker,
                                            LinkageType::triple_rocker_ground,  LinkageType::triple_rocker_input,
                                            LinkageType::triple_rocker_coupler, LinkageType::triple_rocker_output,
                                            LinkageType::change_point,          LinkageType::degenerate};
inline constexpr std::array spherical_types = {
    LinkageType::crank_rocker,  LinkageType::rocker_crank, LinkageType::double_crank, LinkageType::double_rocker,
    LinkageType::triple_rocker, LinkageType::change_point, LinkageType::degenerate};

/// A requirement is a bit of what a cell fails: raise max_requirements where there are more.
template <class Kind, std::size_t n, std::size_t added>
requires(n + added <= max_requirements) constexpr auto joined(const std::array<Kind, n>& own,
                                                              const std::array<Kind, added>& more) {
  std::array<Kind, n + added> all{};
  std::copy(more.begin(), more.end(), std::copy(own.begin(), own.end(), all.begin()));
  return all;
}

/// Those of a class, and what analyses ask of the linkages of any class.
template <std::size_t n>
constexpr auto with_analyses(const std::array<RequirementKind, n>& own) {
  return joined(own, std::array{RequirementKind::max_tolerance_error, RequirementKind::min_yield});
}
template <std::size_t n>
constexpr auto with_analyses(const std::array<Objective, n>& own) {
  return joined(own, std::array{Objective::tolerance_error, Objective::yield});
}

/// What analyses ask of linkages that carry loads: those of the plane with a guided body.
inline constexpr std::array load_requirements = {RequirementKind::max_open_force, RequirementKind::max_close_force,
                                                 RequirementKind::min_hold_open, RequirementKind::max_pin_force,
                                                 RequirementKind::max_torque};
inline constexpr std::array load_objectives = {Objective::hand_force, Objective::hold_open, Objective::pin_force,
                                               Objective::torque};

inline constexpr auto unloaded_requirements = with_analyses(
    std::array{RequirementKind::types, RequirementKind::no_defects, RequirementKind::min_transmission_angle,
               RequirementKind::max_link_ratio, RequirementKind::max_length, RequirementKind::min_length,
               RequirementKind::ground_pivots_within, RequirementKind::moving_pivots_within});
inline constexpr auto planar_requirements = joined(unloaded_requirements, load_requirements);
inline constexpr auto near_motion_requirements =
    joined(planar_requirements, std::array{RequirementKind::max_near_error});
inline constexpr auto path_requirements = joined(
    with_analyses(std::array{
        RequirementKind::types, RequirementKind::no_defects, RequirementKind::min_transmission_angle,
        RequirementKind::max_link_ratio, RequirementKind::max_length, RequirementKind::min_length,
        RequirementKind::ground_pivots_within, RequirementKind::moving_pivots_within, RequirementKind::full_turn}),
    load_requirements);
inline constexpr auto near_path_requirements = joined(path_requirements, std::array{RequirementKind::max_path_error});
inline constexpr auto spherical_requirements = with_analyses(
    std::array{RequirementKind::types, RequirementKind::no_defects, RequirementKind::min_transmission_angle,
               RequirementKind::min_link_angle, RequirementKind::max_link_angle, RequirementKind::fixed_axes_within,
               RequirementKind::moving_axes_within});
inline constexpr auto straight_line_requirements = with_analyses(
    std::array{RequirementKind::types, RequirementKind::min_transmission_angle, RequirementKind::max_link_ratio,
               RequirementKind::max_length, RequirementKind::ground_pivots_within,
               RequirementKind::moving_pivots_within, RequirementKind::min_stroke, RequirementKind::max_deviation});
inline constexpr auto straight_line_objectives =
    with_analyses(std::array{Objective::stroke, Objective::deviation, Objective::min_transmission_angle,
                             Objective::size, Objective::velocity_uniformity});
inline constexpr auto path_objectives =
    joined(with_analyses(std::array{Objective::min_transmission_angle, Objective::link_ratio, Objective::size}),
           load_objectives);
inline constexpr auto near_path_objectives = joined(std::array{Objective::path_error}, path_objectives);
inline constexpr auto unloaded_objectives = with_analyses(
    std::array{Objective::min_transmission_angle, Objective::link_ratio, Objective::size, Objective::structural_error});
inline constexpr auto planar_objectives = joined(unloaded_objectives, load_objectives);
inline constexpr auto near_motion_objectives = joined(std::array{Objective::near_error}, planar_objectives);
inline constexpr auto spherical_objectives =
    with_analyses(std::array{Objective::min_transmission_angle, Objective::link_angle, Objective::structural_error});
}  // namespace class_members

inline constexpr LinkageClass planar_linkages = {class_members::planar_types, class_members::planar_requirements,
                                                 class_members::planar_objectives};
/// Of them those of motions past near poses, ranked by the smallest error there where nothing else is asked for. What
/// is asked of planar linkages comes first, so that what a cell fails has the same bits.
inline constexpr LinkageClass near_motion_linkages = {
    class_members::planar_types, class_members::near_motion_requirements, class_members::near_motion_objectives};
/// Of planar linkages those that carry no loads: generators of functions, and six-bars. What is asked of them are the
/// first of what is asked of planar linkages, in the same order, so that what a cell fails has the same bits.
inline constexpr LinkageClass unloaded_linkages = {class_members::planar_types, class_members::unloaded_requirements,
                                                   class_members::unloaded_objectives};
inline constexpr LinkageClass path_linkages = {class_members::planar_types, class_members::path_requirements,
                                               class_members::path_objectives};
/// Of paths that pass near points; the smallest error ranks them where nothing else is asked for.
inline constexpr LinkageClass near_path_linkages = {class_members::planar_types, class_members::near_path_requirements,
                                                    class_members::near_path_objectives};
inline constexpr LinkageClass spherical_linkages = {
    class_members::spherical_types, class_members::spherical_requirements, class_members::spherical_objectives};
inline constexpr LinkageClass straight_line_linkages = {
    class_members::planar_types, class_members::straight_line_requirements, class_members::straight_line_objectives};

/// A requirement that linkages of the class do not have. Place `requirements.…`.
[[nodiscard]] Error foreign_requirement(RequirementKind kind, const LinkageClass& of);

/// An objective that does not rank linkages of the class. Place `options.objective`.
[[nodiscard]] Error foreign_objective(Objective objective, const LinkageClass& of);

/// What of the requirements does not go with the class: types and kinds that it does not have. Places `requirements.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const Requirements& wanted, const LinkageClass& of);

}  // namespace linkwright
