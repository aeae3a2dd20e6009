#pragma once

#include <vector>

#include "linkwright/planar/burmester_curve.hpp"
#include "support/planar_case.hpp"

namespace linkwright::testing {

/// Where a case file's curve coordinates lie on our curve. On irreducible curves both are the same; a line, circle or
/// conic of a degenerate curve may be run the other way or begin elsewhere (an eigenvector has two signs): an affine
/// map per branch, found from the file's own samples. Fails the test when the samples do not fit one.
[[nodiscard]] std::vector<double> our_coordinates(const PlanarCase& c, const BurmesterCurve& curve,
                                                  const std::vector<double>& theirs);

}  // namespace linkwright::testing
