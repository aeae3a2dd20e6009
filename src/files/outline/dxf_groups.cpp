#include "dxf_groups.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "files/text/plain_text.hpp"
#include "strokes.hpp"

namespace linkwright {
namespace {

/// The lines of a text, whatever ends them.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    ++number_;
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    const bool is_pair = end != std::string_view::npos && rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + (is_pair ? 2 : 1));
    return trimmed(line);
  }
  [[nodiscard]] std::string place() const { return fmt::format("line {}", number_); }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// Groups as they come: sections, in them blocks, in both entities.
class DxfReader {
 public:
  explicit DxfReader(std::string_view text) : lines_(text) {}

  Result<DxfFile> read() {
    while (const auto line = lines_.next()) {
      DxfGroup group;
      const auto [end, error] = std::from_chars(line->data(), line->data() + line->size(), group.code);
      if (error != std::errc{} || end != line->data() + line->size()) {
        if (line->empty() && !lines_.next()) break;  // a blank last line
        return began_ ? unreadable_drawing("dxf_group", lines_.place(), "a group of a DXF begins with a whole number")
                      : not_dxf();
      }
      const auto value = lines_.next();
      if (!value) return cut_off();
      group.value = *value;
      if (group.code == 0 && group.value == "EOF") break;
      take(group);
    }
    if (!began_) return not_dxf();
    if (!section_.empty() || in_section_head_) return cut_off();
    return std::move(file_);
  }

 private:
  static Error not_dxf() {
    return unreadable_drawing("not_dxf", "", "it does not begin with a SECTION as an ASCII DXF does");
  }
  Error cut_off() const {
    return unreadable_drawing("dxf_cut_off", lines_.place(), "the file ends within a section; it is cut off");
  }

  void take(const DxfGroup& group) {
    if (group.code == 0 && group.value == "SECTION") {
      began_ = in_section_head_ = true;
      section_ = "";
    } else if (in_section_head_) {
      in_section_head_ = false;
      section_ = group.code == 2 ? group.value : "?";
    } else if (group.code == 0 && group.value == "ENDSEC") {
      section_ = "";
      block_ = nullptr;
      open_ = nullptr;
    } else if (section_ == "HEADER") {
      take_header(group);
    } else if (section_ == "ENTITIES") {
      take_entity(group, file_.entities);
    } else if (section_ == "BLOCKS") {
      take_block(group);
    }
  }
  void take_header(const DxfGroup& group) {
    if (group.code == 9) variable_ = group.value;
    if (variable_ == "$INSUNITS" && group.code == 70) file_.unit = static_cast<int>(to_whole(group.value));
  }
  void take_block(const DxfGroup& group) {
    if (group.code == 0 && group.value == "BLOCK") {
      read_ = {};
      name_ = "";
      block_ = &read_;
      open_ = nullptr;
    } else if (group.code == 0 && group.value == "ENDBLK") {
      if (block_ != nullptr) file_.blocks[name_] = std::move(read_);
      block_ = nullptr;
      open_ = nullptr;
    } else if (block_ != nullptr && (group.code == 0 || open_ != nullptr)) {
      take_entity(group, read_.entities);
    } else if (group.code == 2) {
      name_ = group.value;
    } else if (group.code == 10) {
      read_.x = leading_number(group.value);
    } else if (group.code == 20) {
      read_.y = leading_number(group.value);
    }
  }
  void take_entity(const DxfGroup& group, std::vector<DxfEntity>& entities) {
    if (group.code == 0) {
      entities.push_back({group.value, {}});
      open_ = &entities.back();
    } else if (open_ != nullptr) {
      open_->groups.push_back(group);
    }
  }
  static double to_whole(std::string_view text) {
    const double number = leading_number(text);
    return std::abs(number) < 1e9 ? std::trunc(number) : 0;
  }

  Lines lines_;
  DxfFile file_;
  DxfBlock read_;
  DxfBlock* block_ = nullptr;
  DxfEntity* open_ = nullptr;  // takes the groups that come
  std::string_view section_, variable_, name_;
  bool began_ = false, in_section_head_ = false;
};

}  // namespace

std::string_view DxfEntity::text(int code) const {
  for (std::size_t i = groups.size(); i-- > 0;)
    if (groups[i].code == code) return groups[i].value;
  return "";
}

double DxfEntity::number(int code, double otherwise) const {
  for (std::size_t i = groups.size(); i-- > 0;)
    if (groups[i].code == code) return leading_number(groups[i].value);
  return otherwise;
}

int DxfEntity::whole_number(int code) const {
  const double read = number(code, 0);
  return std::abs(read) < 2e9 ? static_cast<int>(read) : 0;
}

Result<DxfFile> read_dxf(std::string_view text) { return DxfReader(text).read(); }

}  // namespace linkwright
