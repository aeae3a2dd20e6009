#include "json_document.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "files/json/json.hpp"
#include "json_scan.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "mistakes.hpp"

namespace linkwright {
namespace {

/// Builds the tree from the parser's events, knows where it is, and notes what a tree would hide: keys given twice.
class TreeBuilder final : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(std::string_view text, const JsonLimits& limits, Mistakes& mistakes)
      : text_(text), limits_(limits), mistakes_(mistakes) {}

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override;
  bool parse_error(std::size_t position, const std::string& token, const Json::exception& exception) override;

  [[nodiscard]] Json take() { return std::move(root_); }

 private:
  struct Level {
    Json* container = nullptr;  ///< null inside what is dropped
    std::string key;
    std::size_t index = 0;
    bool drop = false;  ///< the member that comes next
  };

  bool put(Json value);
  bool open(Json container);
  bool close();
  bool advance();
  Json* place_value(Json&& value);
  [[nodiscard]] std::string place() const;
  [[nodiscard]] bool is_kept(const std::string& key) const;

  std::string_view text_;
  const JsonLimits& limits_;
  Mistakes& mistakes_;
  Json root_;
  std::vector<Level> levels_;
};

bool TreeBuilder::is_kept(const std::string& key) const {
  return levels_.size() > 1 || limits_.kept.empty() ||
         std::find(limits_.kept.begin(), limits_.kept.end(), key) != limits_.kept.end();
}

/// Puts a value where the parser is; the value's new home, or null where it is dropped.
Json* TreeBuilder::place_value(Json&& value) {
  if (levels_.empty()) return &(root_ = std::move(value));
  Level& level = levels_.back();
  if (level.container == nullptr || level.drop) return nullptr;
  if (level.container->is_array()) {
    level.container->push_back(std::move(value));
    return &level.container->back();
  }
  return &((*level.container)[level.key] = std::move(value));
}

bool TreeBuilder::put(Json value) {
  place_value(std::move(value));
  return advance();
}

/// On to the next element.
bool TreeBuilder::advance() {
  if (!levels_.empty()) ++levels_.back().index;
  return true;
}

bool TreeBuilder::open(Json container) {
  Level level;
  level.container = place_value(std::move(container));
  levels_.push_back(std::move(level));
  return true;
}

bool TreeBuilder::close() {
  levels_.pop_back();
  return advance();
}

bool TreeBuilder::key(string_t& value) {
  Level& level = levels_.back();
  level.key = std::move(value);
  level.drop = !is_kept(level.key);
  if (level.container != nullptr && level.container->contains(level.key)) {
    mistakes_.add("duplicate_key", place(), "this key is given twice; keep one of the two");
  }
  return true;
}

/// The place of the value that the parser is at, e.g. task.poses[2].theta_deg.
std::string TreeBuilder::place() const {
  std::string text;
  for (const Level& level : levels_) {
    if (!level.key.empty()) {
      text += (text.empty() ? "" : ".") + presentable(level.key);
    } else {
      text += fmt::format("[{}]", level.index);
    }
  }
  return text;
}

/// The parser's reasons by a part of its message, first match wins, and what we say instead.
struct ParserMessage {
  std::string_view part, code, message;
};
constexpr ParserMessage parser_messages[] = {
    {"unexpected end of input", "cut_short", "the file breaks off here; it was cut short, or a bracket is not closed"},
    {"missing closing quote", "cut_inside_text",
     "the file breaks off inside a text; it was cut short, or a quote is not closed"},
    {"ill-formed UTF-8", "not_utf8", "this is not UTF-8 text; save the file in UTF-8"},
    {"control character", "line_break", "a line break or tab stands inside a text; write it as \\n or \\t"},
    {"surrogate", "half_escape", "this \\u escape is half of a pair; write the character itself"},
    {"forbidden character after backslash", "unknown_escape", "JSON has no such escape; write a backslash as \\\\"},
    {"'\\u' must be followed", "short_escape", "four hexadecimal digits must follow \\u"},
    {"invalid number", "invalid_number", "JSON numbers are finite and written like 12, -0.5 or 1e-3"},
    {"invalid comment", "open_comment", "this comment is not closed; comments start with //"},
    {"; expected end of input", "two_documents", "something follows the end of the JSON; remove it"},
    {"; expected ':'", "missing_colon", "a colon is missing between a key and its value"},
    {"; expected '}'", "unclosed_object", "a comma or } is missing here"},
    {"; expected ']'", "unclosed_list", "a comma or ] is missing here"},
};

bool belongs_to_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '+' || c == '-';
}

