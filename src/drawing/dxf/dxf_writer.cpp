#include "dxf_writer.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

// A DXF file is a sequence of pairs: a line with a group code, a line with its value. Group 5 is a handle, 330 the
// handle of the owner, 100 a class.

void put(std::string& text, int code, std::string_view value) { text += fmt::format("{}\n{}\n", code, value); }

void put(std::string& text, int code, double value) { put(text, code, exact_text(value)); }

/// `code` the group of x; y follows at code + 10.
void put_point(std::string& text, int code, Point point) {
  put(text, code, point.real());
  put(text, code + 10, point.imag());
}

void put_point_in_space(std::string& text, int code, Point point) {
  put_point(text, code, point);
  put(text, code + 20, 0.0);
}

/// Pairs written "code value", separated by ';'.
void put_pairs(std::string& text, std::string_view pairs) {
  while (!pairs.empty()) {
    const std::size_t end = std::min(pairs.find(';'), pairs.size());
    const std::string_view pair = pairs.substr(0, end);
    const std::size_t gap = std::min(pair.find(' '), pair.size());
    text += fmt::format("{}\n{}\n", pair.substr(0, gap), pair.substr(std::min(gap + 1, pair.size())));
    pairs.remove_prefix(std::min(end + 1, pairs.size()));
  }
}

void begin_section(std::string& text, std::string_view name) {
  put(text, 0, "SECTION");
  put(text, 2, name);
}

void end_section(std::string& text) { put(text, 0, "ENDSEC"); }

void begin_table(std::string& text, std::string_view name, std::string_view handle, std::size_t count) {
  put_pairs(text, fmt::format("0 TABLE;2 {};5 {};330 0;100 AcDbSymbolTable;70 {}", name, handle, count));
}

/// A line of a table: its handle, its table's handle, its class and its name.
void put_record(std::string& text, std::string_view type, std::string_view handle, std::string_view table,
                std::string_view record_class, std::string_view name) {
  const int handle_code = type == "DIMSTYLE" ? 105 : 5;
  put_pairs(text, fmt::format("0 {};{} {};330 {};100 AcDbSymbolTableRecord;100 {};2 {}", type, handle_code, handle,
                              table, record_class, name));
}

void put_viewport_table(std::string& text, Point center, double height) {
  begin_table(text, "VPORT", "8", 1);
  put_record(text, "VPORT", "23", "8", "AcDbViewportTableRecord", "*Active");
  put_pairs(text, "70 0;10 0;20 0;11 1;21 1");
  put_point(text, 12, center);
  put_pairs(text, "13 0;23 0;14 0.5;24 0.5;15 0.5;25 0.5;16 0;26 0;36 1;17 0;27 0;37 0");
  put(text, 40, height);
  put_pairs(text, "41 1.5;42 50;43 0;44 0;50 0;51 0;71 0;72 1000;73 1;74 3;75 0;76 0;77 0;78 0");
  put_pairs(text, "0 ENDTAB");
}

void put_line_type_table(std::string& text) {
  begin_table(text, "LTYPE", "2", 3);
  std::string_view handles[] = {"24", "25", "26"}, names[] = {"ByBlock", "ByLayer", "Continuous"};
  for (std::size_t i = 0; i < 3; ++i) {
    put_record(text, "LTYPE", handles[i], "2", "AcDbLinetypeTableRecord", names[i]);
    put_pairs(text, "70 0;3 ;72 65;73 0;40 0");
  }
  put_pairs(text, "0 ENDTAB");
}

void put_layer_table(std::string& text, std::span<const DxfLayer> layers) {
  begin_table(text, "LAYER", "1", layers.size() + 1);
  const auto put_layer = [&](const DxfLayer& layer, unsigned handle) {
    put_record(text, "LAYER", fmt::format("{:X}", handle), "1", "AcDbLayerTableRecord", layer.name);
    put_pairs(text, fmt::format("70 0;62 {};6 Continuous;370 -3;390 13", layer.color));
  };
  unsigned handle = 0x40;
  put_layer({"0", 7}, 0x27);
  for (const DxfLayer& layer : layers) put_layer(layer, handle++);
  put_pairs(text, "0 ENDTAB");
}

void put_other_tables(std::string& text) {
  begin_table(text, "STYLE", "5", 1);
  put_record(text, "STYLE", "29", "5", "AcDbTextStyleTableRecord", "Standard");
  put_pairs(text, "70 0;40 0;41 1;50 0;71 0;42 2.5;3 txt;4 ;0 ENDTAB");
  begin_table(text, "VIEW", "7", 0);
  put_pairs(text, "0 ENDTAB");
  begin_table(text, "UCS", "6", 0);
  put_pairs(text, "0 ENDTAB");
  begin_table(text, "APPID", "3", 1);
  put_record(text, "APPID", "2A", "3", "AcDbRegAppTableRecord", "ACAD");
  put_pairs(text, "70 0;0 ENDTAB");
  begin_table(text, "DIMSTYLE", "4", 1);
  put_pairs(text, "100 AcDbDimStyleTable");
  put_record(text, "DIMSTYLE", "2B", "4", "AcDbDimStyleTableRecord", "Standard");
  put_pairs(text, "70 0;0 ENDTAB");
  begin_table(text, "BLOCK_RECORD", "9", 2);
  put_record(text, "BLOCK_RECORD", "17", "9", "AcDbBlockTableRecord", "*Model_Space");
  put_record(text, "BLOCK_RECORD", "1B", "9", "AcDbBlockTableRecord", "*Paper_Space");
  put_pairs(text, "0 ENDTAB");
}

