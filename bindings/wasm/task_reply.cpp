#include "task_reply.hpp"

#include <cmath>

#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

constexpr int ticks_of_a_branch = 12;

void append(std::vector<double>& numbers, Homogeneous point) {
  const Homogeneous unit = normalized(point);
  numbers.insert(numbers.end(), {unit.w, unit.x, unit.y});
}

std::uint8_t branch_of(const std::vector<CurveBranch>& branches, double tau) {
  std::uint8_t at = 0;
  for (std::size_t b = 0; b < branches.size(); ++b)
    if (tau >= branches[b].from && branches[b].from < branches[b].to) at = static_cast<std::uint8_t>(b);
  return at;
}

void write_block(JsonWriter& json, const OrderBlock& block) {
  json.begin_object(Layout::one_line);
  json.member("branch", static_cast<int>(block.branch));
  json.member("from", block.from);
  json.member("to", block.to);
  json.key("knots");
  json.begin_list();
  for (const auto& knot : block.knots) write_numbers(json, knot);
  json.end_list();
  json.end_object();
}

void write_axis(JsonWriter& json, const ShownAxis& axis) {
  json.begin_object();
  json.member("quantity", name(axis.axis.quantity));
  json.member("order", axis.order.code());
  json.key("branches");
  write_branches(json, axis.axis.branches);
  json.key("ticks");
  if (axis.ticks.empty()) {
    json.null();
  } else {
    json.begin_list(Layout::one_line);
    for (const auto& tick : axis.ticks) write_numbers(json, tick);
    json.end_list();
  }
  json.key("blocks");
  json.begin_list();
  for (const OrderBlock& block : axis.order.blocks()) write_block(json, block);
  json.end_list();
  json.end_object();
}

void write_mark(JsonWriter& json, const CurveMark& mark) {
  json.begin_object(Layout::one_line);
  json.member("kind", name(mark.kind));
  if (mark.kind == CurveMark::Kind::pole) {
    json.key("positions");
    write_numbers(json, std::array{mark.poses[0] + 1.0, mark.poses[1] + 1.0});
  }
  json.key("tau");
  write_numbers(json, mark.tau);
  json.key("center");
  write_point(json, mark.center);
  json.key("circle");
  write_point(json, mark.circle);
  json.end_object();
}

void write_asymptote(JsonWriter& json, const CircularCubic& curve, const WorkingFrame& frame) {
  const auto asymptote = curve.asymptote();
  if (!asymptote) return json.null();
  json.begin_list(Layout::one_line);
  write_point(json, frame.to_user((*asymptote)[0]));
  write_point(json, (*asymptote)[1]);
  json.end_list();
}

void write_asymptotes(JsonWriter& json, const TaskFamily& given) {
  const std::array parts = {std::pair{"center", given.curve ? &given.curve->center_curve() : nullptr},
                            std::pair{"circle", given.curve ? &given.curve->circle_curve() : nullptr}};
  json.begin_object();
  for (const auto& [key, curve] : parts) {
    json.key(key);
    curve ? write_asymptote(json, *curve, given.frame()) : json.null();
  }
  json.end_object();
}

}  // namespace

DrawnCurves drawn_dyads(std::span<const Dyad> polygon, const std::vector<CurveBranch>& branches,
                        const WorkingFrame& frame) {
  DrawnCurves drawn;
  for (const Dyad& dyad : polygon) {
    const Dyad user = frame.to_user(dyad);
    drawn.tau.push_back(dyad.coordinate);
    append(drawn.center, user.center);
    append(drawn.circle, user.circle);
    drawn.branch.push_back(branch_of(branches, dyad.coordinate));
  }
  return drawn;
}

DrawnCurves drawn_curves(const std::vector<PrescribedPose>& poses, const TaskFamily& given, Side side) {
  const std::vector<Dyad> polygon = given.family  ? given.family->polygon(side)
                                    : given.curve ? CurveFamily(given.frame(), poses, given.curve).polygon(side)
                                                  : std::vector<Dyad>{};
  // Where nothing is left to choose of the output, it moves with the input.
  const bool along_input = given.family && given.family->axis(side).quantity == AxisQuantity::nothing;
  const auto branches = given.family  ? given.family->axis(along_input ? Side::input : side).branches
                        : given.curve ? given.curve->branches()
                                      : std::vector<CurveBranch>{};
  DrawnCurves drawn = drawn_dyads(polygon, branches, given.frame());
  if (given.curve && !poses.empty()) drawn.marks = curve_marks(poses, *given.curve, given.frame(), polygon);
  return drawn;
}

std::vector<std::array<double, 2>> axis_ticks(const LinkageFamily& family, Side side) {
  std::vector<std::array<double, 2>> ticks;
  const MapAxis& axis = family.axis(side);
  if (axis.quantity == AxisQuantity::curve_coordinate || axis.is_discrete()) return ticks;
  for (const CurveBranch& branch : axis.branches)
    for (int i = 0; i < ticks_of_a_branch; ++i) {
      const double tau = branch.from + (branch.to - branch.from) * i / ticks_of_a_branch;
      const double value = family.axis_value(side, tau);
      if (std::isfinite(value)) ticks.push_back({tau, value});
    }
  return ticks;
}

void write_curves(JsonWriter& json, const TaskFamily& given) {
  const BurmesterCurve* curve = given.curve.get();
  const std::string_view along =
      given.family ? name(given.family->axis(Side::input).quantity) : name(CubicKind::every_point);
  json.begin_object();
  json.member("kind", curve ? name(curve->kind()) : along);
  json.member("center_kind", curve ? name(curve->center_kind()) : along);
  json.key("kappa");
  const auto kappa = curve ? curve->kappa() : std::nullopt;
  kappa ? json.value(*kappa) : json.null();
  json.key("asymptotes");
  write_asymptotes(json, given);
  json.end_object();
}

void write_no_curves(JsonWriter& json) { write_curves(json, TaskFamily{}); }

std::string task_json(const TaskReply& task, std::span<const CurveMark> marks, const ShownAxes& axes,
                      const Requirements& requirements, const LinkageClass& asked, std::string_view status,
                      const Notice* reason) {
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("status", status);
    json.key("reason");
    reason ? write_notice(json, *reason) : json.null();
    json.member("pattern", std::string_view(task.pattern));
    json.member("condition", task.condition);
    json.member("characteristic_length", task.characteristic_length);
    json.key("warnings");
    json.begin_list();
    for (const Notice& warning : task.warnings) write_notice(json, warning);
    json.end_list();
    json.key("curves");
    task.write_curves(json);
    json.member("symmetric", axes.symmetric);
    json.key("axes");
    json.begin_object();
    json.key("input");
    write_axis(json, axes.input);
    json.key("output");
    write_axis(json, axes.output);
    json.end_object();
    json.key("specials");
    json.begin_list();
    for (const CurveMark& mark : marks) write_mark(json, mark);
    json.end_list();
    json.key("function");
    task.write_function ? task.write_function(json) : json.null();
    json.key("requirements");
    linkwright::write_requirements(json, requirements, asked);
    json.end_object();
  });
}

}  // namespace linkwright::wasm
