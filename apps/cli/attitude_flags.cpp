#include "attitude_flags.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace linkwright::cli {
namespace {

using Json = nlohmann::json;

using Content = FlagContent;

std::vector<AttitudeFlag> orientation_flags() {
  return {
      {"--axis", "orientation.axis", Content::numbers, "x,y,z", "Axis of one turn, any length; with --angle"},
      {"--angle", "orientation.angle_deg", Content::number, "DEGREES", "Angle about the axis"},
      {"--euler", "orientation.euler_deg", Content::sequence, "zxz a,b,c",
       "Three angles (degrees) about carried axes, in the order of the sequence"},
      {"--extrinsic", "orientation.turning", Content::set, "", "The angles of --euler are about axes at rest",
       "\"extrinsic\""},
      {"--quaternion", "orientation.quaternion", Content::numbers, "w,x,y,z", "Quaternion, any length"},
      {"--matrix", "orientation.matrix", Content::matrix, "9 NUMBERS", "Direction cosines by rows"},
      {"--nearest", "orientation.nearest", Content::set, "", "Take the nearest rotation to --matrix, however far",
       "true"},
      {"--rotation-vector", "orientation.rotation_vector", Content::numbers, "x,y,z", "Rotation vector, radians"},
      {"--rodrigues", "orientation.rodrigues", Content::numbers, "x,y,z", "Rodrigues vector"},
      {"--mrp", "orientation.mrp", Content::numbers, "x,y,z", "Modified Rodrigues vector"},
  };
}

std::vector<AttitudeFlag> joined(std::vector<AttitudeFlag> flags, const std::vector<AttitudeFlag>& more) {
  flags.insert(flags.end(), more.begin(), more.end());
  return flags;
}

std::vector<AttitudeFlag> convert_flags() {
  return joined(orientation_flags(), {{"--vector", "vectors", Content::list_item, "x,y,z",
                                       "A vector to be turned; may be given more than once"}});
}

std::vector<AttitudeFlag> screw_flags() {
  return {
      {"--axis", "displacement.screw.axis", Content::numbers, "x,y,z", "Direction of the screw axis, any length"},
      {"--angle", "displacement.screw.angle_deg", Content::number, "DEGREES", "Angle about the axis (default 0)"},
      {"--point", "displacement.screw.point", Content::numbers, "x,y,z", "A point of the axis (default the origin)"},
      {"--slide", "displacement.screw.slide", Content::number, "LENGTH", "Translation along the axis (default 0)"},
      {"--matrix", "displacement.matrix", Content::matrix, "16 NUMBERS", "The 4 by 4 matrix by rows, instead"},
      {"--euler", "displacement.orientation.euler_deg", Content::sequence, "zxz a,b,c",
       "Or the orientation by three angles (degrees), with --translation"},
      {"--quaternion", "displacement.orientation.quaternion", Content::numbers, "w,x,y,z",
       "Or the orientation by a quaternion, with --translation"},
      {"--rotation-vector", "displacement.orientation.rotation_vector", Content::numbers, "x,y,z",
       "Or the orientation by a rotation vector (radians), with --translation"},
      {"--translation", "displacement.translation", Content::numbers, "x,y,z", "Where the origin goes"},
      {"--move", "points", Content::list_item, "x,y,z", "A point to be displaced; may be given more than once"},
      {"--unit", "length_unit", Content::text, "UNIT", "Of lengths; echoed, never converted"},
  };
}

std::vector<AttitudeFlag> twist_flags() {
  return {
      {"--angular-velocity", "twist.angular_velocity", Content::numbers, "x,y,z", "Radians per unit of time"},
      {"--velocity", "twist.velocity", Content::numbers, "x,y,z", "Velocity of a point of the body"},
      {"--at", "twist.at", Content::numbers, "x,y,z", "Where that point lies (default the origin)"},
      {"--axis", "twist.screw.axis", Content::numbers, "x,y,z", "Or the direction of the screw axis, any length"},
      {"--point", "twist.screw.point", Content::numbers, "x,y,z", "A point of the axis (default the origin)"},
      {"--rate", "twist.screw.rate", Content::number, "NUMBER", "Radians per unit of time about the axis (default 0)"},
      {"--slide-rate", "twist.screw.slide_rate", Content::number, "NUMBER", "Velocity along the axis (default 0)"},
      {"--pitch", "twist.screw.pitch", Content::number, "LENGTH", "Or the pitch, length per radian"},
      {"--of", "points", Content::list_item, "x,y,z", "A point whose velocity is wanted; may be given more than once"},
      {"--unit", "length_unit", Content::text, "UNIT", "Of lengths; echoed, never converted"},
  };
}

std::vector<AttitudeFlag> rates_flags() {
  return joined(
      orientation_flags(),
      {{"--velocity", "motion.velocity", Content::numbers, "x,y,z", "Angular velocity, radians per unit of time"},
       {"--acceleration", "motion.acceleration", Content::numbers, "x,y,z", "Angular acceleration"},
       {"--in", "motion.frame", Content::text, "fixed|moving", "The frame of both (default fixed)"},
       {"--euler-rates", "motion.euler_rates_deg", Content::numbers, "a,b,c", "Or rates of --euler's angles, degrees"},
       {"--euler-accelerations", "motion.euler_accelerations_deg", Content::numbers, "a,b,c",
        "Their second derivatives, degrees"},
       {"--matrix-first", "motion.matrix_first", Content::matrix, "9 NUMBERS", "Or the derivative of the matrix"},
       {"--matrix-second", "motion.matrix_second", Content::matrix, "9 NUMBERS", "Its second derivative"},
       {"--quaternion-first", "motion.quaternion_first", Content::numbers, "w,x,y,z",
        "Or the derivative of the quaternion"},
       {"--quaternion-second", "motion.quaternion_second", Content::numbers, "w,x,y,z", "Its second derivative"},
       {"--point", "points", Content::position, "x,y,z", "A point of the body; may be given more than once"},
       {"--step", "step", Content::number, "TIME", "Show the attitude after this time, at constant velocity"}});
}

std::vector<AttitudeFlag> dh_flags() {
  return {
      {"--link", "links", Content::link, "theta,d,a,alpha", "A link, angles in degrees; one --link for each"},
      {"--form", "form", Content::text, "classic|modified", "Which form of the parameters (default classic)"},
      {"--point", "points", Content::list_item, "x,y,z", "A point in the last frame; may be given more than once"},
      {"--matrix", "displacement.matrix", Content::matrix, "16 NUMBERS",
       "Instead of links: a 4 by 4 matrix whose four parameters are wanted"},
      {"--unit", "length_unit", Content::text, "UNIT", "Of lengths; echoed, never converted"},
  };
}

Error flag_mistake(const AttitudeFlag& flag, std::string message) {
  return {"wrong_type", std::string(flag.name), std::move(message)};
}

bool is_separator(char c) { return c == ',' || c == ';' || c == ' ' || c == '[' || c == ']'; }

/// Numbers between commas, semicolons and blanks; nothing when something else is among them.
std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && is_separator(*at)) ++at;
    if (at == end) return numbers;
    if (*at == '+') ++at;
    double number = 0;
    const auto [next, trouble] = std::from_chars(at, end, number);
    if (trouble != std::errc() || !std::isfinite(number) || (next != end && !is_separator(*next))) return std::nullopt;
    numbers.push_back(number);
    at = next;
  }
}

