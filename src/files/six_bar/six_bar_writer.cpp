#include "six_bar_writer.hpp"

#include <algorithm>
#include <cmath>

#include "files/fields/field_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "files/six_bar/six_bar_kind.hpp"
#include "linkwright/analysis/six_bar_position.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_added(JsonWriter& json, const SixBar& six_bar, std::span<const double> coordinates) {
  constexpr std::array<std::array<SixBar::JointIndex, 2>, 2> hinges = {
      {{SixBar::c4, SixBar::z4}, {SixBar::c5, SixBar::z5}}};
  json.begin_list();
  for (std::size_t link = 0; link < hinges.size(); ++link) {
    json.begin_object(Layout::one_line);
    json.member("between", std::string_view(text(six_bar.added()[link])));
    json.key("points");
    json.begin_list(Layout::one_line);
    for (const SixBar::JointIndex hinge : hinges[link]) write_point(json, six_bar.at(hinge));
    json.end_list();
    if (link < coordinates.size()) json.member("coordinate", coordinates[link]);
    json.end_object();
  }
  json.end_list();
}

/// Of the dyad that follows the driver, and of the one that follows that; null where all hang together.
void write_dyad_angles(JsonWriter& json, const SixBar& six_bar, const SixBarDriveReport& drive) {
  json.key("min_transmission_angles_of_dyads_deg");
  if (!six_bar_transmission(six_bar, {1, 1, 1, 1, 1, 1}).dyadic) return json.null();
  write_interval(json, angle_of_sine_deg(drive.min_sines[0]), angle_of_sine_deg(drive.min_sines[1]));
}

void write_drive(JsonWriter& json, const SixBar& six_bar, const SixBarRating& rating) {
  const SixBarDriveReport& drive = rating.drive;
  json.key("defects");
  write_defects(json, drive.defects);
  const bool driven = drive.completed && drive.defects.none();
  json.key("drive");
  drive.sense == DriveSense::none ? json.null() : json.value(name(drive.sense));
  json.key("driver_sweep_deg");
  driven ? json.value(degrees(drive.sweep)) : json.null();
  json.key("min_transmission_angle_deg");
  driven ? json.value(degrees(rating.min_transmission_angle())) : json.null();
  if (driven) write_dyad_angles(json, six_bar, drive);
}

/// With the sign of position 1 where none is given.
std::array<int, 4> elbows(const ThreeLinkChain& chain) {
  std::array<int, 4> signs = chain.assembly_mode;
  for (int& sign : signs) sign = sign == 0 ? chain.assembly_mode_in_position_1() : sign;
  return signs;
}

}  // namespace

double angle_of_sine_deg(double sine) { return degrees(std::asin(std::min(sine, 1.0))); }

void write_make_up(JsonWriter& json, const SixBar& six_bar, const std::array<int, 4>& assembly_mode,
                   std::span<const double> coordinates) {
  json.key("topology");
  const auto topology = six_bar.topology();
  topology ? json.value(name(*topology)) : json.null();
  json.key("chain");
  write_fields(json,
               ThreeLinkChain{six_bar.at(SixBar::a), six_bar.at(SixBar::b), six_bar.at(SixBar::d), assembly_mode});
  json.key("added");
  write_added(json, six_bar, coordinates);
  json.key("joints");
  json.begin_object();
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint) {
    json.key(joint_name(joint));
    write_point(json, six_bar.joints[joint].point);
  }
  json.end_object();
}

void write_lengths(JsonWriter& json, std::span<const SixBarLength> lengths) {
  json.begin_object();
  for (const SixBarLength& length : lengths) json.member(name(length), length.length);
  json.end_object();
}

void write_six_bar(JsonWriter& json, const SixBarSolution& found, const ListedNotes& listed) {
  json.begin_object();
  json.member("mechanism", "six_bar");
  write_make_up(json, found.member.six_bar, elbows(found.chain), found.member.coordinates);
  json.key("lengths");
  write_lengths(json, found.lengths);
  json.member("link_ratio", found.rating.shape.link_ratio);
  json.member("type", name(found.rating.shape.type));
  write_drive(json, found.member.six_bar, found.rating);
  json.member("residual", found.residual);
  json.member("pose_residual", found.pose_residual);
  json.member("local_optimum", found.local_optimum);
  json.member("verified_by_driving", found.verified_by_driving);
  listed.write(json);
  json.end_object();
}

void write_search(JsonWriter& json, const SixBarSearchResult& search, const SynthesisOptions& options) {
  json.begin_object();
  json.member("seed", options.seed);
  json.member("effort", options.effort);
  json.member("chains_drawn", search.chains_drawn);
  json.member("chains_tried", search.chains_tried);
  json.member("six_bars", search.six_bars);
  json.member("driven", search.driven);
  json.member("defect_free", search.defect_free);
  json.member("interrupted", search.interrupted);
  json.end_object();
}

}  // namespace linkwright
