#include "field_writer.hpp"

#include "files/json/base64.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {

using Layout = JsonWriter::Layout;

namespace {

Layout layout(bool on_lines) { return on_lines ? Layout::lines : Layout::one_line; }

double readable(double value, const Number& number) { return number.is_angle ? degrees_for_files(value) : value; }

}  // namespace

bool FieldWriter::member(const Field& field, bool /*is_required*/, Visit value) {
  if (!field.is_written) return true;
  json_.key(field.key);
  value(*this);
  return true;
}

void FieldWriter::constant(std::string_view key, std::string_view value) { json_.member(key, value); }

void FieldWriter::one_of(std::size_t current, std::span<const Alternative> alternatives, const OneOf& /*wrong*/) {
  alternatives[current].members(*this);
}

void FieldWriter::switch_on(const Field& field, std::size_t current, std::span<const Case> cases) {
  json_.member(field.key, cases[current].name);
  cases[current].members(*this);
}

void FieldWriter::orientation(GivenOrientation& orientation) {
  if (!orientation.form().empty()) return json_.json(orientation.form());
  json_.key("quaternion");
  json_.begin_list(Layout::one_line);
  for (const double part : {orientation.w(), orientation.v().x, orientation.v().y, orientation.v().z})
    json_.value(part);
  json_.end_list();
}

void FieldWriter::object(const Object& described, Visit members) {
  json_.begin_object(layout(described.on_lines));
  members(*this);
  json_.end_object();
}

void FieldWriter::kinds(std::size_t current, std::span<const Kind> all) { all[current].task(*this); }

void FieldWriter::shapes(std::size_t current, std::span<const Shape> shapes, std::optional<Wanted> /*otherwise*/) {
  shapes[current].value(*this);
}

void FieldWriter::null_or(bool& is_there, Visit value) { is_there ? value(*this) : json_.null(); }

void FieldWriter::list(const List& described, std::size_t count, VisitElement element) {
  json_.begin_list(layout(described.on_lines));
  for (std::size_t i = 0; i < count; ++i) element(*this, i);
  json_.end_list();
}

void FieldWriter::number(double& value, const Number& described) {
  described.shows_null&& value == described.null ? json_.null() : json_.value(readable(value, described));
}

void FieldWriter::whole(std::int64_t& value, const Whole& /*described*/) { json_.value(value); }
void FieldWriter::flag(bool& value) { json_.value(value); }
void FieldWriter::text(std::string& value) { json_.value(std::string_view(value)); }
void FieldWriter::name(std::size_t& chosen, std::span<const std::string_view> names) {
  require(chosen < names.size(), "what is written has a name in files");
  json_.value(names[chosen]);
}

void FieldWriter::pair(std::array<double, 2>& value, const Pair& described) {
  json_.begin_list(Layout::one_line);
  for (const double number : value) json_.value(readable(number, described.each));
  json_.end_list();
}

void FieldWriter::vector(Vector3& value, const Vector& /*described*/) {
  json_.begin_list(Layout::one_line);
  for (std::size_t i = 0; i < 3; ++i) json_.value(value[i]);
  json_.end_list();
}

void FieldWriter::foreign(std::string& object) { json_.json(object); }

void FieldWriter::keyed(const Keyed& described, std::span<const std::string> keys, VisitElement value) {
  json_.begin_object(layout(described.on_lines));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    json_.key(keys[i]);
    value(*this, i);
  }
  json_.end_object();
}

void FieldWriter::bytes(std::size_t rows, BytesOfRow of_row) {
  Base64Encoder encoder;
  std::string text;
  json_.begin_text();
  for (std::size_t row = 0; row < rows; ++row) {
    encoder.encode(of_row(row), text);
    json_.text_piece(text);
    text.clear();
  }
  encoder.finish(text);
  json_.text_piece(text);
  json_.end_text();
}

}  // namespace linkwright