Json rows_of(const std::vector<double>& numbers) {
  const std::size_t size = numbers.size() == 16 ? 4 : 3;
  Json rows = Json::array();
  for (std::size_t i = 0; i < numbers.size(); i += size) {
    rows.push_back(std::vector<double>(numbers.begin() + static_cast<std::ptrdiff_t>(i),
                                       numbers.begin() + static_cast<std::ptrdiff_t>(i + size)));
  }
  return rows;
}

/// How many numbers the shape of a flag shows: "x,y,z" has three.
std::size_t count_in(const AttitudeFlag& flag) {
  if (flag.shape.substr(0, 2) == "16") return 16;
  if (flag.shape.substr(0, 1) == "9") return 9;
  return 1 + static_cast<std::size_t>(std::count(flag.shape.begin(), flag.shape.end(), ','));
}

Result<std::vector<double>> read_numbers(const AttitudeFlag& flag, const std::string& text) {
  const std::size_t count = count_in(flag);
  const auto numbers = numbers_in(text);
  if (numbers && numbers->size() == count) return *numbers;
  const std::string shape =
      count == 1 ? "a number belongs here"
                 : fmt::format("{} numbers belong here, like {}", count, count > 4 ? "1,0,0,0,…" : flag.shape);
  return flag_mistake(flag, numbers ? fmt::format("{}, not {}", shape, numbers->size())
                                    : fmt::format("{}, not \"{}\"", shape, text.substr(0, 40)));
}

