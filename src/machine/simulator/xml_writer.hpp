#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace linkwright {

/// An XML file as it grows, an element a line.
class XmlWriter {
 public:
  using Attributes = std::vector<std::pair<std::string_view, std::string>>;

  void open(std::string_view name, const Attributes& attributes = {});
  void close();
  void leaf(std::string_view name, const Attributes& attributes = {});
  void text(std::string_view name, std::string_view content, const Attributes& attributes = {});
  void comment(std::string_view content);
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  void begin(std::string_view name, const Attributes& attributes);

  std::string file_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  std::vector<std::string> open_;
};

}  // namespace linkwright
