#include "space_reader.hpp"

#include <cmath>
#include <fmt/format.h>

#include "files/json/json.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"

namespace linkwright {

std::optional<double> read_quantity(const JsonValue& value) {
  const auto number = value.as_number();
  if (!number || std::abs(*number) <= largest_quantity) return number;
  value.mistake("quantity_range",
                fmt::format("{:g} is too large; give a number between ±{}, in a larger unit if need be", *number,
                            limit_text(largest_quantity)),
                {{"given", *number}, {"most", limit_text(largest_quantity)}});
  return std::nullopt;
}

std::optional<double> read_angle(const JsonValue& value) {
  const auto number = read_quantity(value);
  return number ? std::optional(radians(*number)) : std::nullopt;
}

std::optional<std::vector<double>> read_numbers(const JsonValue& value, std::size_t count, std::string_view what) {
  if (!value.json().is_array() || value.json().size() != count) {
    if (value.json().is_array())
      value.mistake("number_count", fmt::format("{} numbers {} belong here, not {}", count, what, value.json().size()),
                    {{"wanted", count}, {"form", what}, {"count", value.json().size()}});
    else
      value.mistake("numbers", fmt::format("{} numbers {} belong here", count, what),
                    {{"wanted", count}, {"form", what}});
    return std::nullopt;
  }
  std::vector<double> numbers;
  value.for_each({what}, [&](const JsonValue& item) {
    if (const auto number = item.as_number()) numbers.push_back(*number);
  });
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

std::optional<Vector3> read_vector(const JsonValue& value) {
  const auto numbers = read_numbers(value, 3, "[x, y, z]");
  return numbers ? std::optional(Vector3{(*numbers)[0], (*numbers)[1], (*numbers)[2]}) : std::nullopt;
}

std::optional<Vector3> read_bounded_vector(const JsonValue& value) {
  const auto vector = read_vector(value);
  if (!vector) return vector;
  for (const double coordinate : {vector->x, vector->y, vector->z}) {
    if (std::abs(coordinate) <= largest_quantity) continue;
    value.mistake("vector_range",
                  fmt::format("{:g} is too large; give numbers between ±{}, in a larger unit if need be", coordinate,
                              limit_text(largest_quantity)),
                  {{"given", coordinate}, {"most", limit_text(largest_quantity)}});
    return std::nullopt;
  }
  return vector;
}

std::optional<std::vector<Vector3>> read_vectors(const JsonValue& value, std::size_t most) {
  if (value.json().is_array() && value.json().size() > most) {
    value.mistake("too_many", fmt::format("{} are given; give at most {} at a time", value.json().size(), most),
                  {{"count", value.json().size()}, {"most", most}});
    return std::nullopt;
  }
  std::vector<Vector3> vectors;
  const bool is_list = value.for_each({"vectors", "a list [[x, y, z], …]"}, [&](const JsonValue& item) {
    if (const auto vector = read_bounded_vector(item)) vectors.push_back(*vector);
  });
  if (!is_list || vectors.size() != value.json().size()) return std::nullopt;
  return vectors;
}

namespace {

/// So many rows of as many numbers.
std::optional<std::vector<std::vector<double>>> read_rows(const JsonValue& value, std::size_t size,
                                                          std::string_view row) {
  if (!value.json().is_array() || value.json().size() != size) {
    value.mistake("rows", fmt::format("{0} rows of {0} numbers [{1}, …] belong here", size, row),
                  {{"size", size}, {"form", row}});
    return std::nullopt;
  }
  std::vector<std::vector<double>> rows;
  value.for_each({"rows"}, [&](const JsonValue& item) {
    if (auto numbers = read_numbers(item, size, row)) rows.push_back(*std::move(numbers));
  });
  if (rows.size() != size) return std::nullopt;
  return rows;
}

}  // namespace

std::optional<Matrix3x3> read_matrix3x3(const JsonValue& value) {
  const auto rows = read_rows(value, 3, "[a, b, c]");
  if (!rows) return std::nullopt;
  Matrix3x3 matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix(i, j) = (*rows)[i][j];
  }
  return matrix;
}

std::optional<Matrix4x4> read_matrix4x4(const JsonValue& value) {
  const auto rows = read_rows(value, 4, "[a, b, c, d]");
  if (!rows) return std::nullopt;
  Matrix4x4 matrix{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) matrix[i][j] = (*rows)[i][j];
  }
  return matrix;
}

}  // namespace linkwright
