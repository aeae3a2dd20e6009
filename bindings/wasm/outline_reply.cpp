#include "files/fields/result_forms.hpp"
#include "files/json/json.hpp"
#include "linkwright/files/outline_file.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

/// Elements come as [index of the parent, name, attributes], the outermost one's parent is -1.
XmlElements elements_of(const Json& list) {
  XmlElements elements;
  for (const Json& each : list) {
    if (const auto parent = each.at(0).get<std::ptrdiff_t>(); parent >= 0)
      elements.at(static_cast<std::size_t>(parent)).children.push_back(elements.size());
    XmlElement& element = elements.emplace_back(XmlElement{each.at(1)});
    for (const auto& [key, value] : each.at(2).items()) element.attributes.emplace(key, value);
  }
  return elements;
}

OutlineShape shape_of(const DrawnShape& drawn, double scale, double size) {
  const OutlineFit fit = fit_outline(drawn, scale, size);
  return {body_outline(drawn, fit.scale, fit.placed), drawn.closed, drawn.frame, scale * drawn.width,
          scale * drawn.height};
}

}  // namespace

static void fields(FieldVisitor& v, const OutlineShape& of) {
  v.object({"outline_shape", "A shape of a drawing as the outline of a body."}, [&](FieldVisitor& to) {
    to.shown(Field("outline", "Corners in the moving frame, brought to the task's size."), of.outline, forms::on_a_line,
             forms::shown_point);
    to.shown(Field("closed", "Else a straight edge closes it."), of.closed);
    to.shown(Field("frame", "The edge of the sheet, or the border on it."), of.frame);
    to.shown(Field("width", "As drawn, in the task's unit of length where both are known."), of.width);
    to.shown("height", of.height);
  });
}

void fields(FieldVisitor& v, const OutlinesReply& of) {
  v.object({"outlines", "The shapes of a drawing, closed ones first, frames last, the largest first."},
           [&](FieldVisitor& to) { to.shown("shapes", of.shapes, forms::on_a_line); });
}

std::string outlines_reply(std::string_view text) {
  const Json request = Json::parse(text);
  const Result<Drawing> drawing = request.at("format") == "dxf"
                                      ? read_dxf_outlines(request.at("text").get<std::string>())
                                      : read_svg_outlines(elements_of(request.at("elements")));
  if (!drawing) return refusal_json(drawing.errors());
  const double scale = drawing_scale(drawing->unit_mm, request.at("length_unit").get<std::string>());
  OutlinesReply reply;
  for (const DrawnShape& shape : drawing->shapes) reply.shapes.push_back(shape_of(shape, scale, request.at("size")));
  return text_of(reply);
}

}  // namespace linkwright::wasm
