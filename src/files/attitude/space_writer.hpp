#pragma once

#include <string_view>

#include "files/json/json_writer.hpp"
#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/attitude/displacement.hpp"
#include "linkwright/attitude/euler_angles.hpp"

namespace linkwright {

/// Numbers as a list on one line.
void write_numbers(JsonWriter& json, std::string_view key, std::initializer_list<double> numbers);
/// `[x, y, z]`.
void write_vector(JsonWriter& json, std::string_view key, Vector3 vector);
/// A list of them.
void write_vectors(JsonWriter& json, std::string_view key, const std::vector<Vector3>& vectors);
/// Rows.
void write_matrix(JsonWriter& json, std::string_view key, const Matrix3x3& matrix);
void write_matrix(JsonWriter& json, std::string_view key, const Matrix4x4& matrix);
/// `[w, x, y, z]`, canonical.
void write_quaternion(JsonWriter& json, std::string_view key, const UnitQuaternion& quaternion);
/// An angle in radians as degrees that read back as the same radians.
void write_angle(JsonWriter& json, std::string_view key, double angle);

/// The text that `members` writes as one object with the version of the file.
[[nodiscard]] std::string attitude_file_text(FunctionRef<void(JsonWriter&)> members);

}  // namespace linkwright
