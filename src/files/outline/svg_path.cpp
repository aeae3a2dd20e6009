#include "svg_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "files/text/plain_text.hpp"

namespace linkwright {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Numbers, flags and letters out of an attribute.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  void skip(std::string_view what) { rest_.remove_prefix(std::min(rest_.find_first_not_of(what), rest_.size())); }
  /// The next number; nothing, and no step further, where none begins here.
  std::optional<double> number() {
    const std::size_t length = number_length();
    if (length == 0) return std::nullopt;
    const double read = leading_number(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return read;
  }
  std::optional<double> flag() {
    if (!rest_.starts_with('0') && !rest_.starts_with('1')) return std::nullopt;
    const double read = rest_.front() - '0';
    rest_.remove_prefix(1);
    return read;
  }
  [[nodiscard]] bool at_number() const { return number_length() > 0; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  char letter() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

 private:
  [[nodiscard]] std::size_t number_length() const {
    std::size_t i = 0, digits = 0;
    const auto at = [&](std::size_t k) { return k < rest_.size() ? rest_[k] : '\0'; };
    if (at(i) == '+' || at(i) == '-') ++i;
    for (; is_digit(at(i)); ++i) ++digits;
    if (at(i) == '.')
      for (++i; is_digit(at(i)); ++i) ++digits;
    if (digits == 0) return 0;
    const std::size_t exponent = (at(i + 1) == '+' || at(i + 1) == '-') ? i + 2 : i + 1;
    if ((at(i) == 'e' || at(i) == 'E') && is_digit(at(exponent)))
      for (i = exponent; is_digit(at(i));) ++i;
    return i;
  }
  std::string_view rest_;
};

constexpr std::string_view blanks = " \t\r\n\f\v", between_numbers = " \t\r\n\f\v,";

SvgMatrix turned_by(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  return {c, s, -s, c, 0, 0};
}

SvgMatrix matrix_of(std::string_view function, std::span<const double> n) {
  const auto slope = [&] { return std::tan(n[0] * std::numbers::pi / 180); };
  if (function == "matrix" && n.size() == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (function == "translate" && (n.size() == 1 || n.size() == 2)) return {1, 0, 0, 1, n[0], n.size() == 2 ? n[1] : 0};
  if (function == "scale" && (n.size() == 1 || n.size() == 2)) return {n[0], 0, 0, n[n.size() - 1], 0, 0};
  if (function == "rotate" && n.size() == 1) return turned_by(n[0]);
  if (function == "rotate" && n.size() == 3)
    return SvgMatrix{1, 0, 0, 1, n[1], n[2]} * turned_by(n[0]) * SvgMatrix{1, 0, 0, 1, -n[1], -n[2]};
  if (function == "skewX" && n.size() == 1) return {1, 0, slope(), 1, 0, 0};
  if (function == "skewY" && n.size() == 1) return {1, slope(), 0, 1, 0, 0};
  return {};
}

Point mixed(Point a, Point b, double share) { return a + (b - a) * share; }

/// An elliptic arc from its end points to its centre (SVG 1.1, F.6.5) as cubics of a quarter turn at most.
struct Ellipse {
  Point center;
  double rx, ry, tilt, from, turn;

  Point at(double angle) const { return center + direction(tilt) * Point{rx * std::cos(angle), ry * std::sin(angle)}; }
  Point slope(double angle) const { return direction(tilt) * Point{-rx * std::sin(angle), ry * std::cos(angle)}; }
};

Ellipse ellipse_through(Point start, Point end, double rx, double ry, double tilt, bool large, bool sweep) {
  const Point half = (start - end) / 2.0 * std::conj(direction(tilt));
  const double outside = std::norm(Point{half.real() / rx, half.imag() / ry});
  if (outside > 1) rx *= std::sqrt(outside), ry *= std::sqrt(outside);
  const double inside = std::norm(Point{half.real() / rx, half.imag() / ry});
  const double away = inside > 0 ? std::sqrt(std::max(0.0, 1 / inside - 1)) * (large == sweep ? -1 : 1) : 0;
  const Point center{away * rx * half.imag() / ry, -away * ry * half.real() / rx};
  const auto angle_of = [&](Point p) { return std::atan2((p - center).imag() / ry, (p - center).real() / rx); };
  const double from = angle_of(half);
  double turn = angle_of(-half) - from;
  if (sweep && turn < 0) turn += 2 * std::numbers::pi;
  if (!sweep && turn > 0) turn -= 2 * std::numbers::pi;
  return {(start + end) / 2.0 + direction(tilt) * center, rx, ry, tilt, from, turn};
}

/// The segments of a path as they come.
class PathPainter {
 public:
  PathPainter(const SvgMatrix& placed, StrokeCollector& collector) : placed_(placed), collector_(collector) {}

  void segment(char letter, std::span<const double> n) {
    const bool is_relative = letter >= 'a';
    const Point origin = is_relative ? now_ : Point{};
    const auto point = [&](std::size_t i) { return origin + Point{n[i], n[i + 1]}; };
    const char kind = is_relative ? static_cast<char>(letter - 'a' + 'A') : letter;
    switch (kind) {
      case 'M':
        return move_to(point(0));
      case 'Z':
        return close();
      case 'L':
        return line_to(point(0));
      case 'H':
        return line_to({origin.real() + n[0], now_.imag()});
      case 'V':
        return line_to({now_.real(), origin.imag() + n[0]});
      case 'C':
        return curve_to(kind, {point(0), point(2), point(4)}, point(2));
      case 'S':
        return curve_to('C', {mirrored('C'), point(0), point(2)}, point(0));
      case 'Q':
        return curve_to(kind, {point(0), point(2)}, point(0));
      case 'T': {
        const Point control = mirrored('Q');
        return curve_to('Q', {control, point(0)}, control);
      }
      case 'A':
        return arc_to(n, point(5));
      default:
        return;
    }
  }
  void end(bool closed) {
    if (!points_.empty()) collector_.add(points_, closed);
    points_.clear();
  }

 private:
  void move_to(Point p) {
    end(false);
    start_ = p;
    go({p});
  }
  void close() {
    end(true);
    now_ = start_;
    curve_ = 0;
  }
  void line_to(Point p) {
    begin();
    go({p});
  }
  /// After a Z the next segment begins where the last subpath did.
  void begin() {
    if (points_.empty()) points_.push_back(placed_(now_));
  }
  void go(const std::vector<Point>& next) {
    if (!collector_.step()) return;
    for (const Point p : next) points_.push_back(placed_(p));
    now_ = next.back();
    curve_ = 0;
  }
  /// The last control point of a curve of the same kind, seen from the other side.
  Point mirrored(char kind) const { return curve_ == kind ? 2.0 * now_ - control_ : now_; }

  void curve_to(char kind, std::vector<Point> controls, Point last_control) {
    begin();
    if (!collector_.step()) return;
    controls.insert(controls.begin(), now_);
    now_ = controls.back();
    for (Point& p : controls) p = placed_(p);
    const auto at = [&](double t) {
      std::vector<Point> row = controls;
      for (std::size_t left = row.size(); --left > 0;)
        for (std::size_t i = 0; i < left; ++i) row[i] = mixed(row[i], row[i + 1], t);
      return row.front();
    };
    const std::vector<Point> points = flattened(at, 0, 1);
    points_.insert(points_.end(), points.begin() + 1, points.end());
    curve_ = kind;
    control_ = last_control;
  }
  void arc_to(std::span<const double> n, Point end) {
    const double rx = std::abs(n[0]), ry = std::abs(n[1]);
    if (rx == 0 || ry == 0 || end == now_) return line_to(end);
    const Ellipse arc = ellipse_through(now_, end, rx, ry, n[2] * std::numbers::pi / 180, n[3] != 0, n[4] != 0);
    const double pieces = std::max(1.0, std::ceil(std::abs(arc.turn) / (std::numbers::pi / 2) - 1e-9));
    if (!(pieces <= 4)) return line_to(end);
    const double step = arc.turn / pieces, arm = 4.0 / 3 * std::tan(step / 4);
    const int last = static_cast<int>(pieces) - 1;
    for (int i = 0; i <= last; ++i) {
      const double from = arc.from + i * step, to = from + step;
      const Point next = i == last ? end : arc.at(to);
      curve_to('A', {arc.at(from) + arm * arc.slope(from), arc.at(to) - arm * arc.slope(to), next}, {});
    }
  }

  SvgMatrix placed_;
  StrokeCollector& collector_;
  std::vector<Point> points_;
  Point now_, start_, control_;
  char curve_ = 0;  // kind of the last segment where it is a curve
};

std::size_t count_of_numbers(char letter) {
  switch (letter | ' ') {
    case 'a':
      return 7;
    case 'c':
      return 6;
    case 's':
    case 'q':
      return 4;
    case 'm':
    case 'l':
    case 't':
      return 2;
    case 'h':
    case 'v':
      return 1;
    default:
      return 0;
  }
}

/// The numbers of one segment; false where they end too early.
bool read_segment(Scanner& scanner, char letter, std::span<double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_flag = (letter | ' ') == 'a' && (i == 3 || i == 4);
    const auto number = is_flag ? scanner.flag() : scanner.number();
    if (!number) return false;
    numbers[i] = *number;
    scanner.skip(between_numbers);
  }
  return true;
}

}  // namespace

SvgMatrix SvgMatrix::operator*(const SvgMatrix& inner) const {
  const Point x = (*this)({inner.a, inner.b}), y = (*this)({inner.c, inner.d}), o = (*this)({inner.e, inner.f});
  return {x.real() - e, x.imag() - f, y.real() - e, y.imag() - f, o.real(), o.imag()};
}

SvgMatrix read_transform(std::string_view text) {
  SvgMatrix all;
  for (std::size_t open = text.find('('); open != std::string_view::npos; open = text.find('(')) {
    const std::size_t close = text.find(')', open);
    if (close == std::string_view::npos) break;
    std::string_view function = text.substr(0, open);
    function.remove_prefix(std::min(function.find_first_not_of(between_numbers), function.size()));
    function = function.substr(0, function.find_first_of(blanks));
    all = all * matrix_of(function, read_numbers(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
  return all;
}

std::vector<double> read_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (Scanner scanner(text); !scanner.at_end();) {
    if (const auto number = scanner.number())
      numbers.push_back(*number);
    else
      (void)scanner.letter();
  }
  return numbers;
}

double attribute_number(std::string_view text) {
  Scanner scanner(text);
  scanner.skip(blanks);
  const double number = scanner.number().value_or(0);
  return std::isfinite(number) ? number : 0;
}

void draw_path(std::string_view data, const SvgMatrix& placed, StrokeCollector& collector) {
  Scanner scanner(data);
  PathPainter painter(placed, collector);
  scanner.skip(blanks);
  for (bool is_first = true; !scanner.at_end() && !collector.is_full(); is_first = false) {
    char letter = scanner.letter();
    const bool is_known =
        std::string_view("mzlhvcsqta").find(static_cast<char>(letter | ' ')) != std::string_view::npos;
    if (!is_known || (is_first && (letter | ' ') != 'm')) break;
    std::array<double, 7> numbers{};
    const std::span<double> used(numbers.data(), count_of_numbers(letter));
    scanner.skip(between_numbers);
    do {
      if (!read_segment(scanner, letter, used)) return painter.end(false);
      painter.segment(letter, used);
      if (letter == 'm') letter = 'l';  // further pairs are lines
      if (letter == 'M') letter = 'L';
    } while (!used.empty() && scanner.at_number() && !collector.is_full());
  }
  painter.end(false);
}

}  // namespace linkwright
