#include "linkwright/sweep/sweep_table.hpp"

#include <cstring>
#include <fmt/format.h>
#include <initializer_list>
#include <utility>

namespace linkwright {
namespace {

// As many bytes of UTF-8 as fit, whole characters only.
std::string_view fitting(std::string_view text, std::size_t width) {
  if (text.size() <= width) return text;
  std::size_t size = width;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size);
}

bool take(std::string_view& bytes, std::size_t count, std::string_view& taken) {
  if (bytes.size() < count) return false;
  taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return true;
}

constexpr bool by_default = true;

/// The list as it grows; `length` is the problem's unit.
class ColumnList {
 public:
  explicit ColumnList(const Problem& problem) : length_(problem.length_unit) {}

  void number(std::string name, std::string unit, std::string description, bool kept = false) {
    list_.push_back({number_column(std::move(name), std::move(unit), std::move(description)), kept});
  }
  void length(std::string name, std::string description, bool kept = false) {
    number(std::move(name), length_, std::move(description), kept);
  }
  void angle(std::string name, std::string description, bool kept = false) {
    number(std::move(name), "deg", std::move(description), kept);
  }
  void flag(std::string name, std::string description, bool kept = false) {
    list_.push_back({flag_column(std::move(name), std::move(description)), kept});
  }
  void text(std::string name, std::string description, bool kept = false) {
    constexpr std::size_t longest_word = 48;
    list_.push_back({text_column(std::move(name), longest_word, std::move(description)), kept});
  }
  /// x and y, or x, y and z.
  void coordinates(const std::string& name, std::string unit, const std::string& what, bool kept, int count) {
    constexpr std::string_view axes = "xyz";
    for (int k = 0; k < count; ++k)
      number(name + "[" + std::to_string(k) + "]", unit, what + ", " + axes[static_cast<std::size_t>(k)], kept);
  }
  void point(const std::string& name, const std::string& what, bool kept = false) {
    coordinates(name, length_, what, kept, 2);
  }
  void axis(const std::string& name, const std::string& what, bool kept = false) {
    coordinates(name, "", what, kept, 3);
  }
  void lengths(std::initializer_list<std::pair<const char*, const char*>> names) {
    for (const auto& [name, what] : names) length(std::string("lengths.") + name, what, by_default);
  }
  [[nodiscard]] const std::string& length_unit() const { return length_; }
  [[nodiscard]] std::vector<KeptColumn> take() { return std::move(list_); }

