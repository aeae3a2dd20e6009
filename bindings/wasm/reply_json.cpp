#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

void write_values(JsonWriter& json, const Values& values) {
  json.key("values");
  json.begin_object(Layout::one_line);
  for (const auto& [name, value] : values) {
    json.key(name);
    if (const auto* number = std::get_if<double>(&value))
      json.value(*number);
    else
      json.value(std::string_view(std::get<std::string>(value)));
  }
  json.end_object();
}

}  // namespace

void write_notice(JsonWriter& json, const Notice& notice) {
  json.begin_object(Layout::one_line);
  json.member("code", std::string_view(notice.code));
  write_values(json, notice.values);
  json.member("message", std::string_view(notice.message));
  json.end_object();
}

std::string mistakes_json(const std::vector<Error>& mistakes) {
  return json_text_of([&](JsonWriter& json) {
    json.begin_list();
    for (const Error& mistake : mistakes) {
      json.begin_object(Layout::one_line);
      json.member("code", std::string_view(mistake.code));
      json.member("place", std::string_view(mistake.place));
      write_values(json, mistake.values);
      json.member("message", std::string_view(mistake.message));
      json.end_object();
    }
    json.end_list();
  });
}

void write_point(JsonWriter& json, const std::optional<Point>& point) {
  if (!point) return json.null();
  write_numbers(json, std::array{point->real(), point->imag()});
}

void write_numbers(JsonWriter& json, std::span<const double> numbers) {
  json.begin_list(Layout::one_line);
  for (const double number : numbers) json.value(number);
  json.end_list();
}

}  // namespace linkwright::wasm
