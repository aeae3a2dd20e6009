#include "linkwright/analyses/load_study.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "analyses/listed_place.hpp"
#include "files/document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/listed_problem.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "loads_analysis.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright {

Error no_loads() {
  return {"no_loads_in_result", "problem.loads",
          "the problem of this result has no loads; add \"loads\" beside its \"task\" and solve it again"};
}

namespace {

/// Leaves the one case.
std::optional<Error> keep_case(Loads& loads, const std::string& name) {
  loads.cases = cases_of(loads);
  std::erase_if(loads.cases, [&](const LoadCase& of) { return of.name != name; });
  if (!loads.cases.empty()) return std::nullopt;
  return Error{"unknown_case", "--case", fmt::format("the loads have no case \"{}\"", name), {{"name", name}}};
}

/// Of the last columns of a row.
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string csv_quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::vector<std::string> columns_of(const Loads& loads) {
  std::vector<std::string> columns = {"driver_turn_deg", "body_turn_deg",  "path",     "open_N",
                                      "close_N",         "frictionless_N", "energy_J", "torque_Nm"};
  for (std::size_t k = 0; k < loads.springs.size(); ++k) {
    if (std::holds_alternative<TorsionSpring>(loads.springs[k].law)) continue;
    columns.push_back(csv_quoted(spring_name(loads, k) + ".length"));
    columns.push_back(csv_quoted(spring_name(loads, k) + ".force_N"));
  }
  for (const std::string_view joint : four_bar_joint_names) {
    columns.push_back(fmt::format("{}.x_N", joint));
    columns.push_back(fmt::format("{}.y_N", joint));
  }
  if (loads.drive == LoadDrive::cylinder) columns.insert(columns.end(), {"cylinder_N", "pressure_angle_deg"});
  if (has_inertia(loads))
    columns.insert(columns.end(), {"time_s", "driver_rad_per_s", "driver_rad_per_s2", "shaking.x_N", "shaking.y_N"});
  return columns;
}

std::vector<double> row_of(const Loads& loads, const LoadStation& station) {
  std::vector<double> row = {degrees_for_files(station.at.driver_turn),
                             degrees_for_files(station.at.body_turn),
                             station.at.path_share.value_or(none),
                             station.open.value_or(none),
                             station.close.value_or(none),
                             station.frictionless.value_or(none),
                             station.energy.value_or(none),
                             station.torque.value_or(none)};
  for (const auto& spring : station.springs)
    if (spring) row.insert(row.end(), {spring->length, spring->force});
  for (std::size_t k = 0; k < four_bar_joints; ++k) {
    const Point joint = station.joints ? (*station.joints)[k] : Point{none, none};
    row.insert(row.end(), {joint.real(), joint.imag()});
  }
  if (loads.drive == LoadDrive::cylinder) {
    row.push_back(station.cylinder_force.value_or(none));
    row.push_back(station.pressure_angle ? degrees_for_files(*station.pressure_angle) : none);
  }
  if (has_inertia(loads)) {
    const auto is = station.motion.value_or(LoadStation::InMotion{none, none, none, {none, none}});
    row.insert(row.end(), {is.time, is.speed, is.acceleration, is.shaking.real(), is.shaking.imag()});
  }
  return row;
}

}  // namespace

LoadStudy load_study(const Problem& problem, const Answer& answer, std::size_t place, int between) {
  const Findings& found = findings(answer);
  const auto output = listed_outputs(answer, 0)[place];
  const auto& planar = std::get<PlanarOutput>(*output);
  const std::vector<PrescribedPose> poses = poses_of(planar);
  const Loads loads = loads_as_used(*found.options.loads, planar.positions.front().bars, poses);
  LoadStudy study{problem.title, problem.length_unit, loads, *found.loads[place], {}, {}};
  for (const LoadCase& of : cases_of(loads))
    study.curves.push_back(load_curve(loads, of, planar.positions.front().bars, poses, between));
  const LoadCase first = cases_of(loads).front();
  if (auto balance = exact_balance(loads, first, planar.positions.front().bars, poses.front().pose))
    study.balance = BalanceOfCase{first.name, *std::move(balance), {}, {}};
  return study;
}

