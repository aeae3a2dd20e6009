#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/function_ref.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/core/result.hpp"

// What a file says of a struct is told once, by a function fields(FieldVisitor&, Struct&) that names its members.
// Visitors read them, write them, and describe them.
namespace linkwright {

/// What belongs in a place of a file: the name by which others word it, and in English.
struct Wanted {
  constexpr Wanted(std::string_view its_name, std::string_view in_english) : name(its_name), words(in_english) {}
  /// Something to copy, the same in all languages.
  constexpr Wanted(std::string_view example) : name(example), words(example) {}
  constexpr Wanted(const char* example) : Wanted(std::string_view(example)) {}

  std::string_view name, words;
};

#ifdef __EMSCRIPTEN__
inline constexpr bool describes_fields = false;  // the page makes no schema, and need not load what stands there only
#else
inline constexpr bool describes_fields = true;
#endif

/// A sentence for those who write files, which the schema says; empty in the page.
struct Sentence {
  constexpr Sentence(std::string_view its_words = "") : words(describes_fields ? its_words : "") {}
  constexpr Sentence(const char* its_words) : words(describes_fields ? its_words : "") {}

  std::string_view words;
};

/// A member of an object: its key, and a sentence on it.
struct Field {
  Field(std::string_view its_key, Sentence sentence = {}) : key(its_key), about(sentence) {}
  Field(const char* its_key) : Field(std::string_view(its_key)) {}

  /// What is asked for where it must be there and is not; otherwise a number, two numbers, …, as the value has it.
  [[nodiscard]] Field missing(Wanted what) const;
  [[nodiscard]] Field written(bool is) const;
  /// Left out, and nothing by default.
  [[nodiscard]] Field absent(bool is = true) const;
  /// What is nothing is written, as null; otherwise left out.
  [[nodiscard]] Field null_for_none() const;

  std::string_view key;
  Sentence about;
  std::optional<Wanted> wanted;
  bool is_written = true, is_absent = false, shows_none = false;
};

/// A number within bounds, which are in the unit of the file. Readers leave them to those who know what is wrong
/// beyond.
struct Number {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double least = -unlimited, most = unlimited;
  bool above = false, below = false;  ///< the least, the most itself is outside
  bool is_angle = false;              ///< radians in the struct, degrees in files
  bool is_whole = false;              ///< fractions are beyond the bounds, too
  std::optional<double> null = {};    ///< what null stands for, in the struct; nothing: it may not be null
  bool shows_null = false;            ///< what null stands for is written as null
  std::string_view name = "";         ///< of such numbers in the schema
  Sentence about = {};
};
struct Whole {
  std::int64_t least, most;
  /// Stands for what is no such number, and is out of bounds; nothing: a fraction is a mistake, and what is beyond ±1e9
  /// is held there.
  std::optional<std::int64_t> refused = {};
};
/// Two numbers in a list, which `form` shows: "[x, y]".
struct Pair {
  Wanted form;
  Number each = {};
  std::string_view name = "";
  Sentence about = {};
};
/// Three of them. `is_bounded`: readers themselves refuse what is beyond largest_quantity.
struct Vector {
  Number each = {};
  bool is_bounded = false;
  std::string_view name = "";
  Sentence about = {};
};
struct List {
  Wanted what;
  std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();  ///< for the schema
  /// Longer ones are refused before they are read, with this code and sentence on {count} and {most}.
  std::size_t most_read = std::numeric_limits<std::size_t>::max();
  std::string_view code = "", sentence = "";
  /// Said where all could be read and are not `most`, on {count}.
  std::string_view length_code = "", length_sentence = "", sentence_of_one = "";
  bool on_lines = false;       ///< an element a line
  bool is_of_length = false;   ///< of another length it is of another type
  std::string_view name = "";  ///< of such lists in the schema
  Sentence about = {};
};
struct Object {
  std::string_view name = "";  ///< in the schema
  Sentence about = {};
  bool on_lines = false;  ///< a member a line
};
/// An object whose keys come with the data: of what form, as a regular expression.
struct Keyed {
  std::string_view pattern;
  bool on_lines = false;
};
/// Names of an enumeration.
template <class Enumerator>
struct Names {
  std::vector<Enumerator> choices;
  std::string_view name = "";  ///< of the enumeration in the schema
};
/// Names by their index.
struct Words {
  std::vector<std::string_view> choices;
};

class FieldVisitor;
using Visit = FunctionRef<void(FieldVisitor&)>;
using KeptVisit = std::function<void(FieldVisitor&)>;
/// Of the element of that index, which may be one behind the last.
using VisitElement = FunctionRef<void(FieldVisitor&, std::size_t)>;
using BytesOfRow = FunctionRef<std::span<const std::uint8_t>(std::size_t row)>;

/// Members of which others of the object go without: those of its keys that tell that it is meant, then all of it.
struct Alternative {
  std::vector<std::string_view> keys;
  Object described;
  KeptVisit members;
};
/// What is said where none or two of the alternatives are there; of the latter {first} and {second} may be told. Where
/// nothing is said, the first that is there counts, and the last where none is.
struct OneOf {
  std::string_view none_code = "", none = "", two_code = "", two = "";
};
/// The members that go with a name; `with`: where this key is there, too.
struct Case {
  std::string_view name;
  Object described;
  KeptVisit members;
  std::string_view with = "";
};
/// A kind of task by a mechanism.
struct Kind {
  std::string_view kind, mechanism;
  KeptVisit task;
};
enum class JsonType : std::uint8_t { number, text, list, object };
/// A value of that type; of texts `only` this one, where it is not empty.
struct Shape {
  JsonType type;
  KeptVisit value;
  std::string_view only = "";
};

/// Walks a struct's members in the order in which they are written.
class FieldVisitor {
 public:
  FieldVisitor() = default;
  FieldVisitor(const FieldVisitor&) = delete;
  FieldVisitor& operator=(const FieldVisitor&) = delete;
  virtual ~FieldVisitor() = default;

