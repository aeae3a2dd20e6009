#pragma once

#include <string>
#include <string_view>

#include "fields/field_visitor.hpp"
#include "files/json/json.hpp"

namespace linkwright {

/// Describes fields as a JSON schema (2020-12). What has a name is a definition of its own.
class FieldSchema final : public FieldVisitor {
 public:
  /// Without defaults of what is only written.
  enum class Defaults { told, left_out };
  explicit FieldSchema(Defaults defaults = Defaults::told) : defaults_(defaults) {}

  /// The schema of what was visited, with its definitions. `rules`: what holds between fields, as a JSON merge patch,
  /// with the schema's own name.
  [[nodiscard]] OrderedJson take(const OrderedJson& rules = OrderedJson::object());

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
  void named(std::string_view name, Visit value) override;
  void described_in(std::string_view where, Visit value) override;
  void keyed(const Keyed& described, std::span<const std::string> keys, VisitElement value) override;
  void bytes(std::size_t rows, BytesOfRow of_row) override;

 private:
  OrderedJson of(Visit value);
  OrderedJson of(const Number& number) const;
  void define(std::string_view name, Sentence about, OrderedJson schema);
  void alternative(const Object& described, Visit members);

  Defaults defaults_;
  OrderedJson schema_ = OrderedJson::object();  ///< of the value in hand
  OrderedJson definitions_ = OrderedJson::object();
  std::vector<OrderedJson> alternatives_;  ///< of the object in hand
};

/// The schema of problem files. `rules`: as of take().
[[nodiscard]] OrderedJson problem_schema(const OrderedJson& rules = OrderedJson::object());

/// The schema of result files, likewise.
[[nodiscard]] OrderedJson result_schema(const OrderedJson& rules = OrderedJson::object());

/// The schema of what `linkwright analyze` and `linkwright tolerance` write, likewise.
[[nodiscard]] OrderedJson analysis_schema(const OrderedJson& rules = OrderedJson::object());

/// As people read it: what fits on a line of 120 characters is on one.
[[nodiscard]] std::string readable(const OrderedJson& json, std::size_t indent = 0, std::size_t beside = 0);

/// The definitions of a schema without rules as types of TypeScript, that of the whole under a name.
[[nodiscard]] std::string typescript(const OrderedJson& schema, std::string_view name);

}  // namespace linkwright
