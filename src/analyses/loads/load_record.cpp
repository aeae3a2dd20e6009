#include "files/fields/result_forms.hpp"
#include "files/problem_fields.hpp"
#include "files/result_fields.hpp"
#include "linkwright/files/number_text.hpp"
#include "loads_analysis.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const LoadPlace& at) {
  v.object({.name = "load_place", .about = "A place of the travel, seen from position 1."}, [&](FieldVisitor& to) {
    to.shown("driver_turn_deg", degrees_for_files(at.driver_turn));
    to.shown("body_turn_deg", degrees_for_files(at.body_turn));
    to.shown(Field("path", "Share of the handle's way; null without a handle."), at.path_share, forms::share);
  });
}

static void fields(FieldVisitor& v, const Equilibrium& rest) {
  v.object({.name = "equilibrium"}, [&](FieldVisitor& to) {
    to.shown("at", rest.at);
    to.shown("stable", rest.stable);
    to.shown(Field("stiffness", "Of the driver, N·m per radian."), rest.stiffness);
  });
}

static void fields(FieldVisitor& v, const RestBand& band) {
  v.object({.name = "rest_band"}, [&](FieldVisitor& to) {
    to.shown("from", band.from);
    to.shown("to", band.to);
  });
}

static void fields(FieldVisitor& v, const ForcePeak& peak) {
  v.object({.name = "force_peak"}, [&](FieldVisitor& to) {
    to.shown("max", peak.force, forms::not_negative);
    to.shown("at", peak.at);
  });
}

static void fields(FieldVisitor& v, const SpringUse& use) {
  v.object({.name = "spring_use"}, [&](FieldVisitor& to) {
    to.shown("name", use.name);
    to.shown("length", std::array{use.shortest, use.longest},
             Pair{.form = "[shortest, longest]", .each = forms::not_negative});
    to.shown(Field("stroke_left", "Of gas springs: beyond the largest compression used."), use.stroke_left);
    to.shown(Field("bottoms_at", "Where it is first too short or too long; null: nowhere."), use.bottoms_at);
    to.shown(Field("least_lever", "Least change of length by the handle's way."), use.least_lever, forms::not_negative);
  });
}

static void fields(FieldVisitor& v, const CaseReport& of) {
  v.object({.name = "load_case_report", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("name", of.name);
    to.shown(Field("max_open_force", "N, over the travel; negative: no hand is needed. Null without a handle."),
             of.max_open_force);
    to.shown("max_close_force", of.max_close_force);
    to.shown("hold_open", of.hold_open);
    to.shown("close_start", of.close_start);
    to.shown("hump", of.hump);
    to.shown("pop_up", of.pop_up);
    to.shown(Field("self_rise", "From here on it opens by itself; null: it does not."), of.self_rise);
    to.shown(Field("self_close", "From here down it closes by itself; null: it does not."), of.self_close);
    to.shown("equilibria", of.equilibria, forms::on_a_line);
    to.shown(Field("rests", "Where friction holds it."), of.rests, forms::on_a_line);
    to.member("pins", true, [&](FieldVisitor& in) {
      in.object({.name = "pin_peaks", .on_lines = true}, [&](FieldVisitor& each) {
        for (std::size_t k = 0; k < four_bar_joints; ++k) each.shown(four_bar_joint_names[k], of.pins[k]);
      });
    });
    to.shown_if_any(Field("shaking", "Largest force of the moving links on the ground, in motion."), of.shaking);
    to.shown(Field("max_torque", "Of the driving crank, N·m; null: another drive."), of.max_torque);
    to.shown("cylinder_force", of.cylinder_force);
    to.shown("springs", of.springs, forms::on_lines);
    to.shown(Field("locks", "No effort moves it somewhere: friction holds it, or hand or drive act across its way."),
             of.locks);
  });
}

namespace {

struct WorstRecord {
  double value = 0;
  std::string of;
};

}  // namespace