  /// A member that must be there, and one that may be missing; whether nothing is wrong with it. `form`: as of visit().
  template <class Value, class... Form>
  bool required(const Field& field, Value& value, const Form&... form);
  template <class Value, class... Form>
  bool optional(const Field& field, Value& value, const Form&... form);

  /// Left out where it is nothing; null is a mistake.
  template <class Value, class... Form>
  bool given(const Field& field, std::optional<Value>& value, const Form&... form);

  /// Members of what is only written, whose values are worked out: one that is always there, where it is nothing as
  /// null, and one that is left out then.
  template <class Value, class... Form>
  void shown(const Field& field, Value value, const Form&... form);
  template <class Value, class... Form>
  void shown_if_any(const Field& field, std::optional<Value> value, const Form&... form);

  virtual bool member(const Field& field, bool is_required, Visit value) = 0;
  virtual void constant(std::string_view key, std::string_view value) = 0;
  /// A member that belongs elsewhere: why it is refused.
  virtual void refuse(std::string_view /*key*/, std::string_view /*code*/, const std::string& /*message*/,
                      const Values& /*values*/ = {}) {}
  /// The object has this member, where that decides on others; to those who write and describe it has not.
  [[nodiscard]] virtual bool has(std::string_view /*key*/) const { return false; }
  /// All keys of the object as they are told to those who use others, where members are read in another order; first.
  virtual void keys(std::span<const std::string_view> /*in_order*/) {}
  /// One of several sets of members, by which keys are there; `current`: the one in the struct.
  virtual void one_of(std::size_t current, std::span<const Alternative> alternatives, const OneOf& mistakes) = 0;
  /// A member with a name, and the members that go with it.
  virtual void switch_on(const Field& field, std::size_t current, std::span<const Case> cases) = 0;
  /// The members that give an orientation.
  virtual void orientation(GivenOrientation& orientation) = 0;

