#include "space_writer.hpp"

#include "linkwright/files/number_text.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright {

using Layout = JsonWriter::Layout;

void write_numbers(JsonWriter& json, std::string_view key, std::initializer_list<double> numbers) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const double number : numbers) json.value(number);
  json.end_list();
}

void write_vector(JsonWriter& json, std::string_view key, Vector3 vector) {
  write_numbers(json, key, {vector.x, vector.y, vector.z});
}

namespace {

template <class Rows>
void write_rows(JsonWriter& json, std::string_view key, const Rows& rows, std::size_t width) {
  json.key(key);
  json.begin_list();
  for (const auto& row : rows) {
    json.begin_list(Layout::one_line);
    for (std::size_t j = 0; j < width; ++j) json.value(row[j]);
    json.end_list();
  }
  json.end_list();
}

}  // namespace

void write_vectors(JsonWriter& json, std::string_view key, const std::vector<Vector3>& vectors) {
  write_rows(json, key, vectors, 3);
}

void write_matrix(JsonWriter& json, std::string_view key, const Matrix3x3& matrix) {
  write_rows(json, key, matrix.row, 3);
}

void write_matrix(JsonWriter& json, std::string_view key, const Matrix4x4& matrix) { write_rows(json, key, matrix, 4); }

void write_quaternion(JsonWriter& json, std::string_view key, const UnitQuaternion& quaternion) {
  const UnitQuaternion q = quaternion.canonical();
  write_numbers(json, key, {q.w(), q.v().x, q.v().y, q.v().z});
}

void write_angle(JsonWriter& json, std::string_view key, double angle) { json.member(key, degrees_for_files(angle)); }

std::string attitude_file_text(FunctionRef<void(JsonWriter&)> members) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    json.begin_object();
    json.member("linkwright", file_version);
    members(json);
    json.end_object();
  }
  return text;
}

}  // namespace linkwright