Json& at(Json& file, std::string_view place) {
  Json* value = &file;
  while (true) {
    const std::size_t end = std::min(place.find('.'), place.size());
    value = &(*value)[std::string(place.substr(0, end))];
    if (end == place.size()) return *value;
    place.remove_prefix(end + 1);
  }
}

/// What `content` makes of the numbers of one value.
Json as_json(Content content, const std::vector<double>& numbers) {
  switch (content) {
    case Content::number:
      return numbers.front();
    case Content::matrix:
      return rows_of(numbers);
    case Content::link:
      return {{"theta_deg", numbers[0]}, {"d", numbers[1]}, {"a", numbers[2]}, {"alpha_deg", numbers[3]}};
    case Content::position:
      return {{"position", numbers}};
    default:
      return numbers;
  }
}

/// Adds what one flag says; the mistake, if there is one.
std::optional<Error> add(Json& file, const AttitudeFlag& flag, const std::vector<std::string>& values) {
  Json& value = at(file, flag.place);
  if (flag.content == Content::set) {
    value = Json::parse(flag.fixed_value);
    return std::nullopt;
  }
  if (flag.content == Content::text) {
    value = values.front();
    return std::nullopt;
  }
  std::vector<std::string> texts = values;
  if (flag.content == Content::sequence) {
    const std::string place(flag.place);
    at(file, place.substr(0, place.rfind('.')) + ".sequence") = values.front();
    texts.erase(texts.begin());
  }
  for (const std::string& text : texts) {
    const auto numbers = read_numbers(flag, text);
    if (!numbers) return numbers.errors().front();
    if (may_repeat(flag.content)) {
      value.push_back(as_json(flag.content, *numbers));
    } else {
      value = as_json(flag.content, *numbers);
    }
  }
  return std::nullopt;
}

/// The flags of a screw, where --axis and --angle are the orientation that belongs to a --translation.
std::string_view place_of(const AttitudeFlag& flag, const FlagValues& values) {
  const bool is_orientation =
      values.contains("--translation") && !values.contains("--point") && !values.contains("--slide");
  if (is_orientation && flag.place == "displacement.screw.axis") return "displacement.orientation.axis";
  if (is_orientation && flag.place == "displacement.screw.angle_deg") return "displacement.orientation.angle_deg";
  return flag.place;
}

bool begins(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

}  // namespace

const std::vector<AttitudeFlag>& attitude_flags(std::string_view command) {
  static const std::map<std::string_view, std::vector<AttitudeFlag>> all = {{"convert", convert_flags()},
                                                                            {"screw", screw_flags()},
                                                                            {"twist", twist_flags()},
                                                                            {"rates", rates_flags()},
                                                                            {"dh", dh_flags()}};
  return all.find(command)->second;
}

Result<std::string> file_of_flags(std::string_view command, const FlagValues& values) {
  Json file = {{"linkwright", 1}};
  std::vector<Error> mistakes;
  for (AttitudeFlag flag : attitude_flags(command)) {
    const auto given = values.find(std::string(flag.name));
    if (given == values.end()) continue;
    flag.place = place_of(flag, values);
    if (const auto error = add(file, flag, given->second)) mistakes.push_back(*error);
  }
  if (!mistakes.empty()) return mistakes;
  return file.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<Error> in_terms_of_flags(std::string_view command, const FlagValues& values, std::vector<Error> errors) {
  for (Error& error : errors) {
    std::string_view longest;
    std::string name;
    for (const AttitudeFlag& flag : attitude_flags(command)) {
      const std::string_view place = place_of(flag, values);
      if (!values.contains(std::string(flag.name)) || place.size() < longest.size() || !begins(error.place, place))
        continue;
      longest = place;
      name = flag.name;
    }
    if (begins(error.place, "orientation.sequence") || begins(error.place, "displacement.orientation.sequence"))
      name = "--euler";
    if (!name.empty()) error.place = name;
  }
  return errors;
}

}  // namespace linkwright::cli
