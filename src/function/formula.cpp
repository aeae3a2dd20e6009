#include "linkwright/function/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Kind = Formula::Kind;

constexpr double one_degree = pi / 180;

const std::array<std::pair<std::string_view, Formula>, 12> known = {{{"x", {Kind::power, 1, 1}},
                                                                     {"sqrt", {Kind::power, 0.5, 1}},
                                                                     {"log", {Kind::logarithm, 1, 1}},
                                                                     {"log10", {Kind::logarithm, 1, 1}},
                                                                     {"ln", {Kind::natural_logarithm, 1, 1}},
                                                                     {"exp", {Kind::exponential, 1, 1}},
                                                                     {"sin", {Kind::sine, 1, 1}},
                                                                     {"cos", {Kind::cosine, 1, 1}},
                                                                     {"tan", {Kind::tangent, 1, 1}},
                                                                     {"sin_deg", {Kind::sine, 1, one_degree}},
                                                                     {"cos_deg", {Kind::cosine, 1, one_degree}},
                                                                     {"tan_deg", {Kind::tangent, 1, one_degree}}}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }

/// Reads from left to right; what cannot be read leaves the place where it stands.
class FormulaReader {
 public:
  explicit FormulaReader(std::string_view text) : text_(text) {}

  [[nodiscard]] FormulaReading read() {
    const double sign = read_sign();
    const auto before = number();
    if (before) take('*');
    auto formula = function();
    if (!formula) return wrong();
    formula->factor = sign * before.value_or(1);
    if (!read_tail(*formula) || !at_end()) return wrong();
    return {formula, 0};
  }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  [[nodiscard]] bool at_end() {
    skip_spaces();
    return at_ == text_.size();
  }
  [[nodiscard]] bool sees(char c) {
    skip_spaces();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool take(char c) {
    if (!sees(c)) return false;
    ++at_;
    return true;
  }
  double read_sign() {
    if (take('-')) return -1;
    take('+');
    return 1;
  }
  [[nodiscard]] FormulaReading wrong() {
    skip_spaces();
    // Characters, not bytes.
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    const std::string_view read = text_.substr(0, at_);
    return {std::nullopt,
            static_cast<int>(at_ - static_cast<std::size_t>(std::count_if(read.begin(), read.end(), continues))) + 1};
  }

  void skip_digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }
  /// An unsigned number, whatever the language of the machine. An e without digits behind it is the beginning of exp.
  [[nodiscard]] std::optional<double> number() {
    skip_spaces();
    const std::size_t start = at_;
    skip_digits();
    if (at_ < text_.size() && text_[at_] == '.') ++at_;
    skip_digits();
    if (std::none_of(text_.begin() + static_cast<std::ptrdiff_t>(start),
                     text_.begin() + static_cast<std::ptrdiff_t>(at_), is_digit)) {
      at_ = start;
      return std::nullopt;
    }
    skip_power_of_ten();
    std::istringstream stream{std::string(text_.substr(start, at_ - start))};
    stream.imbue(std::locale::classic());
    double value = 0;
    if (stream >> value && std::isfinite(value)) return value;
    at_ = start;
    return std::nullopt;
  }
  void skip_power_of_ten() {
    if (at_ == text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return;
    std::size_t digits = at_ + 1;
    if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
    if (digits == text_.size() || !is_digit(text_[digits])) return;
    at_ = digits;
    skip_digits();
  }

  [[nodiscard]] std::optional<Formula> function() {
    skip_spaces();
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    const auto* const found =
        std::find_if(known.begin(), known.end(), [&](const auto& entry) { return entry.first == name; });
    if (found == known.end()) {
      at_ = start;
      return std::nullopt;
    }
    Formula formula = found->second;
    if (name == "x" && take('^')) {
      const double sign = read_sign();
      const auto exponent = number();
      if (!exponent) return std::nullopt;
      formula.exponent = sign * *exponent;
    }
    return read_argument() ? std::optional(formula) : std::nullopt;
  }
  [[nodiscard]] bool read_argument() { return !take('(') || (take('x') && take(')')); }

  [[nodiscard]] bool read_tail(Formula& formula) {
    if (sees('*') || sees('/')) {
      const bool divides = text_[at_++] == '/';
      const std::size_t here = at_;
      const auto value = number();
      if (!value || (divides && *value == 0)) {
        at_ = here;
        return false;
      }
      formula.factor = divides ? formula.factor / *value : formula.factor * *value;
    }
    if (!sees('+') && !sees('-')) return true;
    const double sign = read_sign();
    const auto value = number();
    formula.addend = sign * value.value_or(0);
    return value.has_value();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

double base(const Formula& f, double x) {
  switch (f.kind) {
    case Kind::power:
      return f.exponent == 0.5 ? std::sqrt(x) : std::pow(x, f.exponent);
    case Kind::logarithm:
      return std::log10(x);
    case Kind::natural_logarithm:
      return std::log(x);
    case Kind::exponential:
      return std::exp(x);
    case Kind::sine:
      return std::sin(f.unit * x);
    case Kind::cosine:
      return std::cos(f.unit * x);
    case Kind::tangent:
      break;
  }
  return std::tan(f.unit * x);
}

}  // namespace

double Formula::y(double x) const { return factor * base(*this, x) + addend; }

FormulaReading read_formula(std::string_view text) { return FormulaReader(text).read(); }

}  // namespace linkwright