static void add_real_springs(LoadStudy& study, const Answer& answer, std::size_t place,
                             const RealBalanceOptions& options) {
  const auto output = listed_outputs(answer, 0)[place];
  const auto& planar = std::get<PlanarOutput>(*output);
  auto found = real_balance(study.loads, cases_of(study.loads).front(), planar.positions.front().bars, poses_of(planar),
                            options);
  study.balance->real = std::move(found.found);
  study.balance->why_not_real = std::move(found.why_not);
}

/// Gives the spring that leaves its strength free that of the linkage in all cases, before one of them is left.
static std::vector<Error> settle_strength(Problem& problem, int layer) {
  const auto solved = solved_place(problem, layer);
  if (!solved) return solved.errors();
  const auto output = listed_outputs(solved->answer, 0)[solved->place];
  if (const auto* planar = output ? std::get_if<PlanarOutput>(&*output) : nullptr)
    problem.options.loads = loads_as_used(*problem.options.loads, planar->positions.front().bars, poses_of(*planar));
  return {};
}

Result<LoadStudy> listed_loads(std::string_view text, int linkage, const LoadChanges& changes) {
  if (auto mistakes = mistakes_in(changes.real_springs); !mistakes.empty()) return mistakes;
  auto listed = read_listed_problem(text, linkage);
  if (!listed) return listed.errors();
  auto& loads = listed->problem.options.loads;
  if (!loads) return no_loads();
  if (changes.only_case) {
    if (free_spring(*loads))
      if (auto mistakes = settle_strength(listed->problem, listed->layer); !mistakes.empty()) return mistakes;
    if (auto mistake = keep_case(*loads, *changes.only_case)) return *std::move(mistake);
  }
  auto solved = solved_place(std::move(listed->problem), listed->layer);
  if (!solved) return solved.errors();
  const auto& [problem, answer, place] = *solved;
  if (!findings(answer).loads[place])
    return Error{"no_travel", "linkages",
                 "this linkage does not get through its positions in order without a dead point, so that it has no "
                 "forces from the first to the last"};
  LoadStudy study = load_study(problem, answer, place);
  if (study.balance) add_real_springs(study, answer, place, changes.real_springs);
  study.title += fmt::format("{}linkage {}", study.title.empty() ? "" : ", ", linkage);
  return study;
}

std::optional<Loads> loads_of_result(std::string_view text) {
  const auto listed = read_listed_problem(text, 1);
  return listed ? listed->problem.options.loads : std::nullopt;
}

static void fields(FieldVisitor& v, const LoadStudy& of) {
  Loads loads = of.loads;
  v.object({"load_study", "Of one linkage of a result, with the loads that were used.", true}, [&](FieldVisitor& to) {
    head_fields(to, of);
    to.member("loads", true, [&](FieldVisitor& at) {
      at.described_in("problem.schema.json#/$defs/loads", [&](FieldVisitor& in) { fields(in, loads); });
    });
    to.shown("report", of.report);
    to.shown(Field("balance", "Null where a force turns with its link."), of.balance);
  });
}

Shape load_study_document() {
  return {JsonType::object, [](FieldVisitor& v) { fields(v, LoadStudy{}); }};
}

std::string write_load_study(const LoadStudy& study) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, study); });
}

std::string load_table(const LoadStudy& study) {
  std::string text = fmt::format("case,{}\n", fmt::join(columns_of(study.loads), ","));
  const std::vector<LoadCase> cases = cases_of(study.loads);
  for (std::size_t k = 0; k < study.curves.size(); ++k)
    for (const LoadStation& station : study.curves[k]) {
      text += csv_quoted(cases[k].name);
      for (const double value : row_of(study.loads, station))
        text += std::isnan(value) ? std::string(",") : "," + exact_text(value);
      text += "\n";
    }
  return text;
}

}  // namespace linkwright
