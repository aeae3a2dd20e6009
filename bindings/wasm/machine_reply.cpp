#include <algorithm>

#include "linkwright/core/angle.hpp"
#include "replies.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

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

void write_sizes(JsonWriter& json, const PlateSizes& sizes) {
  json.key("sizes");
  json.begin_object(Layout::one_line);
  json.member("width", sizes.width);
  json.member("thickness", sizes.thickness);
  json.member("gap", sizes.gap);
  json.member("pin", sizes.pin);
  json.member("clearance", sizes.clearance);
  json.member("radius", sizes.radius);
  json.end_object();
}

void write_layers(JsonWriter& json, const Machine& made) {
  json.key("layers");
  json.begin_list(Layout::one_line);
  for (std::size_t body = 0; body < made.layers.layer.size(); ++body) {
    json.begin_list(Layout::one_line);
    json.value(std::string_view(made.linkage.bodies[body]));
    json.value(made.layers.layer[body]);
    json.end_list();
  }
  json.end_list();
}

void write_crossing(JsonWriter& json, const MovingLinkage& linkage, const Crossing& crossing,
                    const DriverAngles& angles) {
  json.begin_object(Layout::one_line);
  json.member("body", std::string_view(linkage.bodies[static_cast<std::size_t>(crossing.body)]));
  if (crossing.is_pin)
    json.member("pin", std::string_view(linkage.hinges[crossing.obstacle].name));
  else
    json.member("other", std::string_view(linkage.bodies[crossing.obstacle]));
  const auto [from, to] = angles.range_deg(crossing);
  json.member("from_deg", from);
  json.member("to_deg", to);
  json.end_object();
}

}  // namespace

std::string machine_reply(const Result<Machine>& made) {
  if (!made) return R"({"mistakes": )" + mistakes_json(made.errors()) + "}";
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    write_sizes(json, made->sizes);
    write_layers(json, *made);
    json.member("over", made->layers.over == PlateLayers::Over::travel ? "travel" : "task");
    json.key("crossings");
    json.begin_list();
    const DriverAngles angles(made->linkage);
    for (const Crossing& crossing : made->layers.crossings) write_crossing(json, made->linkage, crossing, angles);
    json.end_list();
    json.end_object();
  });
}

}  // namespace linkwright::wasm