  virtual void object(const Object& described, Visit members) = 0;
  virtual void kinds(std::size_t current, std::span<const Kind> all) = 0;
  virtual void shapes(std::size_t current, std::span<const Shape> shapes, std::optional<Wanted> otherwise) = 0;
  virtual void null_or(bool& is_there, Visit value) = 0;
  virtual void list(const List& described, std::size_t count, VisitElement element) = 0;
  virtual void number(double& value, const Number& described) = 0;
  virtual void whole(std::int64_t& value, const Whole& described) = 0;
  virtual void flag(bool& value) = 0;
  virtual void text(std::string& value) = 0;
  /// `chosen`: names.size() where it is none of them, which cannot be written.
  virtual void name(std::size_t& chosen, std::span<const std::string_view> names) = 0;
  virtual void pair(std::array<double, 2>& value, const Pair& described) = 0;
  virtual void vector(Vector3& value, const Vector& described) = 0;
  /// An object that is none of ours, as JSON text.
  virtual void foreign(std::string& object) = 0;
  /// A value with a name of its own in the schema, and one that another schema describes there:
  /// "problem.schema.json#/$defs/pose".
  virtual void named(std::string_view /*name*/, Visit value) { value(*this); }
  virtual void described_in(std::string_view /*where*/, Visit value) { value(*this); }

  // Of what is only written.
  virtual void keyed(const Keyed& /*described*/, std::span<const std::string> /*keys*/, VisitElement /*value*/) {}
  /// A text of many bytes, as base64.
  virtual void bytes(std::size_t /*rows*/, BytesOfRow /*of_row*/) {}

