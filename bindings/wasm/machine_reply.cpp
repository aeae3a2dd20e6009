#include <algorithm>
#include <tuple>

#include "linkwright/core/angle.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

/// The driver's angles as the page counts them.
class DriverAngles {
 public:
  explicit DriverAngles(const MovingLinkage& linkage) {
    const auto& [travel, task] = std::tie(linkage.travel, linkage.task);
    if (travel.empty()) return;
    const double way = task.size() > 1 ? wrap_signed(travel[task[1]].driver_turn - travel[task[0]].driver_turn)
                                       : travel.back().driver_turn - travel.front().driver_turn;
    sense_ = way < 0 ? -1 : 1;
    // A crank's travel that ends in position 1 begins there as well.
    const double middle = sense_ * (travel.front().driver_turn + travel.back().driver_turn) / 2;
    if (linkage.full_turn && middle < 0) shift_ = two_pi;
  }
  [[nodiscard]] std::pair<double, double> range_deg(const Crossing& crossing) const {
    return std::minmax({degrees(sense_ * crossing.from_turn + shift_), degrees(sense_ * crossing.to_turn + shift_)});
  }

 private:
  double sense_ = 1, shift_ = 0;
};

CrossingReply crossing_reply(const MovingLinkage& linkage, const Crossing& crossing, const DriverAngles& angles) {
  CrossingReply reply{linkage.bodies[static_cast<std::size_t>(crossing.body)]};
  if (crossing.is_pin)
    reply.pin = linkage.hinges[crossing.obstacle].name;
  else
    reply.other = linkage.bodies[crossing.obstacle];
  std::tie(reply.from_deg, reply.to_deg) = angles.range_deg(crossing);
  return reply;
}

}  // namespace

std::string machine_reply(const Result<Machine>& made) {
  if (!made) return refusal_json(made.errors());
  MachinePlan plan{made->sizes};
  for (std::size_t body = 0; body < made->layers.layer.size(); ++body)
    plan.layers.push_back({made->linkage.bodies[body], made->layers.layer[body]});
  plan.over = made->layers.over;
  const DriverAngles angles(made->linkage);
  for (const Crossing& crossing : made->layers.crossings)
    plan.crossings.push_back(crossing_reply(made->linkage, crossing, angles));
  return text_of(plan);
}

}  // namespace linkwright::wasm
