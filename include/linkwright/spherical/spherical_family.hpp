#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "linkwright/spherical/spherical_map.hpp"

namespace linkwright {

struct SphericalDyadPair {
  SphericalDyad input, output;
};

/// The four-bar of a pair of dyads, with_short_links().
[[nodiscard]] SphericalFourBar four_bar_of(const SphericalDyadPair& links);

/// Its axes, senses as they are.
[[nodiscard]] Pivots pivots_of(const SphericalFourBar& bars);
/// The bars of four axes.
[[nodiscard]] SphericalFourBar spherical_four_bar_of(const Pivots& pivots);

/// The spherical four-bars that a task leaves open, over two coordinates. The dyads are in the fixed frame, their
/// moving axes in position 1.
class SphericalFamily : public LinkageFamily {
 public:
  using LinkageFamily::LinkageFamily;

  [[nodiscard]] const LinkageClass& linkages() const override { return spherical_linkages; }

  /// The pair of dyads at a map point; nothing where the family has none there.
  [[nodiscard]] virtual std::optional<SphericalDyadPair> dyad_pair(MapPoint place) const = 0;
  /// The same, reusing those of the known dyads whose coordinates are the point's.
  [[nodiscard]] virtual std::optional<SphericalDyadPair> dyad_pair_reusing(MapPoint place,
                                                                           const SphericalDyadPair& /*known*/) const {
    return dyad_pair(place);
  }
  /// The bars of a pair of its dyads; by default four_bar_of().
  [[nodiscard]] virtual SphericalFourBar four_bar(const SphericalDyadPair& links) const { return four_bar_of(links); }
  /// What the coupler of the bars at a place is to visit, position 1 being the one in which they lie.
  [[nodiscard]] virtual std::vector<PrescribedOrientation> orientations(MapPoint place,
                                                                        const SphericalFourBar& bars) const = 0;
  /// Dyads along the axis close enough to draw their axes as curves, by rising coordinate.
  [[nodiscard]] virtual std::vector<SphericalDyad> polygon(Side side) const = 0;

  [[nodiscard]] std::span<const Measure> measures() const override { return spherical_measures; }
  [[nodiscard]] CellAt cells(bool respect_direction) const override;
  /// The largest distance on the unit sphere between two axes, which have no sense.
  [[nodiscard]] double distance(const Pivots& one, const Pivots& other) const override;
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint place) const override;
  /// Of bars known already.
  [[nodiscard]] virtual LinkageOutput output_of(MapPoint place, const SphericalFourBar& bars) const;
  [[nodiscard]] std::optional<LinkageOutput> output_form() const override { return SphericalOutput{}; }
};

/// Every four-bar visits the same orientations, and each dyad depends on its own coordinate alone.
class SphericalProductFamily : public SphericalFamily {
 public:
  SphericalProductFamily(std::vector<PrescribedOrientation> orientations, MapAxis input, MapAxis output);

  /// Nothing where the axis has no dyad there.
  [[nodiscard]] virtual std::optional<SphericalDyad> dyad(double coordinate) const = 0;

  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] std::optional<SphericalDyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] std::optional<SphericalDyadPair> dyad_pair_reusing(MapPoint place,
                                                                   const SphericalDyadPair& known) const override;
  [[nodiscard]] std::vector<PrescribedOrientation> orientations(MapPoint /*place*/,
                                                                const SphericalFourBar& /*bars*/) const override {
    return orientations_;
  }
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;
  [[nodiscard]] std::shared_ptr<const SphericalCells> spherical_cells(const RegionMap& map) const override;
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;

 protected:
  /// arcs_within() with borders that are known beside those that are found between samples.
  [[nodiscard]] std::vector<AxisArc> arcs_with_borders(Side side, const PivotWindows& windows,
                                                       std::vector<double> borders) const;

 private:
  /// None where there is no dyad.
  [[nodiscard]] GroundedLinkPivots pivots_at(double coordinate) const;
  [[nodiscard]] std::vector<SphericalDyad> dyads(std::span<const double> coordinates) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  std::vector<PrescribedOrientation> orientations_;
};

/// Four positions: both dyads from the same curve.
class SphericalCurveFamily : public SphericalProductFamily {
 public:
  SphericalCurveFamily(std::vector<PrescribedOrientation> orientations, std::shared_ptr<const AxisCurve> curve);

  [[nodiscard]] std::optional<SphericalDyad> dyad(double coordinate) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::vector<SphericalDyad> polygon(Side side) const override;
  /// In closed form: where both cones of axes meet those of the windows.
  [[nodiscard]] std::optional<AxisArcs> arcs_within(Side side, const PivotWindows& windows) const override;

 private:
  std::shared_ptr<const AxisCurve> curve_;
};

/// A few dyads, any two of which make a four-bar: the i-th fills the branch [i, i + 1).
class SphericalPointFamily : public SphericalProductFamily {
 public:
  /// Each with the coordinate index + ½.
  SphericalPointFamily(std::vector<PrescribedOrientation> orientations, std::vector<SphericalDyad> dyads);

  [[nodiscard]] std::optional<SphericalDyad> dyad(double coordinate) const override;
  [[nodiscard]] std::vector<SphericalDyad> polygon(Side /*side*/) const override { return dyads_; }

 private:
  std::vector<SphericalDyad> dyads_;
};

}  // namespace linkwright