static void fields(FieldVisitor& v, const WorstRecord& worst) {
  v.object({.name = "worst_of_cases"}, [&](FieldVisitor& to) {
    to.shown("value", worst.value);
    to.shown("case", worst.of);
  });
}

static double value_for_files(const WorstOfCases& worst, ReadOut read_out) {
  const bool is_turn = read_out == ReadOut::self_rise || read_out == ReadOut::self_close;
  return is_turn ? degrees_for_files(worst.value) : worst.value;
}

void fields(FieldVisitor& v, const LoadReport& report) {
  v.object(
      {.name = "load_report", .about = "The forces in the linkage from position 1 to the last one.", .on_lines = true},
      [&](FieldVisitor& to) {
        to.shown("cases", report.cases, forms::on_lines);
        to.member(Field("worst",
                        "Of the cases that count; self_rise and self_close as absolute turns of the body from "
                        "position 1, degrees."),
                  true, [&](FieldVisitor& in) {
                    in.object({.name = "worst_read_outs", .on_lines = true}, [&](FieldVisitor& each) {
                      for (std::size_t k = 0; k < read_outs; ++k) {
                        const auto& worst = report.worst[k];
                        const auto shown =
                            worst ? std::optional(WorstRecord{value_for_files(*worst, static_cast<ReadOut>(k)),
                                                              report.cases[worst->of].name})
                                  : std::nullopt;
                        each.shown_if_any(read_out_names[k], shown);
                      }
                    });
                  });
        to.shown_if_any(Field("best_F1", "Of the spring that leaves it free, N: all the rest is told of it."),
                        report.best_f1);
        to.shown_if_any(Field("why_no_F1",
                              "No strength does what is asked of it: there is no worst, and the cases are those of the "
                              "forces that are given."),
                        report.why_no_f1);
      });
}

void loads_field(FieldVisitor& v, const Findings* found, std::size_t place) {
  const bool is_told = found && place < found->loads.size();
  const std::optional<LoadReport> none;
  v.member(Field("loads",
                 "Only with loads; null where the linkage does not get through its positions in order without "
                 "a dead point.")
               .written(is_told),
           false, [&](FieldVisitor& to) {
             visit_or_null(to, is_told ? found->loads[place] : none,
                           [&](FieldVisitor& in, const LoadReport& report) { fields(in, report); });
           });
}

void list_loads(LinkageColumns& list, const Loads& loads) {
  const auto column = [&](ReadOut read_out, const char* unit, const char* about, bool is_usual) {
    if (has_value(read_out, loads))
      list.number(std::string("loads.worst.") + std::string(name(read_out)) + ".value", unit, about, is_usual);
  };
  column(ReadOut::max_open_force, "N", "Largest force of the hand while opening, the worst of the cases",
         LinkageColumn::usual);
  column(ReadOut::max_close_force, "N", "Largest force of the hand while closing", LinkageColumn::usual);
  column(ReadOut::hand_force, "N", "The larger of both", false);
  column(ReadOut::hold_open, "N", "Least force that holds the last position open", LinkageColumn::usual);
  column(ReadOut::pop_up, "N", "Least force by which it rises in position 1", false);
  column(ReadOut::close_start, "N", "Largest force that starts to close it", false);
  column(ReadOut::hump, "N", "Largest force of closing above that", false);
  column(ReadOut::self_rise, "deg", "Turn of the body from which it rises by itself, the largest of the cases", false);
  column(ReadOut::self_close, "deg", "Turn of the body down from which it closes by itself, the least of the cases",
         false);
  if (free_spring(loads))
    list.number("loads.best_F1", "N", "F1 of the spring that leaves it free: the one with the least force of the hand",
                LinkageColumn::usual);
  column(ReadOut::max_pin_force, "N", "Largest force of a pin", LinkageColumn::usual);
  column(ReadOut::max_torque, loads.metres ? "N·m" : "N·unit", "Largest torque of the driving crank",
         LinkageColumn::usual);
  column(ReadOut::cylinder_force, "N", "Largest force of the cylinder", LinkageColumn::usual);
}

}  // namespace linkwright
