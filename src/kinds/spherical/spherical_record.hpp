#pragma once

#include <optional>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/listed_notes.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/spherical/spherical_solution.hpp"

namespace linkwright {

/// In degrees.
void fields(FieldVisitor& v, const LinkAngles& angles);

/// The axes.
void fields(FieldVisitor& v, const SphericalFourBar& bars);

struct SphericalDyadRecord {
  const SphericalDyad& dyad;
  double residual;
};
void fields(FieldVisitor& v, const SphericalDyadRecord& of);
/// The same with its multiplicity and condition.
void fields(FieldVisitor& v, const SphericalDyadPoint& point);

/// What a file says of a spherical four-bar beside the four-bar itself.
struct SphericalNotes {
  std::vector<PrescribedOrientation> orientations;  ///< of the coupler, where they are not the task's; otherwise none
  std::optional<double> free_value;                 ///< of a function task's free parameter, as files hold it
  ListedNotes listed{};
};

/// The notes of a four-bar of a map; none without one.
[[nodiscard]] SphericalNotes notes_on(const SphericalSolution& found, const SphericalFamily* family);

/// An element of a result's `linkages`.
struct SphericalRecord {
  const SphericalSolution& found;
  SphericalNotes notes;
};
void fields(FieldVisitor& v, const SphericalRecord& of);

/// About what input and output swing.
inline const Names<TripleRockerKind> triple_rockers = {
    {TripleRockerKind::zero_zero, TripleRockerKind::zero_pi, TripleRockerKind::pi_zero, TripleRockerKind::pi_pi}};

}  // namespace linkwright
