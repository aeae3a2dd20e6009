#include "six_bar_record.hpp"

#include <algorithm>
#include <cmath>

#include "files/fields/result_forms.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"
#include "six_bar_kind.hpp"

namespace linkwright {
namespace {

struct AddedLink {
  BodyPair between;
  std::vector<Point> hinges = std::vector<Point>(2);
  std::optional<double> coordinate;
};

std::vector<AddedLink> added_links(const SixBar& six_bar, std::span<const double> coordinates) {
  constexpr std::array<std::array<SixBar::JointIndex, 2>, 2> hinges = {
      {{SixBar::c4, SixBar::z4}, {SixBar::c5, SixBar::z5}}};
  std::vector<AddedLink> links;
  for (std::size_t i = 0; i < hinges.size(); ++i)
    links.push_back({six_bar.added()[i],
                     {six_bar.at(hinges[i][0]), six_bar.at(hinges[i][1])},
                     i < coordinates.size() ? std::optional(coordinates[i]) : std::nullopt});
  return links;
}

/// Of the dyad that follows the driver, and of the one that follows that; nothing where all hang together.
std::optional<std::array<double, 2>> dyad_angles_deg(const SixBar& six_bar, const SixBarDriveReport& drive) {
  if (!six_bar_transmission(six_bar, {1, 1, 1, 1, 1, 1}).dyadic) return std::nullopt;
  return std::array{angle_of_sine_deg(drive.min_sines[0]), angle_of_sine_deg(drive.min_sines[1])};
}

void transmission_fields(FieldVisitor& v, const SixBar& six_bar, const SixBarRating& rating, bool is_driven) {
  v.shown(Field("min_transmission_angle_deg",
                "Over the task; null with a defect. Of two dyads the smaller; where all bodies move together, asin of "
                "√(|det| / Π|columns|) of the loops."),
          forms::where(is_driven, degrees(rating.min_transmission_angle())), forms::angle_deg);
  const Field of_dyads("min_transmission_angles_of_dyads_deg",
                       "Of the dyad that follows the driver, and of the one that follows that; null where all bodies "
                       "move together.");
  v.member(of_dyads.written(is_driven), false, [&](FieldVisitor& to) {
    auto angles = is_driven ? dyad_angles_deg(six_bar, rating.drive) : std::nullopt;
    visit(to, angles, Pair{.form = "", .each = forms::angle_deg});
  });
}

void drive_fields(FieldVisitor& v, const SixBar& six_bar, const SixBarRating& rating) {
  const SixBarDriveReport& drive = rating.drive;
  const bool is_driven = drive.completed && drive.defects.none();
  v.shown("defects", drive.defects);
  drive_fields(v, drive.sense, forms::where(is_driven, degrees(drive.sweep)));
  transmission_fields(v, six_bar, rating, is_driven);
}

/// With the sign of position 1 where none is given.
std::array<int, 4> elbows(const ThreeLinkChain& chain) {
  std::array<int, 4> signs = chain.assembly_mode;
  for (int& sign : signs) sign = sign == 0 ? chain.assembly_mode_in_position_1() : sign;
  return signs;
}

void joints_field(FieldVisitor& v, const SixBar& six_bar) {
  const Field field("joints", "All hinges by name; c4 and z4 are those of link 4, c5 and z5 those of link 5.");
  v.member(field, true, [&](FieldVisitor& at) {
    at.object({.name = "joints", .on_lines = true}, [&](FieldVisitor& to) {
      for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
        to.shown(joint_name(joint), six_bar.joints[joint].point, forms::shown_point);
    });
  });
}

void chain_field(FieldVisitor& v, ThreeLinkChain chain) {
  const Field field("chain", "Hinges between 0 and 1, 1 and 2, 2 and 3; sign of cross(d − a, b − a) in each position.");
  v.member(field, true, [&](FieldVisitor& at) {
    at.described_in("problem.schema.json#/$defs/chain", [&](FieldVisitor& to) { fields(to, chain); });
  });
}

}  // namespace

static void fields(FieldVisitor& v, const AddedLink& link) {
  v.object({.name = "added_link"}, [&](FieldVisitor& to) {
    to.shown("between", text(link.between));
    to.shown("points", link.hinges, List{.what = "", .least = 2, .most = 2}, forms::shown_point);
    to.shown_if_any("coordinate", link.coordinate, Number{});
  });
}

double angle_of_sine_deg(double sine) { return degrees(std::asin(std::min(sine, 1.0))); }

void make_up_fields(FieldVisitor& v, const SixBar& six_bar, const std::array<int, 4>& assembly_mode,
                    std::span<const double> coordinates) {
  using Topology = SixBarTopology;
  v.shown("topology", six_bar.topology(),
          Names<Topology>{{Topology::watt_1, Topology::stephenson_1, Topology::stephenson_2, Topology::stephenson_3}});
  chain_field(v, {six_bar.at(SixBar::a), six_bar.at(SixBar::b), six_bar.at(SixBar::d), assembly_mode});
  v.shown(Field("added", "Links 4 and 5: the bodies that each joins, its hinges on them, its place on its curve."),
          added_links(six_bar, coordinates), List{.what = "", .least = 2, .most = 2, .on_lines = true});
  joints_field(v, six_bar);
}

void lengths_field(FieldVisitor& v, std::span<const SixBarLength> lengths) {
  constexpr Keyed described = {.pattern = "^[0-5]:[abdcz45]+-[abdcz45]+$", .on_lines = true};
  std::vector<std::string> keys;
  for (const SixBarLength& length : lengths) keys.push_back(name(length));
  v.member(Field("lengths", "Distances between hinges of one body, \"1:a-b\" of body 1."), true, [&](FieldVisitor& at) {
    at.keyed(described, keys, [&](FieldVisitor& to, std::size_t i) {
      double length = i < lengths.size() ? lengths[i].length : 0;
      visit(to, length, Number{.least = 0, .above = true});
    });
  });
}

void fields(FieldVisitor& v, const SixBarRecord& of) {
  const SixBarSolution& found = of.found;
  const Object described = {"six_bar",
                            "As it lies in position 1, driven by body 1 at hinge a. Bodies: 0 ground, 1 driver, 2 link "
                            "between, 3 guided body, 4 and 5 the added links.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("mechanism", "six_bar");
    make_up_fields(to, found.member.six_bar, elbows(found.chain), found.member.coordinates);
    lengths_field(to, found.lengths);
    to.shown(Field("link_ratio", "Longest over shortest of them."), found.rating.shape.link_ratio, Number{.least = 1});
    to.shown(Field("type", "Of its loop of four bodies."), found.rating.shape.type, forms::linkage_types);
    drive_fields(to, found.member.six_bar, found.rating);
    to.shown(Field("residual", "Worst relative change of a length over the poses."), found.residual,
             forms::not_negative);
    to.shown(Field("pose_residual", "Worst miss of a pose, as a share of the longest link, or in radians."),
             found.pose_residual, forms::not_negative);
    to.shown("local_optimum", found.local_optimum);
    to.shown(Field("verified_by_driving", "Driven another way it has the defects told."), found.verified_by_driving);
    of.listed.visit(to);
  });
}

void fields(FieldVisitor& v, const SixBarSearchRecord& of) {
  const Object described = {"search", "Six-bars without a given chain: how the search went.", true};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("seed", "The same seed finds the same six-bars."), of.options.seed, forms::count);
    to.shown(Field("effort", "Chains that were to be tried."), of.options.effort, forms::count);
    to.shown(Field("chains_drawn", "All pivots in the box; most do not reach all poses."), of.search.chains_drawn,
             forms::count);
    to.shown(Field("chains_tried", "That reach all poses."), of.search.chains_tried, forms::count);
    to.shown(Field("six_bars", "Of those chains, all pivots in the box."), of.search.six_bars, forms::count);
    to.shown(Field("driven", "Of those, that could be better than the chain's best so far."), of.search.driven,
             forms::count);
    to.shown(Field("defect_free", "Of the ones driven."), of.search.defect_free, forms::count);
    to.shown(Field("interrupted", "Stopped early: the linkages are the best so far, not refined."),
             of.search.interrupted);
  });
}

}  // namespace linkwright