 private:
  std::string length_;
  std::vector<KeptColumn> list_;
};

void add_motion(ColumnList& list) {
  list.text("type", "Type of the linkage, of a six-bar that of its four-bar loop", by_default);
  list.flag("defects.order", "It reaches the positions in another order", by_default);
  list.flag("defects.branch", "It passes a dead point between positions", by_default);
  list.flag("defects.circuit", "Positions lie on different circuits", by_default);
  list.text("drive", "Sense in which the input turns through the positions: ccw, cw, either", by_default);
  list.angle("driver_sweep_deg", "How far the input turns from the first to the last position", by_default);
  list.angle("min_transmission_angle_deg", "Minimum transmission angle over the task", by_default);
}

void add_verdict(ColumnList& list) {
  list.number("residual", "", "Relative change of the grounded links' lengths over the positions");
  list.flag("local_optimum", "No neighbour on the map is better");
  list.flag("verified_by_driving", "Simulation of the motion confirms it", by_default);
}

void add_function(ColumnList& list) {
  list.angle("precision_error_deg", "Largest error of the output at the precision points");
  list.angle("max_structural_error_deg", "Largest error of the output over the range", by_default);
  list.angle("worst_input_deg", "Input where the error is largest");
  list.number("free_value", "", "Free parameter of the function");
}

void add_four_bar(ColumnList& list) {
  add_motion(list);
  list.angle("min_transmission_angle_full_turn_deg", "Minimum transmission angle over a full turn of the input");
  list.number("link_ratio", "", "Longest over shortest link", by_default);
  list.lengths({{"ground", "Length of the ground link"},
                {"input", "Length of the input link"},
                {"coupler", "Length of the coupler"},
                {"output", "Length of the output link"}});
  for (const std::string link : {"input", "output"}) {
    list.point(link + ".center_point", "Fixed pivot of the " + link, by_default);
    list.point(link + ".circle_point", "Moving pivot of the " + link + " in position 1", by_default);
    list.number(link + ".coordinate", "", "Place of the " + link + " on the axis of the map");
  }
  add_verdict(list);
}

void add_spherical(ColumnList& list) {
  add_motion(list);
  list.angle("min_transmission_angle_full_turn_deg", "Minimum transmission angle over a full turn of the input");
  list.text("triple_rocker", "Kind of triple rocker");
  for (const std::string link : {"ground", "input", "coupler", "output"})
    list.angle("angles_deg." + link, "Angle of the " + link, by_default);
  for (const std::string link : {"input", "output"}) {
    list.axis(link + ".fixed_axis", "Fixed axis of the " + link + ", unit vector", by_default);
    list.axis(link + ".moving_axis", "Moving axis of the " + link + " in position 1, unit vector", by_default);
    list.number(link + ".coordinate", "", "Place of the " + link + " on the axis of the map");
  }
  add_verdict(list);
}

void add_six_bar(ColumnList& list) {
  list.text("topology", "Watt and Stephenson kinds: watt_1, stephenson_2, …", by_default);
  add_motion(list);
  list.angle("min_transmission_angles_of_dyads_deg[0]", "Minimum transmission angle of the first dyad");
  list.angle("min_transmission_angles_of_dyads_deg[1]", "Minimum transmission angle of the second dyad");
  list.number("link_ratio", "", "Longest over shortest link", by_default);
  for (const std::string joint : {"a", "b", "d"}) list.point("joints." + joint, "Hinge of the chain", by_default);
  for (const std::string joint : {"c4", "z4", "c5", "z5"})
    list.point("joints." + joint, "End of an added link", by_default);
  for (const std::string added : {"added[0]", "added[1]"}) {
    list.text(added + ".between", "Bodies that the added link joins", by_default);
    list.number(added + ".coordinate", "", "Place of the added link on its curve");
  }
  list.number("pose_residual", "", "Error of the poses over their size");
  add_verdict(list);
}

void add_stroke(ColumnList& list, const std::string& over, const std::string& words) {
  list.length(over + ".max_deviation", "Largest deviation from the line over " + words);
  list.length(over + ".best_line_deviation", "The same from the line that fits best");
  list.angle(over + ".min_transmission_angle_deg", "Minimum transmission angle over " + words);
  list.number(over + ".velocity_nonuniformity", "", "Nonuniformity of the point's velocity over " + words);
  list.angle(over + ".crank_range_deg", "How far the input turns over " + words);
}

void add_straight_line(ColumnList& list) {
  list.text("case", "Case of straight lines whose map it lies on", by_default);
  list.number("layer", "", "Which of the linkages at its place of the map");
  list.coordinates("place", "", "Place on the map", false, 2);
  list.number("shape.turns", "", "Of a search of all cases: the sides of the line and the dyad, as bits");
  for (int k = 0; k < 4; ++k)
    list.number(fmt::format("shape.numbers[{}]", k), "", "Of a search of all cases: a number of the shape, 0 to 1");
  list.text("type", "Type of the linkage", by_default);
  list.angle("min_transmission_angle_deg", "Minimum transmission angle over the usable length", by_default);
  list.lengths({{"ground", "Length of the ground link"},
                {"input", "Length of the input link"},
                {"coupler", "Length of the coupler"},
                {"output", "Length of the output link"},
                {"point_to_input", "From the point to the moving pivot of the input"},
                {"point_to_output", "From the point to the moving pivot of the output"}});
  for (const std::string pivot : {"input_fixed", "input_moving", "output_moving", "output_fixed", "point"})
    list.point("pivots." + pivot, pivot == "point" ? "Guided point" : "Pivot", by_default);
  list.number("contact_points", "", "Points of contact with the line", by_default);
  list.length("deviation", "Deviation allowed", by_default);
  list.length("usable.length", "Length within the deviation from the tangent", by_default);
  list.length("usable_strip.length", "Length within the deviation from the best line", by_default);
  list.number("stroke_over_longest", "", "Usable length over the longest link", by_default);
  add_stroke(list, "over_usable", "the usable length");
  add_stroke(list, "stroke", "the stroke asked for");
  add_verdict(list);
}

struct ColumnsOfTask {
  ColumnList& list;

