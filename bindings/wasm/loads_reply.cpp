#include <functional>

#include "analyses/loads/loads_analysis.hpp"
#include "files/fields/result_forms.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

namespace linkwright::wasm {
namespace {

/// Steps from position to position, which look smooth.
constexpr int drawn_between = 12;

using Value = std::function<std::optional<double>(const LoadStation& station)>;

void column(FieldVisitor& v, const Field& field, const LoadCurve& of, const Value& value) {
  std::vector<std::optional<double>> values;
  if (of.stations)
    for (const LoadStation& station : *of.stations) values.push_back(value(station));
  v.shown(field, values, forms::on_a_line);
}

}  // namespace

static void fields(FieldVisitor& v, const LoadCurve& of) {
  v.object({.name = "load_curve", .about = "A value a station; null: there is none.", .on_lines = true},
           [&](FieldVisitor& to) {
             to.shown("name", of.name);
             column(to, "driver_turn_deg", of, [](const auto& s) { return degrees_for_files(s.at.driver_turn); });
             column(to, "body_turn_deg", of, [](const auto& s) { return degrees_for_files(s.at.body_turn); });
             column(to, Field("path", "Share of the handle's way."), of, [](const auto& s) { return s.at.path_share; });
             column(to, Field("position", "Of the task, from 1."), of,
                    [](const auto& s) { return s.position ? std::optional(*s.position + 1.0) : std::nullopt; });
             column(to, Field("open", "N."), of, [](const auto& s) { return s.open; });
             column(to, "close", of, [](const auto& s) { return s.close; });
             column(to, Field("torque", "N·m, of the driving crank."), of, [](const auto& s) { return s.torque; });
             column(to, Field("time", "s from position 1, in motion."), of,
                    [](const auto& s) { return s.motion ? std::optional(s.motion->time) : std::nullopt; });
             column(to, Field("shaking", "N on the ground, in motion."), of,
                    [](const auto& s) { return s.motion ? std::optional(std::abs(s.motion->shaking)) : std::nullopt; });
             column(to, Field("pin", "N, the largest of the four while opening."), of, [](const auto& s) {
               std::optional<double> most;
               if (s.joints)
                 for (const Point joint : *s.joints) most = std::max(most.value_or(0), std::abs(joint));
               return most;
             });
           });
}

/// The lengths of a linear spring, which are the same in all cases, and its stroke.
struct SpringCurve {
  std::string name;
  std::optional<std::array<double, 2>> stroke;
  std::vector<double> length;
};

namespace {

std::vector<SpringCurve> spring_curves(const LoadFigures& of) {
  std::vector<SpringCurve> curves;
  for (std::size_t k = 0; k < of.loads.springs.size(); ++k) {
    const auto& law = of.loads.springs[k].law;
    if (std::holds_alternative<TorsionSpring>(law) || of.curves.empty()) continue;
    SpringCurve curve{spring_name(of.loads, k), {}, {}};
    if (const auto* gas = std::get_if<GasSpring>(&law))
      curve.stroke = std::array{gas->extended_length - gas->stroke, gas->extended_length};
    for (const LoadStation& station : *of.curves.front().stations)
      curve.length.push_back(station.springs[k] ? station.springs[k]->length : 0);
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace

static void fields(FieldVisitor& v, const SpringCurve& of) {
  v.object({.name = "spring_curve"}, [&](FieldVisitor& to) {
    to.shown("name", of.name);
    to.shown(Field("stroke", "Least and largest length; null: no gas spring."), of.stroke,
             Pair{.form = "[least, largest]"});
    to.shown("length", of.length, forms::numbers);
  });
}

void fields(FieldVisitor& v, const LoadFigures& of) {
  v.object({.name = "loads_reply", .on_lines = true}, [&](FieldVisitor& to) {
    member_of_results(to, "loads", "load_report", of.report);
    to.shown("curves", of.curves, forms::on_lines);
    to.shown("springs", spring_curves(of), forms::on_lines);
  });
}

std::string loads_reply(const LinkageLoads& on) {
  const auto& [given, bars, poses] = on;
  const auto report = load_report(given, bars, poses);
  if (!report) return "";
  const Loads loads = loads_as_used(given, bars, poses);
  std::vector<std::vector<LoadStation>> stations;
  std::vector<LoadCurve> curves;
  const std::vector<LoadCase> cases = cases_of(loads);
  for (const LoadCase& of : cases) stations.push_back(load_curve(loads, of, bars, poses, drawn_between));
  for (std::size_t k = 0; k < cases.size(); ++k) curves.push_back({cases[k].name, &stations[k]});
  const KeptVisit told = [&](FieldVisitor& v) { linkwright::fields(v, *report); };
  return text_of(LoadFigures{told, curves, loads});
}

}  // namespace linkwright::wasm
