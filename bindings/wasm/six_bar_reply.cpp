#include "six_bar_reply.hpp"

#include <algorithm>
#include <cmath>

#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

/// The six-bar driven from position 1 through the others, or as far as it comes.
int sense_of(const SixBarSolution& found) { return found.rating.drive.sense == DriveSense::cw ? -1 : 1; }
SixBarCheck driven(const SixBarSolution& found, const std::vector<PrescribedPose>& poses) {
  return check_by_driving(found.member.six_bar, poses, sense_of(found));
}

/// Turns of all bodies from where their hinges are.
SixBarTurns turns_of(const SixBar& six_bar, const SixBarState& state) {
  SixBarTurns turns;
  turns.fill(1);
  for (int body = 1; body < SixBar::bodies; ++body) {
    const auto joints = six_bar.joints_of(body);
    const Point before = six_bar.joints[joints[1]].point - six_bar.joints[joints[0]].point;
    const Point now = state.joints[joints[1]] - state.joints[joints[0]];
    turns[static_cast<std::size_t>(body)] = now / before / std::abs(now / before);
  }
  return turns;
}

void append(const SixBar& six_bar, const SixBarState& state, int sense, std::vector<double>& states) {
  const SixBarTurns turns = turns_of(six_bar, state);
  const double gamma = std::asin(std::clamp(six_bar_transmission(six_bar, turns).sine, 0.0, 1.0));
  const Point b = state.joints[SixBar::b], d = state.joints[SixBar::d];
  states.insert(states.end(), {degrees(sense * state.turn), b.real(), b.imag(), d.real(), d.imag(),
                               state.body.origin.real(), state.body.origin.imag(), degrees(state.body.angle),
                               degrees(gamma), degrees(std::arg(turns[2])), degrees(std::arg(turns[3])), 0, 0});
  for (const Point joint : state.joints) states.insert(states.end(), {joint.real(), joint.imag()});
}

/// The row of each pose; −1 where the drive does not come to it.
std::vector<int> rows_of_poses(const SixBarCheck& check, const std::vector<PrescribedPose>& poses) {
  std::vector<int> rows(poses.size(), -1);
  if (!check.states.empty()) rows[0] = 0;
  for (const int pose : check.visited) {
    const auto& wanted = poses[static_cast<std::size_t>(pose)].pose;
    const auto nearest =
        std::min_element(check.states.begin(), check.states.end(), [&](const SixBarState& a, const SixBarState& b) {
          return std::abs(a.body.origin - wanted.origin) + std::abs(wrap_signed(a.body.angle - wanted.angle)) <
                 std::abs(b.body.origin - wanted.origin) + std::abs(wrap_signed(b.body.angle - wanted.angle));
        });
    rows[static_cast<std::size_t>(pose)] = static_cast<int>(nearest - check.states.begin());
  }
  return rows;
}

SixBarDriveTable drive_table_of(const std::optional<SixBarSolution>& found, const std::vector<PrescribedPose>& poses) {
  if (!found) return {};
  SixBarCheck check = driven(*found, poses);
  SixBarDriveTable drive;
  drive.row_of_pose = rows_of_poses(check, poses);
  drive.states = std::move(check.states);
  drive.sense = sense_of(*found);
  drive.dead_at_end = check.stopped;
  return drive;
}

void write_drive(JsonWriter& json, const SixBarDriveTable& drive) {
  const std::vector<int>& rows = drive.row_of_pose;
  const bool all = std::none_of(rows.begin(), rows.end(), [](int row) { return row < 0; });
  json.begin_object();
  json.member("width", static_cast<int>(six_bar_state_width));
  json.key("ticks");
  json.begin_list();
  for (std::size_t pose = 0; pose < rows.size(); ++pose) {
    json.begin_object(Layout::one_line);
    json.member("position", static_cast<int>(pose) + 1);
    json.member("state", rows[pose]);
    json.member("reached", rows[pose] >= 0);
    json.end_object();
  }
  json.end_list();
  json.member("full_turn", drive.full_turn);
  json.key("limits");
  json.begin_object(Layout::one_line);
  for (const auto& [end, is_dead] : {std::pair("low", drive.dead_at_start), std::pair("high", drive.dead_at_end)}) {
    json.key(end);
    is_dead ? json.value("dead_point") : json.null();
  }
  json.end_object();
  json.key("task");
  json.begin_list(Layout::one_line);
  json.value(all ? rows.front() : -1);
  json.value(all ? rows.back() : -1);
  json.end_list();
  json.end_object();
}

void write_joints(JsonWriter& json, const SixBar& six_bar) {
  json.key("joints");
  json.begin_list();
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint) {
    json.begin_object(Layout::one_line);
    json.member("name", joint_name(joint));
    json.member("ground", is_on_ground(six_bar.joints[joint]));
    json.key("at");
    write_point(json, six_bar.joints[joint].point);
    json.end_object();
  }
  json.end_list();
  json.key("bodies");
  json.begin_list();
  for (int body = 0; body < SixBar::bodies; ++body) {
    json.begin_list(Layout::one_line);
    for (const std::size_t joint : six_bar.joints_of(body)) json.value(static_cast<int>(joint));
    json.end_list();
  }
  json.end_list();
}

