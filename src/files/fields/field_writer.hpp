#pragma once

#include "fields/field_visitor.hpp"
#include "files/json/json_writer.hpp"

namespace linkwright {

/// Writes fields in their normal form.
class FieldWriter final : public FieldVisitor {
 public:
  explicit FieldWriter(JsonWriter& json) : json_(json) {}

  bool member(const Field& field, bool is_required, Visit value) override;
  void constant(std::string_view key, std::string_view value) override;
  void one_of(std::size_t current, std::span<const Alternative> alternatives, const OneOf& wrong) override;
  void switch_on(const Field& field, std::size_t current, std::span<const Case> cases) override;
  void orientation(GivenOrientation& orientation) override;

  void object(const Object& described, Visit members) override;
  void kinds(std::size_t current, std::span<const Kind> all) override;
  void shapes(std::size_t current, std::span<const Shape> shapes, std::optional<Wanted> otherwise) override;
  void null_or(bool& is_there, Visit value) override;
  void list(const List& described, std::size_t count, VisitElement element) override;
  void number(double& value, const Number& described) override;
  void whole(std::int64_t& value, const Whole& described) override;
  void flag(bool& value) override;
  void text(std::string& value) override;
  void name(std::size_t& chosen, std::span<const std::string_view> names) override;
  void pair(std::array<double, 2>& value, const Pair& described) override;
  void vector(Vector3& value, const Vector& described) override;
  void foreign(std::string& object) override;
  void keyed(const Keyed& described, std::span<const std::string> keys, VisitElement value) override;
  void bytes(std::size_t rows, BytesOfRow of_row) override;

 private:
  JsonWriter& json_;
};

/// The struct as a value. `form`: as of visit().
template <class Struct, class... Form>
void write_fields(JsonWriter& json, Struct value, const Form&... form) {
  FieldWriter writer(json);
  visit(writer, value, form...);
}

}  // namespace linkwright
