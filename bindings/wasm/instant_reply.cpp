#include "drawing/curve_path.hpp"
#include "files/fields/result_forms.hpp"
#include "files/instant_fields.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

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

std::vector<std::vector<Point>> polylines(const StationaryCurve& curve, const PlaneWindow& window) {
  std::vector<std::vector<Point>> lines;
  for (const auto& piece : curve.pieces)
    for (const auto& path : visible_curve(piece, window)) {
      auto& line = lines.emplace_back();
      for (const Point px : path) line.push_back(window.to_user(px));
    }
  return lines;
}

}  // namespace

std::string instant_reply(std::string_view text) {
  const auto linkage = read_linkage(text);
  if (!linkage) return refusal_json(linkage.errors());
  const FourBar& bars = linkage->four_bar;
  const InstantAnalysis analysis = analyze_instant(bars, {});
  return json_text_of([&](JsonWriter& json) {
    write_reply(json, [&](FieldVisitor& v) {
      v.object({}, [&](FieldVisitor& to) {
        to.shown("instant", analysis);
        if (!analysis.instant) return;
        const PlaneWindow window = around(bars);
        for (const auto& [key, curve] : {std::pair("circling_points", circling_point_curve(*analysis.instant)),
                                         std::pair("centering_points", centering_point_curve(*analysis.instant))})
          to.shown(key, polylines(curve, window), forms::on_a_line, forms::on_a_line, forms::shown_point);
      });
    });
  });
}

}  // namespace linkwright::wasm
