#include "task_reply.hpp"

#include "io/result_writer.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

// Short enough for a curve that looks smooth at some zoom: a side this long is a hundredth of a task's size.
constexpr double longest_side = 0.025;

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

void write_axis(JsonWriter& json, const DisplayOrder& order, const std::vector<CurveBranch>& branches) {
  json.begin_object();
  json.member("order", order.code());
  json.key("branches");
  write_branches(json, branches);
  json.key("blocks");
  json.begin_list();
  for (const OrderBlock& block : order.blocks()) write_block(json, block);
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

void write_curves(JsonWriter& json, const TaskCurve& given) {
  const BurmesterCurve& curve = *given.curve;
  json.begin_object();
  json.member("kind", name(curve.kind()));
  json.member("center_kind", name(curve.center_kind()));
  json.key("kappa");
  const auto kappa = curve.kappa();
  kappa ? json.value(*kappa) : json.null();
  json.key("asymptotes");
  json.begin_object();
  json.key("center");
  write_asymptote(json, curve.center_curve(), given.conditions.frame);
  json.key("circle");
  write_asymptote(json, curve.circle_curve(), given.conditions.frame);
  json.end_object();
  json.end_object();
}

}  // namespace

DrawnCurves drawn_curves(const MotionTask& task, const TaskCurve& given) {
  DrawnCurves drawn;
  const BurmesterCurve& curve = *given.curve;
  if (curve.coordinate_length() == 0) return drawn;
  const std::vector<Dyad> polygon = curve.polygon(longest_side);
  for (const Dyad& dyad : polygon) {
    const Dyad user = given.conditions.frame.to_user(dyad);
    drawn.tau.push_back(dyad.coordinate);
    append(drawn.center, user.center);
    append(drawn.circle, user.circle);
    drawn.branch.push_back(branch_of(curve.branches(), dyad.coordinate));
  }
  drawn.marks = curve_marks(task, given, polygon);
  return drawn;
}

std::string task_json(const TaskCurve& given, const DrawnCurves& drawn, const DisplayOrder& order,
                      const Requirements& requirements, std::string_view status, const Notice* reason) {
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("status", status);
    json.key("reason");
    reason ? write_notice(json, *reason) : json.null();
    json.member("pattern", std::string_view(given.pattern));
    json.member("condition", given.conditions.condition());
    json.member("characteristic_length", given.conditions.frame.scale);
    json.key("warnings");
    json.begin_list();
    for (const Notice& warning : given.warnings) write_notice(json, warning);
    json.end_list();
    json.key("curves");
    write_curves(json, given);
    json.key("axis");
    write_axis(json, order, given.curve->branches());
    json.key("specials");
    json.begin_list();
    for (const CurveMark& mark : drawn.marks) write_mark(json, mark);
    json.end_list();
    json.key("requirements");
    write_requirements(json, requirements);
    json.end_object();
  });
}

}  // namespace linkwright::wasm
