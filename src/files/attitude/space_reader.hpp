#pragma once

#include <array>
#include <optional>
#include <vector>

#include "files/json/json_object.hpp"
#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/attitude/displacement.hpp"
#include "linkwright/files/orientation_file.hpp"

namespace linkwright {

/// Lengths, rates and angles in degrees lie between ± this: their products stay far from overflow.
inline constexpr double largest_quantity = 1e12;

/// A number within ±largest_quantity.
[[nodiscard]] std::optional<double> read_quantity(const JsonValue& value);
/// An angle in degrees as radians.
[[nodiscard]] std::optional<double> read_angle(const JsonValue& value);

/// So many numbers of any size; `what` shows them ("[x, y, z]").
[[nodiscard]] std::optional<std::vector<double>> read_numbers(const JsonValue& value, std::size_t count,
                                                              std::string_view what);
/// Three numbers of any size.
[[nodiscard]] std::optional<Vector3> read_vector(const JsonValue& value);
/// Three numbers within ±largest_quantity.
[[nodiscard]] std::optional<Vector3> read_bounded_vector(const JsonValue& value);
/// At most `most` such vectors.
[[nodiscard]] std::optional<std::vector<Vector3>> read_vectors(const JsonValue& value, std::size_t most = 1000);
/// Three rows of three numbers of any size.
[[nodiscard]] std::optional<Matrix3x3> read_matrix3x3(const JsonValue& value);
/// Four rows of four numbers of any size.
[[nodiscard]] std::optional<Matrix4x4> read_matrix4x4(const JsonValue& value);

/// An orientation in one of its forms (orientation_file.hpp).
[[nodiscard]] std::optional<StoredOrientation> read_orientation(const JsonValue& value, Mistakes& mistakes);

/// The value of a result, or its errors as mistakes in this place.
template <class T>
[[nodiscard]] std::optional<T> accepted(const JsonValue& value, const Result<T>& result) {
  if (result) return *result;
  for (const Error& error : result.errors()) value.mistake(error.code, error.message, error.values);
  return std::nullopt;
}

}  // namespace linkwright