  void operator()(const MotionTask&) const { add_four_bar(list); }
  void operator()(const FunctionTask&) const {
    add_four_bar(list);
    add_function(list);
  }
  void operator()(const SixBarTask&) const { add_six_bar(list); }
  void operator()(const SphericalMotionTask&) const { add_spherical(list); }
  void operator()(const SphericalFunctionTask&) const {
    add_spherical(list);
    add_function(list);
  }
  void operator()(const StraightLineTask&) const { add_straight_line(list); }
};

bool errs_by_angle(const Task& task) {
  return output_kind(task) == OutputKind::angle || output_kind(task) == OutputKind::turn;
}

void add_tolerances(ColumnList& list, const Task& task) {
  const std::string unit = errs_by_angle(task) ? "deg" : list.length_unit();
  list.number("tolerance.error", unit, "Error by tolerances, to first order (root mean square)", by_default);
  list.number("tolerance.error_sampled", unit, "The same of linkages sampled");
  list.number("tolerance.worst_case", unit, "Worst case of the tolerances");
  list.number("tolerance.mean_plus_3_sigma", unit, "Mean and three standard deviations of the linkages sampled");
  list.number("tolerance.signal_to_noise_db", "dB", "Signal-to-noise ratio");
  list.number("tolerance.yield", "", "Share of linkages within the limit", by_default);
  list.number("tolerance.yield_interval[0]", "", "Lower end of the yield's 95 % interval");
  list.number("tolerance.yield_interval[1]", "", "Upper end of the yield's 95 % interval");
  list.number("tolerance.not_assembled", "", "Share of linkages that cannot be assembled");
}

}  // namespace

SweepColumn number_column(std::string name, std::string unit, std::string description) {
  return {std::move(name), ColumnKind::number, sizeof(double), std::move(unit), std::move(description)};
}

SweepColumn count_column(std::string name, std::string description) {
  return {std::move(name), ColumnKind::count, sizeof(std::int64_t), "", std::move(description)};
}

SweepColumn flag_column(std::string name, std::string description) {
  return {std::move(name), ColumnKind::flag, 1, "", std::move(description)};
}

SweepColumn text_column(std::string name, std::size_t width, std::string description) {
  return {std::move(name), ColumnKind::text, width, "", std::move(description)};
}

void TableRows::put_bytes(const void* bytes, std::size_t count) {
  columns_[next_].append(static_cast<const char*>(bytes), count);
  if (++next_ < columns_.size()) return;
  next_ = 0;
  ++rows_;
}

void TableRows::put(std::string_view text, std::size_t width) {
  std::string padded(fitting(text, width));
  padded.resize(width, '\0');
  put_bytes(padded.data(), padded.size());
}

void TableRows::append(const TableRows& more) {
  for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k] += more.columns_[k];
  rows_ += more.rows_;
}

SweepRows::SweepRows(const SweepColumns& columns) {
  for (std::size_t t = 0; t < tables_.size(); ++t) tables_[t] = TableRows(columns[t].size());
}

void SweepRows::append(const SweepRows& more) {
  for (std::size_t t = 0; t < tables_.size(); ++t) tables_[t].append(more.tables_[t]);
}

std::string SweepRows::to_bytes() const {
  std::string bytes;
  for (const TableRows& table : tables_) {
    const std::uint64_t rows = table.rows_;
    bytes.append(reinterpret_cast<const char*>(&rows), sizeof rows);
    for (const std::string& column : table.columns_) bytes += column;
  }
  return bytes;
}

bool SweepRows::from_bytes(std::string_view bytes, const SweepColumns& columns) {
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    TableRows& table = tables_[t];
    table = TableRows(columns[t].size());
    std::string_view taken;
    if (!take(bytes, sizeof(std::uint64_t), taken)) return false;
    std::uint64_t rows = 0;
    std::memcpy(&rows, taken.data(), sizeof rows);
    for (std::size_t k = 0; k < columns[t].size(); ++k) {
      if (rows > bytes.size() || !take(bytes, rows * columns[t][k].width, taken)) return false;
      table.columns_[k] = taken;
    }
    table.rows_ = rows;
  }
  return bytes.empty();
}

std::vector<KeptColumn> keepable_columns(const Problem& problem) {
  ColumnList list(problem);
  std::visit(ColumnsOfTask{list}, problem.task);
  if (problem.options.tolerances) add_tolerances(list, problem.task);
  return list.take();
}

}  // namespace linkwright
