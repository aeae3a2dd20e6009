#include "json_writer.hpp"

#include <cmath>
#include <fmt/format.h>

#include "files/json/json.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr std::size_t buffer_bytes = 1 << 16;

}  // namespace

void JsonWriter::put(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_bytes) flush();
}

void JsonWriter::flush() {
  if (!buffer_.empty()) sink_(buffer_);
  buffer_.clear();
}

void JsonWriter::new_line() {
  put("\n");
  put(std::string(2 * levels_.size(), ' '));
}

/// What stands before a value or a key.
void JsonWriter::separate() {
  if (after_key_ || levels_.empty()) {
    after_key_ = false;
    return;
  }
  Level& level = levels_.back();
  if (level.layout == Layout::lines) {
    if (!level.is_empty) put(",");
    new_line();
  } else if (!level.is_empty) {
    put(", ");
  }
  level.is_empty = false;
}

void JsonWriter::begin(char bracket, Layout layout) {
  separate();
  put(std::string_view(&bracket, 1));
  const bool inside_one_line = !levels_.empty() && levels_.back().layout == Layout::one_line;
  levels_.push_back({inside_one_line ? Layout::one_line : layout, true});
}

void JsonWriter::end(char bracket) {
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.layout == Layout::lines && !level.is_empty) new_line();
  put(std::string_view(&bracket, 1));
  if (levels_.empty()) put("\n");
}

void JsonWriter::key(std::string_view name) {
  separate();
  put(json_text(name));
  put(": ");
  after_key_ = true;
}

void JsonWriter::value(double number) { std::isfinite(number) ? json(exact_text(number)) : null(); }
void JsonWriter::value(std::int64_t number) { json(fmt::format("{}", number)); }
void JsonWriter::value(bool flag) { json(flag ? "true" : "false"); }
void JsonWriter::value(std::string_view text) { json(json_text(text)); }
void JsonWriter::null() { json("null"); }

void JsonWriter::json(std::string_view text) {
  separate();
  put(text);
}

void JsonWriter::begin_text() {
  separate();
  put("\"");
}

std::string json_text(std::string_view text) {
  constexpr bool only_ascii = false;
  return Json(text).dump(-1, ' ', only_ascii, Json::error_handler_t::replace);
}

std::string json_text_of(FunctionRef<void(JsonWriter&)> write) {
  std::string text;
  JsonWriter json([&text](std::string_view piece) { text += piece; });
  write(json);
  return text;
}

}  // namespace linkwright
