#include "support/curve_gallery.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"

namespace linkwright::testing {
namespace {

// The moving pivot of the output lies to the left of the way from that of the input to the output's fixed one, or to
// the right of it.
TracingFourBar linkage_of(const nlohmann::json& of) {
  const double coupler = of.at("coupler"), output = of.at("output");
  FourBar bars{
      {}, of.at("input").get<double>() * direction(of.at("start_rad")), {of.at("ground").get<double>(), 0}, {}};
  const Point across = bars.output_fixed - bars.input_moving;
  const double along = (std::norm(across) + coupler * coupler - output * output) / (2 * std::abs(across));
  const double aside = of.at("assembly").get<double>() * std::sqrt(coupler * coupler - along * along);
  bars.output_moving = bars.input_moving + Point{along, aside} * (across / std::abs(across));
  const Point in_coupler{of.at("point").at(0), of.at("point").at(1)};
  return {bars, bars.input_moving + in_coupler * (bars.output_moving - bars.input_moving) / coupler};
}

TracingFourBar moved(const TracingFourBar& linkage, const nlohmann::json& by) {
  const Point turn = std::polar(by.at("scale").get<double>(), by.at("turn_rad").get<double>());
  const Point shift{by.at("by").at(0), by.at("by").at(1)};
  const auto at = [&](Point p) { return shift + turn * p; };
  const FourBar& bars = linkage.bars;
  return {{at(bars.input_fixed), at(bars.input_moving), at(bars.output_fixed), at(bars.output_moving)},
          at(linkage.point)};
}

// The turns are read off a fine path; the points are those of the linkage there, exactly.
std::vector<Point> points_along(const TracingFourBar& linkage, double sweep, bool closed) {
  constexpr int count = 64, fine = 20'001;
  const auto path = motion_sweep(linkage.bars, linkage.point, sweep, fine);
  std::vector<double> length(path.size(), 0);
  for (std::size_t k = 1; k < path.size(); ++k)
    length[k] = length[k - 1] + std::abs(path[k].coupler_point - path[k - 1].coupler_point);
  std::vector<Point> points = {linkage.point};
  for (int j = 1; j < count; ++j) {
    const double asked = length.back() * j / (closed ? count : count - 1);
    const auto next = std::min<std::size_t>(
        static_cast<std::size_t>(std::lower_bound(length.begin(), length.end(), asked) - length.begin()),
        length.size() - 1);
    const double share = (asked - length[next - 1]) / (length[next] - length[next - 1]);
    const double turn = sweep * (static_cast<double>(next - 1) + share) / (fine - 1);
    points.push_back(motion_sweep(linkage.bars, linkage.point, turn, 2).back().coupler_point);
  }
  return points;
}

}  // namespace

std::vector<GalleryCurve> curve_gallery() {
  const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/approximate/gallery.json"));
  std::vector<GalleryCurve> gallery;
  for (const auto& of : json.at("linkages")) {
    GalleryCurve curve{of.at("id"), {}, of.contains("moved")};
    curve.target.closed = !of.contains("sweep_rad");
    const double sense = of.at("clockwise") ? -1 : 1;
    const double sweep = sense * of.value("sweep_rad", two_pi);
    const TracingFourBar linkage = linkage_of(of);
    curve.target.points =
        points_along(curve.is_copy ? moved(linkage, of.at("moved")) : linkage, sweep, curve.target.closed);
    gallery.push_back(std::move(curve));
  }
  return gallery;
}

}  // namespace linkwright::testing
