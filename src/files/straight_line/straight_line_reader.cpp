#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>

#include "files/json/json_object.hpp"
#include "files/line_reader.hpp"
#include "files/straight_line/straight_line_kind.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

constexpr std::array<std::string_view, 14> case_names = {"four_point_pivots",
                                                         "four_point_cubic",
                                                         "ball_point_on_side_link",
                                                         "isosceles_trapezoid",
                                                         "pole_at_fixed_pivot",
                                                         "pole_at_fixed_pivot_ball_point_on_frame",
                                                         "five_point",
                                                         "five_point_inflection_pole",
                                                         "five_point_side_link_on_frame",
                                                         "six_point",
                                                         "parallel_side_links",
                                                         "mixed",
                                                         "symmetric_lambda",
                                                         "search"};

constexpr std::size_t most_contacts_read = 100;

// The members of a task beside kind, mechanism, case and line.
class CaseReader {
 public:
  CaseReader(const JsonValue& value, Mistakes& mistakes) : value_(value), mistakes_(mistakes) {}

  // Nothing where something is missing or of the wrong type.
  [[nodiscard]] std::optional<StraightLineCase> read(std::string_view name) {
    if (name == "four_point_pivots") return four_point_pivots();
    if (name == "four_point_cubic") return four_point_cubic();
    if (name == "ball_point_on_side_link") return ball_point_on_side_link();
    if (name == "isosceles_trapezoid") return isosceles_trapezoid();
    if (name == "pole_at_fixed_pivot") return pole_at_fixed_pivot();
    if (name == "five_point") return five_point();
    if (name == "parallel_side_links") return parallel_side_links();
    if (name == "mixed") return mixed();
    if (name == "symmetric_lambda") return symmetric_lambda();
    if (name == "search") return search();
    return of_pole_distance(name);
  }

 private:
  [[nodiscard]] JsonObject members(std::initializer_list<std::string_view> own) const {
    std::vector<std::string_view> known = {"kind", "mechanism", "case", "line"};
    known.insert(known.end(), own);
    return {value_, mistakes_, std::span<const std::string_view>(known)};
  }
  static std::optional<double> angle(const JsonObject& object, std::string_view key) {
    const auto degrees = object.require_number(key);
    return degrees ? std::optional(radians(*degrees)) : std::nullopt;
  }
  struct GroundPivots {
    Point input{}, output{};
  };
  [[nodiscard]] std::optional<GroundPivots> ground_pivots(const JsonObject& object) const {
    const auto found =
        object.require("ground_pivots", {"ground_pivots", "the ground pivots {\"input\": [x, y], \"output\": [x, y]}"});
    if (!found) return std::nullopt;
    const JsonObject pivots(*found, mistakes_, {"input", "output"});
    const auto input = pivots.require_point("input"), output = pivots.require_point("output");
    if (!input || !output) return std::nullopt;
    return GroundPivots{*input, *output};
  }

