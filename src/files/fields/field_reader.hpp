#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/json/json_object.hpp"

namespace linkwright {

/// What is done with members that nobody knows.
enum class OtherMembers { refused, ignored };

/// Reads fields from a value of a file. What is wrong goes to the mistakes; the struct then is as far as it was read.
class FieldReader final : public FieldVisitor {
 public:
  explicit FieldReader(const JsonValue& value, Mistakes& mistakes, OtherMembers others = OtherMembers::refused)
      : at_(value), mistakes_(mistakes), others_(others) {}

  bool member(const Field& field, bool is_required, Visit value) override;
  void constant(std::string_view key, std::string_view value) override;
  void refuse(std::string_view key, std::string_view code, const std::string& message, const Values& values) override;
  bool has(std::string_view key) const override;
  void keys(std::span<const std::string_view> in_order) override;
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

  void mistake(std::string_view code, const std::string& message, const Values& values) override;
  void check(FunctionRef<std::vector<Error>()> mistakes) override;

 private:
  bool read_at(JsonValue place, Visit value);
  /// A key is none that is known here, and like one of theirs.
  bool misspells_one_of(std::span<const Alternative> alternatives) const;
  void look_for_foreign_keys(Visit members);
  void list_keys_of(std::span<const Alternative> alternatives);

  JsonValue at_;
  Mistakes& mistakes_;
  OtherMembers others_;
  // Of the object in hand.
  std::vector<std::string_view> known_;  ///< its keys
  std::size_t told_ = 0;                 ///< how many of them keys() told, which are all then; otherwise 0
  bool is_listing_ = false;              ///< these keys are gathered, and nothing read
  std::size_t mistakes_before_ = 0;
};

/// The struct as a value of a file has it; nothing, with mistakes, where it cannot be read.
template <class Struct, class... Form>
[[nodiscard]] std::optional<Struct> read_fields(const JsonValue& value, Mistakes& mistakes,
                                                OtherMembers others = OtherMembers::refused, const Form&... form) {
  const std::size_t before = mistakes.size();
  Struct read{};
  FieldReader reader(value, mistakes, others);
  visit(reader, read, form...);
  return mistakes.size() == before ? std::optional(read) : std::nullopt;
}

}  // namespace linkwright