void put_block(std::string& text, std::string_view name, std::string_view record, std::string_view begin,
               std::string_view end) {
  put_pairs(text,
            fmt::format("0 BLOCK;5 {};330 {};100 AcDbEntity;8 0;100 AcDbBlockBegin;2 {};70 0;10 0;20 0;30 0;3 {};1 ",
                        begin, record, name, name));
  put_pairs(text, fmt::format("0 ENDBLK;5 {};330 {};100 AcDbEntity;8 0;100 AcDbBlockEnd", end, record));
}

/// The dictionary that every drawing has, with groups and the plot style that layers refer to.
void put_objects(std::string& text) {
  begin_section(text, "OBJECTS");
  put_pairs(text, "0 DICTIONARY;5 A;330 0;100 AcDbDictionary;281 1;3 ACAD_GROUP;350 C;3 ACAD_PLOTSTYLENAME;350 12");
  put_pairs(text, "0 DICTIONARY;5 C;330 A;100 AcDbDictionary;281 1");
  put_pairs(text, "0 ACDBDICTIONARYWDFLT;5 12;330 A;100 AcDbDictionary;281 1;3 Normal;350 13");
  put_pairs(text, "100 AcDbDictionaryWithDefault;340 13;0 ACDBPLACEHOLDER;5 13;330 12");
  end_section(text);
}

}  // namespace

void DxfWriter::begin_entity(std::string_view type, std::string_view layer) {
  put_pairs(entities_, fmt::format("0 {};5 {:X};330 17;100 AcDbEntity;8 {}", type, next_handle_++, layer));
}

void DxfWriter::include(Point point, double margin) {
  low_ = {std::min(low_.real(), point.real() - margin), std::min(low_.imag(), point.imag() - margin)};
  high_ = {std::max(high_.real(), point.real() + margin), std::max(high_.imag(), point.imag() + margin)};
}

void DxfWriter::line(std::string_view layer, Point from, Point to) {
  begin_entity("LINE", layer);
  put(entities_, 100, "AcDbLine");
  put_point_in_space(entities_, 10, from);
  put_point_in_space(entities_, 11, to);
  include(from);
  include(to);
}

void DxfWriter::circle(std::string_view layer, Point center, double radius) {
  begin_entity("CIRCLE", layer);
  put(entities_, 100, "AcDbCircle");
  put_point_in_space(entities_, 10, center);
  put(entities_, 40, radius);
  include(center, radius);
}

void DxfWriter::arc(std::string_view layer, Point center, double radius, double from, double to) {
  begin_entity("ARC", layer);
  put(entities_, 100, "AcDbCircle");
  put_point_in_space(entities_, 10, center);
  put(entities_, 40, radius);
  put(entities_, 100, "AcDbArc");
  put(entities_, 50, degrees(wrap_positive(from)));
  put(entities_, 51, degrees(wrap_positive(to)));
  include(center, radius);
}

void DxfWriter::polyline(std::string_view layer, std::span<const Point> points, bool closed) {
  if (points.size() < 2) return;
  begin_entity("LWPOLYLINE", layer);
  put_pairs(entities_, fmt::format("100 AcDbPolyline;90 {};70 {};43 0", points.size(), closed ? 1 : 0));
  for (const Point point : points) {
    put_point(entities_, 10, point);
    include(point);
  }
}

void DxfWriter::text(std::string_view layer, Point position, double height, std::string_view content) {
  begin_entity("TEXT", layer);
  put(entities_, 100, "AcDbText");
  put_point_in_space(entities_, 10, position);
  put(entities_, 40, height);
  put(entities_, 1, content);
  put(entities_, 100, "AcDbText");
  include(position);
}

std::string DxfWriter::file() const {
  const bool is_empty = low_.real() > high_.real();
  const Point low = is_empty ? Point{0, 0} : low_, high = is_empty ? Point{1, 1} : high_;
  constexpr double room = 1.1;
  const double height = room * std::max(high.imag() - low.imag(), (high.real() - low.real()) / 1.5);
  const bool is_metric = units_ != 1 && units_ != 2;

  std::string text;
  begin_section(text, "HEADER");
  put_pairs(text, "9 $ACADVER;1 AC1015;9 $DWGCODEPAGE;3 ANSI_1252;9 $INSBASE;10 0;20 0;30 0;9 $EXTMIN");
  put_point_in_space(text, 10, low);
  put_pairs(text, "9 $EXTMAX");
  put_point_in_space(text, 10, high);
  put_pairs(text, fmt::format("9 $LTSCALE;40 1;9 $MEASUREMENT;70 {};9 $INSUNITS;70 {};9 $HANDSEED;5 {:X}",
                              is_metric ? 1 : 0, units_, next_handle_));
  end_section(text);
  begin_section(text, "CLASSES");
  end_section(text);
  begin_section(text, "TABLES");
  put_viewport_table(text, 0.5 * (low + high), height);
  put_line_type_table(text);
  put_layer_table(text, layers_);
  put_other_tables(text);
  end_section(text);
  begin_section(text, "BLOCKS");
  put_block(text, "*Model_Space", "17", "18", "19");
  put_block(text, "*Paper_Space", "1B", "1C", "1D");
  end_section(text);
  begin_section(text, "ENTITIES");
  text += entities_;
  end_section(text);
  put_objects(text);
  put(text, 0, "EOF");
  return text;
}

}  // namespace linkwright
