#include <array>

#include "linkwright/core/angle.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

constexpr int steps_of_a_curve = 90;

std::optional<std::array<Point, 2>> asymptote_of(const CircularCubic& curve, const WorkingFrame& frame) {
  const auto asymptote = curve.asymptote();
  if (!asymptote) return std::nullopt;
  return std::array{frame.to_user((*asymptote)[0]), (*asymptote)[1]};
}

/// Of Burmester curves, or of what the dyads lie along instead.
CurvesReply curves_of(const TaskFamily& given) {
  if (const BurmesterCurve* curve = given.curve.get())
    return {std::string(name(curve->kind())), std::string(name(curve->center_kind())), curve->kappa(),
            Asymptotes{asymptote_of(curve->center_curve(), given.frame()),
                       asymptote_of(curve->circle_curve(), given.frame())}};
  const std::string along(given.family ? name(given.family->axis(Side::input).quantity) : name(CubicKind::every_point));
  return {along, along, std::nullopt, Asymptotes{}};
}
CurvesReply curves_of(const FourBarAnswer& known) { return curves_of(known.given); }
CurvesReply curves_of(const SphericalAnswer& known) {
  const SphericalTaskFamily& given = known.given;
  const CubicConeKind kind = given.curve ? given.curve->kind() : CubicConeKind::every_axis;
  return {std::string(given.curve || !given.family ? name(kind) : name(AxisQuantity::burmester_point)), {}, {}, {}};
}
CurvesReply curves_of(const Findings& /*known*/) { return curves_of(TaskFamily{}); }

FunctionReply function_of(const WantedFunction& wanted) {
  FunctionReply reply;
  for (const AnglePair& pair : wanted.pairs) reply.pairs.push_back({degrees(pair.input), degrees(pair.output)});
  if (!wanted.function) return reply;
  const ScaledFunction scaled(*wanted.function);
  const auto [from, to] = scaled.input_range();
  for (int i = 0; i <= steps_of_a_curve; ++i) {
    const double input = from + (to - from) * i / steps_of_a_curve;
    reply.curve.push_back({degrees(input), degrees(scaled.output_at(input))});
  }
  return reply;
}

SolutionStatus status_of(Session& session, bool is_nothing) {
  if (!is_nothing) return SolutionStatus::solved;
  return session.family() ? SolutionStatus::no_solution : SolutionStatus::degenerate;
}

}  // namespace

std::string task_reply(Session& session) {
  const Task& task = session.problem().task;
  const auto reason = session.why_nothing();
  TaskReply reply{findings(session.known()), session.axes(), linkages(task)};
  reply.status = status_of(session, reason.has_value());
  if (reason) reply.reason = {*reason};
  reply.curves = std::visit([](const auto& of_kind) { return curves_of(of_kind); }, session.known());
  reply.marks = session.marks();
  if (const WantedFunction* wanted = wanted_function(task)) reply.function = function_of(*wanted);
  return text_of(reply);
}

}  // namespace linkwright::wasm
