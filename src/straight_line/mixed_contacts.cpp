#include "linkwright/straight_line/mixed_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "linkwright/algebra/power_series.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::size_t points = 4;  // that path and line have in common
using ContactSeries = RealSeries<points - 1>;

// Crank and arm of the point while the point runs along the line; by the way along it. From the input pivot, the line
// along x.
struct DyadOnLine {
  ContactSeries square;  // of the point's distance from the pivot
  ContactSeries area;    // four times that of the triangle pivot, point, pin
  ComplexSeries<points - 1> pin;
};

std::optional<DyadOnLine> dyad_on_line(Point point, int side, double crank, double arm) {
  DyadOnLine dyad;
  dyad.square.c = {std::norm(point), 2 * point.real(), 1, 0};
  ContactSeries product = dyad.square;  // twice the scalar product of pin and point
  product.c[0] += (crank - arm) * (crank + arm);
  const ContactSeries area_squared = 4 * crank * crank * dyad.square - product * product;
  const double flat = tolerance::dead_point_sine * tolerance::dead_point_sine * 4 * crank * crank * dyad.square.c[0];
  if (!(area_squared.c[0] > flat)) return std::nullopt;
  dyad.area = static_cast<double>(side) * square_root(area_squared);
  // pin = ½ (product + i area) / conj(point + t).
  const Point inverse = point / dyad.square.c[0];
  Point before{};
  for (std::size_t k = 0; k < points; ++k)
    dyad.pin.c[k] = before = (Point{0.5 * product.c[k], 0.5 * dyad.area.c[k]} - before) * inverse;
  return dyad;
}

struct Contacts {
  std::array<PlacedContact, points> at{};
  std::size_t count = 0;
};

// Those too close for four conditions of their own as one, at their mean.
Contacts confluent(std::span<const PlacedContact> contacts, double scale) {
  Contacts merged;
  for (const PlacedContact& next : contacts) {
    PlacedContact* last = merged.count == 0 ? nullptr : &merged.at[merged.count - 1];
    if (last && last->side == next.side && next.s - last->s < tolerance::double_contact * scale) {
      const int both = last->multiplicity + next.multiplicity;
      last->s += (next.s - last->s) * next.multiplicity / both;
      last->multiplicity = both;
    } else {
      merged.at[merged.count++] = next;
    }
  }
  return merged;
}

void require_four(std::span<const PlacedContact> contacts) {
  int count = 0;
  bool rises = true;
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    count += contacts[j].multiplicity;
    rises = rises && contacts[j].multiplicity > 0 && (j == 0 || contacts[j].s > contacts[j - 1].s);
  }
  require(count == static_cast<int>(points) && rises, "contacts of four points in all, by rising s");
}

// c₁ and G of c₀ + c₁ s + ⟨G, pin⟩ = ½ (square cos δ + area sin δ), times a weight that may vanish.
struct Solution {
  double c1 = 0;
  Point g{};
  double weight = 0;
};

class Conditions {
 public:
  explicit Conditions(Point turn) : turn_(turn) {}

  // The first one of all takes c₀ with it.
  void add(double s, const DyadOnLine& dyad, int multiplicity) {
    const auto right = [&](std::size_t k) {
      return 0.5 * (turn_.real() * dyad.square.c[k] + turn_.imag() * dyad.area.c[k]);
    };
    if (is_first_) {
      is_first_ = false;
      s_ = s, pin_ = dyad.pin.c[0], right_ = right(0);
    } else {
      add({s - s_, dyad.pin.c[0].real() - pin_.real(), dyad.pin.c[0].imag() - pin_.imag()}, right(0) - right_);
    }
    for (std::size_t k = 1; k < static_cast<std::size_t>(multiplicity); ++k)
      add({k == 1 ? 1.0 : 0.0, dyad.pin.c[k].real(), dyad.pin.c[k].imag()}, right(k));
  }

  // Nothing where two of the three conditions are one.
  [[nodiscard]] std::optional<Solution> solve() const {
    const Vector3 a = cross(row_[1], row_[2]), b = cross(row_[2], row_[0]), c = cross(row_[0], row_[1]);
    if (!(std::min({dot(a, a), dot(b, b), dot(c, c)}) > tolerance::dependent_rows * tolerance::dependent_rows))
      return std::nullopt;
    const Vector3 u = value_[0] * a + value_[1] * b + value_[2] * c;
    return Solution{u.x, {u.y, u.z}, dot(row_[0], a)};
  }

