#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/analyses/load_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr int force_digits = 3;

std::string number(const std::optional<double>& value) { return value ? significant_text(*value, force_digits) : "–"; }

std::string turn(const std::optional<LoadPlace>& at) { return at ? angle_text(std::abs(at->body_turn), 1) : "never"; }

std::string torque_unit(const Loads& loads) { return loads.metres ? "N·m" : "N × unit"; }

std::string in_newtons(const std::optional<WorstOfCases>& worst) {
  return worst ? significant_text(worst->value, force_digits) : "–";
}

void add_hand(TextTable& table, const LoadReport& report) {
  for (const CaseReport& of : report.cases)
    table.add_row({printable(of.name), number(of.max_open_force), number(of.max_close_force), number(of.hold_open),
                   number(of.close_start), number(of.hump), number(of.pop_up), turn(of.self_rise),
                   turn(of.self_close)});
}

std::string hand_table(const LoadReport& report) {
  TextTable table(
      {"<case", "open", "close", "hold open", "close start", "hump", "pop up", "rises from", "closes from"});
  add_hand(table, report);
  return "\nForces of the hand, N (negative: it moves by itself); turns of the body from position 1:\n" + table.text();
}

std::string pins_table(const LoadStudy& study) {
  const bool by_torque = study.loads.drive == LoadDrive::input || study.loads.drive == LoadDrive::output;
  std::vector<std::string> heads = {"<case"};
  for (const std::string_view joint : four_bar_joint_names) heads.emplace_back(joint);
  if (by_torque) heads.push_back("torque, " + torque_unit(study.loads));
  if (study.loads.drive == LoadDrive::cylinder) heads.emplace_back("cylinder, N");
  if (has_inertia(study.loads)) heads.emplace_back("on the ground, N");
  TextTable table(heads);
  for (const CaseReport& of : study.report.cases) {
    std::vector<std::string> row = {printable(of.name)};
    for (const auto& pin : of.pins) row.push_back(pin ? significant_text(pin->force, force_digits) : "–");
    if (by_torque) row.push_back(number(of.max_torque));
    if (study.loads.drive == LoadDrive::cylinder) row.push_back(number(of.cylinder_force));
    if (has_inertia(study.loads)) row.push_back(of.shaking ? significant_text(of.shaking->force, force_digits) : "–");
    table.add_row(row);
  }
  return "\nLargest forces of the pins, N:\n" + table.text();
}

std::string springs_table(const LoadStudy& study) {
  const auto& uses = study.report.cases.front().springs;
  if (uses.empty()) return "";
  TextTable table({"<spring", "shortest", "longest", "stroke left", "<leaves its stroke"});
  for (const SpringUse& use : uses)
    table.add_row({printable(use.name), significant_text(use.shortest, 4), significant_text(use.longest, 4),
                   number(use.stroke_left), use.bottoms_at ? "at " + turn(use.bottoms_at) : "no"});
  const std::string unit = study.length_unit.empty() ? "" : ", " + printable(study.length_unit);
  return "\nSprings" + unit + ":\n" + table.text();
}

/// Of the spring that leaves its strength free.
std::string strength_words(const LoadReport& report) {
  if (report.best_f1)
    return wrapped(fmt::format("F1 that is left free: {} N has the least force of the hand.",
                               significant_text(*report.best_f1, 4)));
  return report.why_no_f1 ? wrapped("F1 that is left free: there is none. " + report.why_no_f1->message) : "";
}

