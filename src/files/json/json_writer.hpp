#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/function_ref.hpp"
#include "linkwright/files/text_file.hpp"

namespace linkwright {

/// Writes JSON as it comes, without a tree: keys in the order given, numbers as exact_text(), what is not finite as
/// null. Objects and lists take a line a member, or one line for all.
class JsonWriter {
 public:
  enum class Layout { lines, one_line };

  explicit JsonWriter(TextSink sink) : sink_(std::move(sink)) {}
  ~JsonWriter() { flush(); }
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  void begin_object(Layout layout = Layout::lines) { begin('{', layout); }
  void end_object() { end('}'); }
  void begin_list(Layout layout = Layout::lines) { begin('[', layout); }
  void end_list() { end(']'); }
  void key(std::string_view name);

  void value(double number);
  void value(std::int64_t number);
  void value(int number) { value(static_cast<std::int64_t>(number)); }
  void value(bool flag);
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void null();
  /// A value that is JSON text already.
  void json(std::string_view text);

  /// A text that comes in pieces and needs no escapes.
  void begin_text();
  void text_piece(std::string_view piece) { put(piece); }
  void end_text() { put("\""); }

  template <class Value>
  void member(std::string_view name, const Value& content) {
    key(name);
    value(content);
  }

 private:
  struct Level {
    Layout layout = Layout::lines;
    bool is_empty = true;
  };

  void begin(char bracket, Layout layout);
  void end(char bracket);
  void separate();
  void new_line();
  void put(std::string_view text);
  void flush();

  TextSink sink_;
  std::string buffer_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

/// JSON text of a string, quotes included; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(std::string_view text);

/// What `write` writes.
[[nodiscard]] std::string json_text_of(FunctionRef<void(JsonWriter&)> write);

}  // namespace linkwright
