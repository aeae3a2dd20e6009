#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// A number, flag or word of the linkages that a result lists, as tables have it.
struct LinkageColumn {
  static constexpr bool usual = true;
  enum class Kind : std::uint8_t { number, flag, text };

  std::string name;  ///< its place in a result file: lengths.ground, input.center_point[0]
  Kind kind = Kind::number;
  std::string unit;         ///< deg, dB, the problem's unit of length, or empty
  std::string description;  ///< one line
  bool is_usual = false;    ///< in tables that do not say what they want
};

/// The columns as they are listed.
class LinkageColumns {
 public:
  /// In user's units of length.
  explicit LinkageColumns(std::string length_unit) : length_(std::move(length_unit)) {}

  void number(std::string name, std::string unit, std::string description, bool is_usual = false);
  void length(std::string name, std::string description, bool is_usual = false);
  void angle(std::string name, std::string description, bool is_usual = false);
  void flag(std::string name, std::string description, bool is_usual = false);
  void text(std::string name, std::string description, bool is_usual = false);
  /// x and y, or x, y and z.
  void coordinates(const std::string& name, std::string unit, const std::string& what, bool is_usual, int count);
  void point(const std::string& name, const std::string& what, bool is_usual = false);
  void axis(const std::string& name, const std::string& what, bool is_usual = false);
  void lengths(std::initializer_list<std::pair<const char*, const char*>> names);

  [[nodiscard]] const std::string& length_unit() const { return length_; }
  [[nodiscard]] std::vector<LinkageColumn> take() { return std::move(list_); }

 private:
  std::string length_;
  std::vector<LinkageColumn> list_;
};

// What several kinds have: how a linkage moves through its task, what it makes of a function, how it was checked.
void list_motion(LinkageColumns& list);
void list_function(LinkageColumns& list);
void list_verdict(LinkageColumns& list);

/// All columns of the linkages of a problem, those of its analyses last.
[[nodiscard]] std::vector<LinkageColumn> linkage_columns(const Problem& problem);

}  // namespace linkwright
