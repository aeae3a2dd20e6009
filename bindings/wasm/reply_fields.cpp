#include "reply_fields.hpp"

#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "reply_forms.hpp"

namespace linkwright::wasm {

namespace {

void values_field(FieldVisitor& v, const Values& values) {
  std::vector<std::string> names;
  for (const NamedValue& each : values) names.push_back(each.name);
  double number = 0;
  std::string word;
  const std::array shapes = {Shape{JsonType::number, [&](FieldVisitor& to) { visit(to, number); }},
                             Shape{JsonType::text, [&](FieldVisitor& to) { visit(to, word); }}};
  v.member(Field("values", "The numbers and words of the sentence."), true, [&](FieldVisitor& at) {
    at.keyed({.pattern = "^[a-z0-9_]+$"}, names, [&](FieldVisitor& to, std::size_t i) {
      if (i < values.size()) {
        if (const auto* held = std::get_if<double>(&values[i].value)) number = *held;
        if (const auto* held = std::get_if<std::string>(&values[i].value)) word = *held;
      }
      to.shapes(i < values.size() ? values[i].value.index() : 0, shapes, std::nullopt);
    });
  });
}

}  // namespace

void fields(FieldVisitor& v, const WordedNotice& of) {
  const Object described = {"notice",
                            "A sentence to be worded by the page: texts hold `<code>` with {placeholders} for "
                            "`values`. `message` is the same sentence in English as the command line prints it, for "
                            "codes that the texts do not know."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("code", of.notice.code);
    values_field(to, of.notice.values);
    to.shown("message", of.notice.message);
  });
}

void fields(FieldVisitor& v, const WordedMistake& of) {
  const Object described = {
      "mistake", "The caller's mistake, as the command line says it: worded like a notice, and where it is."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("code", of.mistake.code);
    to.shown("place", of.mistake.place);
    values_field(to, of.mistake.values);
    to.shown("message", of.mistake.message);
  });
}

std::vector<WordedNotice> worded(const std::vector<Notice>& notices) {
  std::vector<WordedNotice> all;
  for (const Notice& notice : notices) all.push_back({notice});
  return all;
}

namespace {

void visit_mistakes(FieldVisitor& v, const std::vector<Error>& mistakes) {
  std::vector<WordedMistake> all;
  for (const Error& mistake : mistakes) all.push_back({mistake});
  visit(v, all, forms::on_lines);
}

}  // namespace

std::string mistakes_json(const std::vector<Error>& mistakes) {
  return json_text_of(
      [&](JsonWriter& json) { write_reply(json, [&](FieldVisitor& v) { visit_mistakes(v, mistakes); }); });
}

std::string refusal_json(const std::vector<Error>& mistakes) {
  return R"({"mistakes": )" + mistakes_json(mistakes) + "}";
}

void write_reply(JsonWriter& json, Visit reply) {
  FieldWriter writer(json);
  reply(writer);
}

/// As it stands in result files. `name`: of the definition there.
void member_of_results(FieldVisitor& v, const Field& field, std::string_view name, Visit value) {
  const std::string where = "result.schema.json#/$defs/" + std::string(name);
  v.member(field, true, [&](FieldVisitor& at) { at.described_in(where, value); });
}

void place_field(FieldVisitor& v, MapPoint place) {
  v.shown("tau", std::array{place.input, place.output}, forms::two_numbers);
}

/// JSON text of an element of a result's `linkages`, of any kind; `or_null`: empty for none.
void record_field(FieldVisitor& v, std::string record, bool or_null) {
  const auto of_kind = [&](std::string_view name) {
    return Shape{JsonType::object,
                 [&record, where = "result.schema.json#/$defs/" + std::string(name)](FieldVisitor& at) {
                   at.described_in(where, [&](FieldVisitor& to) { to.foreign(record); });
                 }};
  };
  const std::array kinds = {of_kind("four_bar"), of_kind("six_bar"), of_kind("spherical_four_bar"),
                            of_kind("straight_line_four_bar")};
  bool is_there = !record.empty();
  v.member(Field("record", "The object of the result file."), true, [&](FieldVisitor& at) {
    const auto any = [&](FieldVisitor& to) { to.shapes(0, kinds, std::nullopt); };
    or_null ? at.null_or(is_there, any) : any(at);
  });
}

}  // namespace linkwright::wasm