 private:
  void add(Vector3 row, double value) {
    const double length = std::sqrt(dot(row, row));
    row_[count_] = row / length;
    value_[count_++] = value / length;
  }

  Point turn_;
  bool is_first_ = true;
  double s_ = 0, right_ = 0;
  Point pin_{};
  std::array<Vector3, points - 1> row_{};
  std::array<double, points - 1> value_{};
  std::size_t count_ = 0;
};

// A number as a quotient, whose divisor may vanish.
struct Quotient {
  double over = 0, under = 1;
};

// The imaginary part y of B̂ = e^{−iδ} B₀: y² sin δ + Hx y + c₁² sin δ − Hy c₁ = 0, by rising y sin δ.
std::array<Quotient, 2> imaginary_parts(Point h, double c1, double sine) {
  const double last = c1 * (c1 * sine - h.imag());
  if (std::abs(sine) < tolerance::no_turn) return {Quotient{-last, h.real()}, Quotient{0, 0}};
  const double discriminant = h.real() * h.real() - 4 * sine * last;
  if (!(discriminant >= 0)) return {Quotient{0, 0}, Quotient{0, 0}};
  const double root = std::sqrt(discriminant);
  if (h.real() > 0) {
    const double q = -0.5 * (h.real() + root);
    return {Quotient{q, sine}, Quotient{last, q}};
  }
  const double q = 0.5 * (root - h.real());
  return {Quotient{last, q}, Quotient{q, sine}};
}

}  // namespace

std::array<LineDesign, 2> mixed_designs(const DirectedLine& line, Point input_pivot,
                                        std::span<const PlacedContact> contacts, double coupler_angle, double crank,
                                        double point_arm, double scale) {
  require_four(contacts);
  const Point turn = direction(coupler_angle), start = std::conj(line.direction) * (line.point - input_pivot);
  Conditions conditions(turn);
  const Contacts apart = confluent(contacts, scale);
  std::optional<DyadOnLine> first;
  for (std::size_t j = 0; j < apart.count; ++j) {
    const PlacedContact& contact = apart.at[j];
    const auto dyad = dyad_on_line(start + contact.s, contact.side, crank, point_arm);
    if (!dyad) return {};
    conditions.add(contact.s, *dyad, contact.multiplicity);
    if (contact.s == contacts.front().s) first = dyad;
  }
  const auto solution = conditions.solve();
  if (!first) first = dyad_on_line(start + contacts.front().s, contacts.front().side, crank, point_arm);
  if (!solution || !first) return {};
  const Point pin = first->pin.c[0], point = start + contacts.front().s, h = std::conj(turn) * solution->g;
  const auto to_fixed = [&](Point p) { return input_pivot + line.direction * p; };
  const auto design = [&](Quotient y) -> LineDesign {
    // B̂ times y.under and the weight, which keeps what is finite of a pivot at infinity.
    const Point seen{solution->c1 * y.under, y.over};
    const double weight = solution->weight * y.under, square = std::norm(seen);
    if (!(square > 0)) return {};
    const double inverse_share = dot(seen, y.under * h + std::conj(turn) * seen) / square;
    if (weight == 0 || inverse_share == 0) return {DesignKind::slider, {}};
    return line_design({{input_pivot, to_fixed(pin), to_fixed(turn * seen / weight),
                         to_fixed(pin + turn * (point - pin) / inverse_share)},
                        to_fixed(point)},
                       scale);
  };
  const auto parts = imaginary_parts(h, solution->c1, turn.imag());
  return {design(parts[0]), design(parts[1])};
}

std::vector<PrescribedPose> contact_poses(const TracingFourBar& linkage, const DirectedLine& line,
                                          std::span<const PlacedContact> contacts) {
  const Point pivot = linkage.bars.input_fixed, start = std::conj(line.direction) * (line.point - pivot);
  const double crank = linkage.bars.lengths().input, arm = std::abs(linkage.point - linkage.bars.input_moving);
  std::vector<PrescribedPose> poses;
  for (const PlacedContact& contact : contacts) {
    const Point point = start + contact.s;
    const auto dyad = dyad_on_line(point, contact.side, crank, arm);
    if (!dyad) return {};
    const Point to_point = point - dyad->pin.c[0];
    poses.push_back({{line.to_fixed(contact.s), std::arg(line.direction * to_point)}, {}});
    if (contact.multiplicity > 1)
      poses.back().derivatives.push_back({line.direction, ((1.0 - dyad->pin.c[1]) / to_point).imag()});
  }
  return poses;
}

}  // namespace linkwright
