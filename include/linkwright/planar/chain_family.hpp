#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "linkwright/region/linkage_family.hpp"

namespace linkwright {

/// The six-bars of a given chain as a family over two coordinates: row τ of link 4, column τ of link 5, the latter as a
/// share of its curve in [0, 1) where that curve depends on link 4. A cell without a link 4 or 5, or whose new link is
/// one that is there already, is degenerate. Each cell is driven through, but not round its whole circuit.
class ChainFamily : public LinkageFamily {
 public:
  /// As SixBarFamily: `added` in an order of six_bar_rows(), `bodies` from chain_positions(); fixed frame, user's unit.
  /// `reference`: the guided frame in position 1.
  ChainFamily(const ThreeLinkChain& chain, std::array<BodyPair, 2> added, std::array<BodyPositions, 4> bodies,
              const Pose& reference = {});
  /// Of a task; nothing without a chain, or with one that does not reach all poses.
  [[nodiscard]] static std::shared_ptr<const ChainFamily> of(const SixBarTask& task);

  [[nodiscard]] const LinkageClass& linkages() const override { return unloaded_linkages; }
  [[nodiscard]] const ThreeLinkChain& chain() const { return chain_; }
  [[nodiscard]] const SixBarFamily& six_bars() const { return six_bars_; }
  /// The links of an axis; null where they are others for each link 4.
  [[nodiscard]] const AddedLinks* links(Side side) const;
  /// The second coordinate is a share of a curve.
  [[nodiscard]] bool second_is_share() const { return six_bars_.second_depends_on_first(); }

  /// Nothing where there is no six-bar.
  [[nodiscard]] std::optional<SixBarMember> member(MapPoint point) const;
  /// Where on the map a member of this family lies: (τ of link 4, τ of link 5 or the share of its curve).
  [[nodiscard]] MapPoint point_of(const SixBarMember& member) const;

  /// As many on a curve without coordinates: none of its cells holds a six-bar, but there are cells to be counted.
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;

  [[nodiscard]] std::span<const Measure> measures() const override;
  /// Driven through without circuits.
  [[nodiscard]] CellAt cells(bool respect_direction) const override;
  [[nodiscard]] bool cells_take_long() const override { return true; }
  /// Of a hinge, each being named.
  [[nodiscard]] double distance(const Pivots& one, const Pivots& other) const override;
  /// A branch of each curve, that of link 5 being the one there.
  [[nodiscard]] AxisStretch stretch_around(Side side, MapPoint place) const override;
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;

  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint place) const override;
  [[nodiscard]] OutputOfCells outputs_of(const RegionMap& map) const override;
  /// Six-bars differ in which of their bodies are ternary.
  [[nodiscard]] std::optional<LinkageOutput> output_form() const override { return std::nullopt; }

 private:
  ChainFamily(const ThreeLinkChain& chain, SixBarFamily six_bars, const Pose& reference);
  /// Of the cells of a map, both of which must outlive it; those of a row have their link 4 in common.
  [[nodiscard]] std::function<std::optional<SixBarMember>(std::size_t row, std::size_t column)> members_of(
      const RegionMap& map) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  ThreeLinkChain chain_;
  SixBarFamily six_bars_;
  Pose reference_;
};

}  // namespace linkwright
