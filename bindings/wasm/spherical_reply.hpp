#pragma once

#include <optional>
#include <span>

#include "linkage_reply.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/spherical/spherical_solution.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"
#include "spherical_travel.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// What spherical tasks of all kinds tell of themselves: why there is no map, that no pair makes a four-bar, and what
/// is known before linkages are looked at.
[[nodiscard]] const Notice& no_spherical_map(const SphericalTaskFamily& known);
[[nodiscard]] const Notice& no_spherical_pair();
[[nodiscard]] TaskReply about_spherical(const SphericalTaskFamily& known);

/// SphericalLinkage of the protocol, and its drive over the whole range of the input: rows of state_columns, of which
/// those of the plane are 0, followed by the input's and the output's moving axis and the coupler's turn from position
/// 1 as a quaternion (w, x, y, z). `known`: its axes are told where they make no linkage, too. `fails`: requirement
/// bits. `wanted`: of generators, its free parameter fixed.
inline constexpr std::size_t spherical_state_width = state_width + 10;
[[nodiscard]] LinkageReply spherical_reply(const SphericalTaskFamily& known,
                                           const std::optional<SphericalSolution>& found,
                                           const std::vector<PrescribedOrientation>& orientations, MapPoint point,
                                           FailureBits fails, const WantedFunction* wanted = nullptr);
/// The same of a linkage that is no task's. `travel`: that of its drive. `write_more`: members of its own.
[[nodiscard]] LinkageReply spherical_reply(const SphericalSolution& found, const SphericalAnalysis& analysis,
                                           const SphericalTravel& travel,
                                           const std::function<void(JsonWriter&)>& write_more);

}  // namespace linkwright::wasm