std::string rest_words(const LoadReport& report) {
  std::string text;
  for (const CaseReport& of : report.cases) {
    for (const Equilibrium& rest : of.equilibria)
      text += wrapped(fmt::format("{}: in balance at {} of the body, {}.", printable(of.name),
                                  angle_text(std::abs(rest.at.body_turn), 1), rest.stable ? "stable" : "not stable"));
    for (const RestBand& band : of.rests)
      text += wrapped(fmt::format("{}: friction holds it from {} to {} of the body.", printable(of.name),
                                  angle_text(std::abs(band.from.body_turn), 1),
                                  angle_text(std::abs(band.to.body_turn), 1)));
    if (of.locks)
      text +=
          wrapped(fmt::format("{}: somewhere on the way nothing moves it: friction holds it, or hand or drive act "
                              "across it.",
                              printable(of.name)));
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string load_words(const LoadStudy& study) {
  std::string text;
  if (study.loads.handle) text += hand_table(study.report);
  return text + pins_table(study) + springs_table(study) + strength_words(study.report) + rest_words(study.report);
}

namespace {

std::string stud_words(const CarriedPoint& stud) {
  const std::string at =
      fmt::format("({}, {})", significant_text(stud.at.real(), 5), significant_text(stud.at.imag(), 5));
  return stud.on == LoadedBody::ground ? at + " on the ground"
                                       : fmt::format("{} along and across the {}", at, name(stud.on));
}

std::string spring_line(const LoadStudy& study, const BalanceSpring& spring) {
  const std::string unit = study.length_unit.empty() ? "unit of length" : printable(study.length_unit);
  return wrapped(fmt::format("  {} N per {} from {} to {}.", significant_text(spring.rate, 5), unit,
                             stud_words(spring.from), stud_words(spring.to)));
}

}  // namespace

namespace {

std::string real_spring_line(const LoadStudy& study, const Spring& spring) {
  const auto& coil = std::get<CoilSpring>(spring.law);
  const std::string unit = study.length_unit.empty() ? "unit of length" : printable(study.length_unit);
  return wrapped(fmt::format("  {} N per {}, free length {}, from {} to {}.", significant_text(coil.rate, 5), unit,
                             significant_text(coil.free_length, 5), stud_words(spring.from), stud_words(spring.to)));
}

std::string real_balance_words(const LoadStudy& study, const RealBalance& of) {
  const bool is_one = of.springs.size() == 1;
  const std::string ends =
      is_one ? fmt::format("One spring to the {} leaves", name(of.springs.front().to.on)) : "Two springs leave";
  std::string text =
      wrapped(fmt::format("{} {} N at most:", ends, significant_text(of.residual_hand_force, force_digits)));
  for (const Spring& spring : of.springs) text += real_spring_line(study, spring);
  return text;
}

/// As near to a balance as springs with a free length come.
std::string real_springs_words(const LoadStudy& study) {
  const auto& [of_case, balance, real, why_not] = *study.balance;
  if (!real) return why_not ? "\n" + wrapped("No springs with a free length: " + why_not->message) : "";
  const std::string length = real->free_share > 0
                                 ? fmt::format("of {} of their shortest length", significant_text(real->free_share, 3))
                                 : "that was given";
  std::string text = "\n" + wrapped(fmt::format("By springs with a free length {} (the best of many places; the hand "
                                                "feels {} N at most without any):",
                                                length, significant_text(real->hand_force_without, force_digits)));
  if (real->two) text += real_balance_words(study, *real->two);
  if (real->one) text += real_balance_words(study, *real->one);
  return real->two || real->one ? text : text + "none helps.\n";
}

}  // namespace

std::string balance_words(const LoadStudy& study) {
  if (!study.balance)
    return "\n" + wrapped("No balance: a force that turns with its link has no energy to be held in balance.");
  const std::string& of_case = study.balance->name;
  const Balance& balance = study.balance->balance;
  if (balance.two_springs.empty()) return "\n" + wrapped("It is in balance anywhere: there is no weight.");
  const bool one_suffices = balance.two_springs.size() == 1;
  std::string text =
      "\n" + wrapped(fmt::format("In balance anywhere ({}; in place of its springs) by {} of no free length:",
                                 printable(of_case), one_suffices ? "a spring" : "two springs"));
  for (const BalanceSpring& spring : balance.two_springs) text += spring_line(study, spring);
  if (balance.one_spring && !balance.why_not_one)
    text += "or by one:\n" + spring_line(study, *balance.one_spring);
  else if (balance.why_not_one && !one_suffices)
    text += wrapped("By one: " + balance.why_not_one->message);
  if (!balance.counterweights.empty()) text += "or by counterweights:\n";
  for (const CounterWeight& weight : balance.counterweights)
    text +=
        wrapped(fmt::format("  {} kg at {}.", significant_text(weight.mass, 5), stud_words({weight.on, weight.at})));
  return text + real_springs_words(study);
}

std::optional<std::string> load_score(const Findings& found, std::size_t place) {
  const Measure& by = measure_of(found.options.objective);
  if (place >= found.loads.size() || !found.loads[place]) return "–";
  const LoadReport& report = *found.loads[place];
  if (by == measures::best_f1) return number(report.best_f1) + " N";
  for (const auto& [measure, read_out] :
       {std::pair{&measures::self_rise, ReadOut::self_rise}, std::pair{&measures::self_close, ReadOut::self_close}})
    if (by == *measure) {
      const auto& worst = report.worst_of(read_out);
      return worst ? angle_text(worst->value, 1) : "never";
    }
  for (std::size_t k = 0; k < read_outs; ++k)
    if (by.key == read_out_names[k])
      return in_newtons(report.worst[k]) +
             (by == measures::max_torque ? " " + torque_unit(*found.options.loads) : " N");
  return "–";
}

std::string loads_table(const Findings& found) {
  if (!found.options.loads || found.loads.empty()) return "";
  const Loads& loads = *found.options.loads;
  const bool by_torque = loads.drive == LoadDrive::input || loads.drive == LoadDrive::output;
  std::vector<std::string> heads = {"#"};
  if (loads.handle) heads.insert(heads.end(), {"open", "close", "hold open"});
  heads.emplace_back("largest pin");
  if (by_torque) heads.push_back("torque, " + torque_unit(loads));
  if (loads.drive == LoadDrive::cylinder) heads.emplace_back("cylinder");
  TextTable table(heads);
  for (std::size_t i = 0; i < found.loads.size(); ++i) {
    std::vector<std::string> row(heads.size(), "–");
    row.front() = fmt::format("{}", i + 1);
    if (const auto& report = found.loads[i]) {
      row.resize(1);
      if (loads.handle)
        for (const ReadOut each : {ReadOut::max_open_force, ReadOut::max_close_force, ReadOut::hold_open})
          row.push_back(in_newtons(report->worst_of(each)));
      row.push_back(in_newtons(report->worst_of(ReadOut::max_pin_force)));
      if (by_torque) row.push_back(in_newtons(report->worst_of(ReadOut::max_torque)));
      if (loads.drive == LoadDrive::cylinder) row.push_back(in_newtons(report->worst_of(ReadOut::cylinder_force)));
    }
    table.add_row(row);
  }
  const std::string worst = loads.cases.size() < 2 ? "" : fmt::format(" the worst of {} cases", loads.cases.size());
  return "\n" + wrapped(fmt::format("Loads:{} over the travel, N.", worst)) + table.text();
}

}  // namespace linkwright::cli