  /// What is wrong here with what was read; of the second asked for only where all of the object could be read.
  virtual void mistake(std::string_view /*code*/, const std::string& /*message*/, const Values& /*values*/) {}
  virtual void check(FunctionRef<std::vector<Error>()> /*mistakes*/) {}
};

inline Field Field::missing(Wanted what) const {
  Field changed = *this;
  changed.wanted = what;
  return changed;
}

inline Field Field::written(bool is) const {
  Field changed = *this;
  changed.is_written = is;
  return changed;
}

inline Field Field::absent(bool is) const {
  Field changed = written(is_written && !is);
  changed.is_absent = is;
  return changed;
}

inline Field Field::null_for_none() const {
  Field changed = *this;
  changed.shows_none = true;
  return changed;
}

// What stands in a place, and what it is where the type does not tell.

inline void visit(FieldVisitor& v, double& value, const Number& number = {}) { v.number(value, number); }
inline void visit(FieldVisitor& v, bool& value) { v.flag(value); }
inline void visit(FieldVisitor& v, std::string& value) { v.text(value); }
inline void visit(FieldVisitor& v, Vector3& value, const Vector& vector) { v.vector(value, vector); }
inline void visit(FieldVisitor& v, std::array<double, 2>& value, const Pair& pair) { v.pair(value, pair); }

inline void visit(FieldVisitor& v, Point& value, const Pair& pair) {
  std::array<double, 2> coordinates = {value.real(), value.imag()};
  v.pair(coordinates, pair);
  value = {coordinates[0], coordinates[1]};
}

template <class Integer>
requires std::is_integral_v<Integer>
void visit(FieldVisitor& v, Integer& value, const Whole& whole) {
  auto wide = static_cast<std::int64_t>(value);
  v.whole(wide, whole);
  value = static_cast<Integer>(wide);
}

template <class Enumerator>
void visit(FieldVisitor& v, Enumerator& value, const Names<Enumerator>& names) {
  std::vector<std::string_view> written;
  std::size_t chosen = names.choices.size();  // none of them
  for (std::size_t i = 0; i < names.choices.size(); ++i) {
    written.push_back(name(names.choices[i]));
    if (names.choices[i] == value) chosen = i;
  }
  v.named(names.name, [&](FieldVisitor& to) { to.name(chosen, written); });
  if (chosen < names.choices.size()) value = names.choices[chosen];
}

inline void visit(FieldVisitor& v, std::size_t& chosen, const Words& words) { v.name(chosen, words.choices); }

/// A struct by its fields().
template <class Struct>
void visit(FieldVisitor& v, Struct& value) {
  fields(v, value);
}

template <class Value, class... Form>
void visit(FieldVisitor& v, std::optional<Value>& value, const Form&... form) {
  bool is_there = value.has_value();
  auto held = value.value_or(Value{});
  v.null_or(is_there, [&](FieldVisitor& to) { visit(to, held, form...); });
  value = is_there ? std::optional(held) : std::nullopt;
}

template <class Element, class... Form>
void visit(FieldVisitor& v, std::vector<Element>& values, const List& list, const Form&... form) {
  v.list(list, values.size(), [&](FieldVisitor& to, std::size_t i) {
    if (i == values.size()) values.emplace_back();
    visit(to, values[i], form...);
  });
}

/// Of a fixed length: what is too much is read and dropped.
template <class Element, std::size_t count, class... Form>
void visit(FieldVisitor& v, std::array<Element, count>& values, const List& list, const Form&... form) {
  Element more{};
  v.list(list, count, [&](FieldVisitor& to, std::size_t i) { visit(to, i < count ? values[i] : more, form...); });
}

/// What is only written, by `element`, with its index where that is asked for; those who describe see one made by
/// default.
template <class Source, class Element>
void visit_each(FieldVisitor& v, const List& list, const std::vector<Source>& sources, const Element& element) {
  const Source none{};
  v.list(list, sources.size(), [&](FieldVisitor& to, std::size_t i) {
    const Source& source = i < sources.size() ? sources[i] : none;
    if constexpr (std::is_invocable_v<Element, FieldVisitor&, const Source&, std::size_t>)
      element(to, source, i);
    else
      element(to, source);
  });
}
template <class Source, class Element>
void visit_or_null(FieldVisitor& v, const std::optional<Source>& source, const Element& element) {
  const Source none{};
  bool is_there = source.has_value();
  v.null_or(is_there, [&](FieldVisitor& to) { element(to, source ? *source : none); });
}

/// The alternative of a variant, made where it holds another one.
template <class Held, class Variant>
Held& as(Variant& variant) {
  if (!std::holds_alternative<Held>(variant)) variant = Held{};
  return std::get<Held>(variant);
}

inline Wanted wanted_of(const double& /*value*/) { return {"number", "a number"}; }
inline Wanted wanted_of(const Point& /*value*/) { return {"two_coordinates", "two numbers [x, y]"}; }
template <class Value>
Wanted wanted_of(const Value& /*value*/) {
  return "…";
}

template <class Value, class... Form>
bool FieldVisitor::required(const Field& field, Value& value, const Form&... form) {
  return member(field.wanted ? field : field.missing(wanted_of(value)), true,
                [&](FieldVisitor& to) { visit(to, value, form...); });
}

template <class Value, class... Form>
bool FieldVisitor::optional(const Field& field, Value& value, const Form&... form) {
  bool is_none = false;
  if constexpr (requires { value.has_value(); }) is_none = !value.has_value() && !field.shows_none;
  return member(field.written(field.is_written && !is_none), false,
                [&](FieldVisitor& to) { visit(to, value, form...); });
}

template <class Value, class... Form>
bool FieldVisitor::given(const Field& field, std::optional<Value>& value, const Form&... form) {
  return member(field.absent(!value), false, [&](FieldVisitor& to) {
    Value held = value.value_or(Value{});
    visit(to, held, form...);
    value = held;
  });
}

template <class Value, class... Form>
void FieldVisitor::shown(const Field& field, Value value, const Form&... form) {
  required(field, value, form...);
}

template <class Value, class... Form>
void FieldVisitor::shown_if_any(const Field& field, std::optional<Value> value, const Form&... form) {
  given(field, value, form...);
}

}  // namespace linkwright
