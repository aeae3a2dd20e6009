#include "drawing/curve_path.hpp"
#include "files/fields/field_writer.hpp"
#include "files/instant_fields.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"
#include "replies.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

// The part of the plane in which curves are followed.
PlaneWindow around(const FourBar& bars) {
  constexpr double reach = 10, pixels = 1600;  // px as of a picture: a vertex every three of them
  const Point center = (bars.input_fixed + bars.output_fixed) / 2.0;
  const double half = reach * bars.lengths().longest();
  const std::array<Point, 2> corners = {center - Point{half, half}, center + Point{half, half}};
  return {{0, 0, pixels, pixels}, corners, 0};
}

void write_curve(JsonWriter& json, std::string_view key, const StationaryCurve& curve, const PlaneWindow& window) {
  json.key(key);
  json.begin_list();
  for (const auto& piece : curve.pieces)
    for (const auto& path : visible_curve(piece, window))
      write_points(json, path, [&](Point px) { return std::optional(window.to_user(px)); });
  json.end_list();
}

}  // namespace

std::string instant_reply(std::string_view text) {
  const auto linkage = read_linkage(text);
  if (!linkage) return R"({"mistakes": )" + mistakes_json(linkage.errors()) + "}";
  const FourBar& bars = linkage->four_bar;
  const InstantAnalysis analysis = analyze_instant(bars, {});
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("instant");
    write_fields(json, analysis);
    if (analysis.instant) {
      const PlaneWindow window = around(bars);
      write_curve(json, "circling_points", circling_point_curve(*analysis.instant), window);
      write_curve(json, "centering_points", centering_point_curve(*analysis.instant), window);
    }
    json.end_object();
  });
}

}  // namespace linkwright::wasm
