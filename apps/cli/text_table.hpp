#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace linkwright::cli {

/// A table of texts in aligned columns, two spaces between them. Columns are as wide as their widest entry; all but
/// those named with a leading '<' are aligned to the right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> headings);
  void add_row(std::vector<std::string> cells);
  [[nodiscard]] std::string text() const;

 private:
  std::vector<bool> to_the_left_;
  std::vector<std::vector<std::string>> rows_;  ///< the headings first
};

/// The text broken at spaces into lines of at most 100 columns; `indent` columns before every line but the first, which
/// keeps the spaces that it starts with.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent = 0);

/// "43.27°".
[[nodiscard]] std::string angle_text(double radians, int decimals = 2);

/// A title or unit from a file, without the control characters that could play tricks on a terminal.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace linkwright::cli