/// The two added links take the places of the grounded links: their coordinates are those of the map.
void write_added_link(JsonWriter& json, const char* side, double coordinate, const std::array<std::size_t, 2>& ends,
                      const std::optional<SixBarSolution>& found) {
  const auto end = [&](std::size_t which) {
    return found ? std::optional(found->member.six_bar.joints[ends[which]].point) : std::nullopt;
  };
  json.key(side);
  json.begin_object();
  json.member("coordinate", coordinate);
  json.key("center");
  write_point(json, end(0));
  json.key("circle");
  write_point(json, end(1));
  for (const auto& [key, which] : {std::pair("center_homogeneous", 0u), std::pair("circle_homogeneous", 1u)}) {
    const Point p = end(which).value_or(Point{});
    json.key(key);
    write_numbers(json, std::array{found ? 1.0 : 0.0, p.real(), p.imag()});
  }
  json.key("length");
  found ? json.value(std::abs(*end(1) - *end(0))) : json.null();
  json.end_object();
}

/// What a four-bar has and a six-bar has not.
void write_absent(JsonWriter& json) {
  for (const char* key : {"lengths", "min_transmission_angle_full_turn_deg", "swapped", "function"}) {
    json.key(key);
    json.null();
  }
  json.key("dead_points_deg");
  write_numbers(json, {});
}

void write_lengths(JsonWriter& json, const SixBarSolution& found) {
  json.key("lengths");
  json.begin_list();
  for (const SixBarLength& length : found.lengths) {
    json.begin_object(Layout::one_line);
    json.member("name", std::string_view(name(length)));
    json.member("length", length.length);
    json.end_object();
  }
  json.end_list();
}

Notice defect_reason(Defects defects) {
  if (defects.circuit()) return {"six_bar_circuit", "Circuit defect: some position needs taking it apart.", {}};
  if (defects.branch())
    return {"six_bar_branch", "Branch defect: it passes a dead point before it has passed all positions.", {}};
  return {"six_bar_order", "Order defect: it comes to the positions in another order.", {}};
}

void write_verdict(JsonWriter& json, const SixBarSolution& found) {
  const SixBarDriveReport& drive = found.rating.drive;
  const bool clean = drive.completed && drive.defects.none();
  json.member("type", name(found.rating.shape.type));
  json.key("defects");
  write_defects(json, drive.defects);
  json.key("reason");
  clean ? json.null() : write_notice(json, defect_reason(drive.defects));
  json.member("link_ratio", found.rating.shape.link_ratio);
  json.member("longest", found.rating.shape.longest);
  json.key("min_transmission_angle_deg");
  clean ? json.value(degrees(found.rating.min_transmission_angle())) : json.null();
  json.key("driver_sweep_deg");
  clean ? json.value(degrees(drive.sweep)) : json.null();
  json.key("drive_sense");
  drive.sense == DriveSense::none ? json.null() : json.value(name(drive.sense));
  json.member("residual", found.residual * found.rating.shape.longest);
}

void write_six_bar(JsonWriter& json, const SixBarSolution& found) {
  json.key("six_bar");
  json.begin_object();
  json.member("topology", name(found.row.topology));
  write_joints(json, found.member.six_bar);
  write_lengths(json, found);
  json.end_object();
}

void write_no_six_bar(JsonWriter& json) {
  json.member("type", name(LinkageType::degenerate));
  json.key("defects");
  json.begin_object(Layout::one_line);
  for (const char* defect : {"order", "branch", "circuit"}) json.member(defect, false);
  json.end_object();
  json.key("reason");
  write_notice(json, {"no_six_bar",
                      "There is no six-bar here: an added link has no hinge, no length, or is one "
                      "that is there already.",
                      {}});
  for (const char* key : {"link_ratio", "longest", "min_transmission_angle_deg", "driver_sweep_deg", "drive_sense"}) {
    json.key(key);
    json.null();
  }
  json.member("residual", 0.0);
}

}  // namespace

std::vector<double> six_bar_trace(const std::vector<PrescribedPose>& poses, const std::optional<SixBarSolution>& found,
                                  Point traced) {
  std::vector<double> path;
  if (!found) return path;
  for (const SixBarState& state : driven(*found, poses).states) {
    const Point p = displaced(traced, poses.front().pose, state.body);
    path.insert(path.end(), {p.real(), p.imag()});
  }
  return path;
}

LinkageReply six_bar_reply(const std::vector<PrescribedPose>& poses, const std::optional<SixBarSolution>& found,
                           MapPoint point, FailureBits fails) {
  return six_bar_reply(drive_table_of(found, poses), found, point, fails);
}

LinkageReply six_bar_reply(const SixBarDriveTable& drive, const std::optional<SixBarSolution>& found, MapPoint point,
                           FailureBits fails, const std::function<void(JsonWriter&)>& write_more) {
  LinkageReply reply;
  reply.linkage = json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("mechanism", "six_bar");
    json.key("tau");
    write_numbers(json, std::array{point.input, point.output});
    json.member("fails", int{fails});
    write_added_link(json, "input", point.input, {SixBar::c4, SixBar::z4}, found);
    write_added_link(json, "output", point.output, {SixBar::c5, SixBar::z5}, found);
    write_absent(json);
    if (found) {
      write_verdict(json, *found);
      write_six_bar(json, *found);
    } else {
      write_no_six_bar(json);
    }
    if (write_more) write_more(json);
    json.key("drive");
    drive.states.empty() ? json.null() : write_drive(json, drive);
    json.end_object();
  });
  if (found)
    for (const SixBarState& state : drive.states) append(found->member.six_bar, state, drive.sense, reply.states);
  return reply;
}

}  // namespace linkwright::wasm