  [[nodiscard]] std::optional<StraightLineCase> four_point_pivots() const {
    const auto pivots = ground_pivots(members({"ground_pivots"}));
    if (!pivots) return std::nullopt;
    return FourPointPivots{pivots->input, pivots->output};
  }
  [[nodiscard]] std::optional<StraightLineCase> four_point_cubic() const {
    const JsonObject object = members({"pole_distance", "point_ray_deg", "cubic_n"});
    const auto distance = object.require_number("pole_distance");
    const auto ray = angle(object, "point_ray_deg");
    std::optional<double> n;
    if (const auto given = object.find("cubic_n"); given && !given->is_null()) {
      n = given->as_number();
      if (!n) return std::nullopt;
    }
    if (!distance || !ray) return std::nullopt;
    return FourPointCubic{*distance, *ray, n};
  }
  [[nodiscard]] std::optional<StraightLineCase> ball_point_on_side_link() const {
    const auto pivot = members({"input_pivot"}).require_point("input_pivot");
    if (!pivot) return std::nullopt;
    return BallPointOnSideLink{*pivot};
  }
  [[nodiscard]] std::optional<StraightLineCase> isosceles_trapezoid() const {
    const auto half = members({"half_frame"}).require_number("half_frame");
    if (!half) return std::nullopt;
    return IsoscelesTrapezoid{*half};
  }
  [[nodiscard]] std::optional<StraightLineCase> pole_at_fixed_pivot() const {
    const JsonObject any(value_, mistakes_, {});
    if (any.find("ground_pivots")) {
      const JsonObject object = members({"ground_pivots", "output_arm"});
      const auto pivots = ground_pivots(object);
      const auto arm = object.require_number("output_arm");
      if (!pivots || !arm) return std::nullopt;
      return PoleAtGivenPivot{pivots->input, pivots->output, *arm};
    }
    const JsonObject object = members({"pole_distance", "output_arm"});
    const auto distance = object.require_number("pole_distance"), arm = object.require_number("output_arm");
    if (!distance || !arm) return std::nullopt;
    return PoleAtFixedPivot{*distance, *arm};
  }
  [[nodiscard]] std::optional<StraightLineCase> five_point() const {
    const JsonObject object = members({"pole_distance", "point_ray_deg"});
    const auto distance = object.require_number("pole_distance");
    const auto ray = angle(object, "point_ray_deg");
    if (!distance || !ray) return std::nullopt;
    return FivePoint{*distance, *ray};
  }
  [[nodiscard]] std::optional<StraightLineCase> of_pole_distance(std::string_view name) const {
    const auto distance = members({"pole_distance"}).require_number("pole_distance");
    if (!distance) return std::nullopt;
    if (name == "five_point_inflection_pole") return FivePointInflectionPole{*distance};
    if (name == "five_point_side_link_on_frame") return FivePointSideLinkOnFrame{*distance};
    if (name == "six_point") return SixPoint{*distance};
    return PoleAtFixedPivotBallPointOnFrame{*distance};
  }
  [[nodiscard]] std::optional<StraightLineCase> parallel_side_links() const {
    const JsonObject object = members({"input_offset", "output_offset"});
    const auto input = object.require_number("input_offset"), output = object.require_number("output_offset");
    if (!input || !output) return std::nullopt;
    return ParallelSideLinks{*input, *output};
  }
  [[nodiscard]] std::optional<StraightLineCase> mixed() const {
    const JsonObject object = members({"input_pivot", "contacts", "coupler_angle_deg"});
    const auto pivot = object.require_point("input_pivot");
    const auto list =
        object.require("contacts", {"contacts_in_full", "a list of contacts {\"s\": …, \"multiplicity\": …}"});
    double turn = 0;
    if (const auto given = object.find("coupler_angle_deg")) {
      const auto number = given->as_number();
      if (!number) return std::nullopt;
      turn = radians(*number);
    }
    if (!pivot || !list) return std::nullopt;
    const auto contacts = read_contacts(*list);
    if (!contacts) return std::nullopt;
    return MixedContacts{*pivot, *contacts, turn};
  }
  [[nodiscard]] std::optional<std::vector<PlacedContact>> read_contacts(const JsonValue& list) const {
    if (list.json().is_array() && list.json().size() > most_contacts_read) {
      list.mistake("contacts_read", fmt::format("{} contacts are given; four are the most", list.json().size()),
                   {{"count", list.json().size()}});
      return std::nullopt;
    }
    std::vector<PlacedContact> contacts;
    bool complete = true;
    const bool is_list = list.for_each({"contacts", "a list of contacts"}, [&](const JsonValue& item) {
      const JsonObject object(item, mistakes_, {"s", "multiplicity", "side"});
      PlacedContact contact;
      const auto s = object.require_number("s");
      const auto whole = [&](std::string_view key, int& number) {
        const auto found = object.find(key);
        if (!found) return true;
        const auto read = found->as_whole_number();
        if (read) number = *read;
        return read.has_value();
      };
      const bool rest = whole("multiplicity", contact.multiplicity) && whole("side", contact.side);
      complete = complete && s && rest;
      if (s) contact.s = *s;
      contacts.push_back(contact);
    });
    return is_list && complete ? std::optional(contacts) : std::nullopt;
  }
  [[nodiscard]] std::optional<StraightLineCase> search() const {
    const JsonObject object = members({"stroke", "deviation"});
    const auto stroke = object.require_number("stroke"), deviation = object.require_number("deviation");
    if (!stroke || !deviation) return std::nullopt;
    return Search{*stroke, *deviation};
  }
  [[nodiscard]] std::optional<StraightLineCase> symmetric_lambda() const {
    const JsonObject object = members({"stroke", "crank_range_deg"});
    const auto stroke = object.require_number("stroke");
    std::optional<double> range;
    if (const auto given = object.find("crank_range_deg"); given && !given->is_null()) {
      const auto number = given->as_number();
      if (!number) return std::nullopt;
      range = radians(*number);
    }
    if (!stroke) return std::nullopt;
    return SymmetricLambdas{*stroke, range};
  }

  const JsonValue& value_;
  Mistakes& mistakes_;
};

}  // namespace

Task read_straight_line(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {});
  const auto line_there = object.require("line", {"line", "the line {\"point\": [x, y], \"direction_deg\": …}"});
  const auto line = line_there ? read_line(*line_there, mistakes) : std::nullopt;
  const auto given_case = object.require("case", {"straight_line_case", "a case: \"case\": \"four_point_pivots\""});
  const auto name = given_case ? given_case->as_one_of(case_names) : std::nullopt;
  StraightLineTask task;
  if (!name) return task;
  const auto given = CaseReader(value, mistakes).read(*name);
  if (!line || !given) return task;
  task = {*line, *given};
  mistakes.add(mistakes_in(task));
  return task;
}

}  // namespace linkwright