/// First byte of the word, number or text that ends at `end`, where the parser found it out of place.
std::size_t start_of_token(std::string_view text, std::size_t end) {
  std::size_t start = end;
  if (text[end] != '"') {
    while (start > 0 && belongs_to_word(text[start]) && belongs_to_word(text[start - 1])) --start;
    return start;
  }
  do {
    if (start == 0) return end;
    --start;
  } while (text[start] != '"' || (start > 0 && text[start - 1] == '\\'));
  return start;
}

constexpr ParserMessage single_quotes = {"", "single_quotes", "texts and keys stand in double quotes"};
constexpr ParserMessage no_key = {"", "no_key", "a key in double quotes is missing here"};
constexpr ParserMessage no_value = {"", "no_value", "a value is missing here"};
constexpr ParserMessage not_a_value = {
    "", "not_a_value",
    "this is not a JSON value; values are finite numbers like -12.5 (no NaN, no Infinity, "
    "no leading + or point), texts "
    "in double quotes, true, false, null, [ … ] and { … }"};
constexpr ParserMessage trailing_comma = {"", "trailing_comma", "a comma stands before the closing bracket; remove it"};
constexpr ParserMessage no_last_value = {"", "no_last_value",
                                         "a value is missing before the closing bracket; add it or remove the comma"};

/// What is wrong where the parser stopped, `here` being the character it stopped at.
ParserMessage syntax_saying(char here, std::string_view parsers_words) {
  const auto says = [&](std::string_view part) { return parsers_words.find(part) != std::string_view::npos; };
  if (here == '\'') return single_quotes;
  if (says("object key") && says("invalid literal")) return no_key;
  for (const ParserMessage& known : parser_messages) {
    if (says(known.part)) return known;
  }
  if (says("invalid literal")) return not_a_value;
  const bool closes = here == '}' || here == ']';
  if (closes && says("object key")) return trailing_comma;
  if (closes && says("parsing value")) return no_last_value;
  return says("object key") ? no_key : no_value;
}

bool TreeBuilder::parse_error(std::size_t position, const std::string& token, const Json::exception& exception) {
  constexpr int number_overflow = 406;
  if (exception.id == number_overflow) {
    mistakes_.add("number_too_large", place(),
                  fmt::format("{} is too large for a number; the most is about 1e308", in_quotes(token)),
                  {{"given", in_quotes(token)}});
  } else {
    const std::string_view words = exception.what();
    std::size_t offset = position == 0 ? 0 : position - 1;
    const bool is_inside = offset < text_.size();
    const bool is_inside_text = words.find("invalid string") != std::string_view::npos;
    if (is_inside && !is_inside_text) offset = start_of_token(text_, offset);
    const char here = is_inside ? text_[offset] : ' ';
    const ParserMessage known = syntax_saying(here, words);
    mistakes_.add(std::string(known.code), line_and_column(text_, offset), std::string(known.message));
  }
  return false;
}

}  // namespace

Result<Json> parse_json(std::string_view text, const JsonLimits& limits) {
  if (auto error = scan_json(text, limits)) return *std::move(error);
  Mistakes mistakes;
  TreeBuilder builder(text, limits, mistakes);
  constexpr bool strict = true, ignore_comments = true;
  Json::sax_parse(text.begin(), text.end(), &builder, Json::input_format_t::json, strict, ignore_comments);
  if (!mistakes.empty()) return mistakes.take();
  return builder.take();
}

}  // namespace linkwright
