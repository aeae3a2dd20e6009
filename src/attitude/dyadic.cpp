#include "dyadic.hpp"

#include <array>

namespace linkwright {
namespace {

constexpr std::array<Vector3, 3> basis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

Dyadic Dyadic::unit() {
  Dyadic e;
  for (const Vector3& k : basis) e.dyads_.push_back({k, k});
  return e;
}

Dyadic Dyadic::cross(Vector3 p) {
  Dyadic product;
  for (const Vector3& k : basis) product.dyads_.push_back({linkwright::cross(p, k), k});
  return product;
}

Dyadic Dyadic::conjugate() const {
  Dyadic result;
  for (const Dyad& d : dyads_) result.dyads_.push_back({d.consequent, d.antecedent});
  return result;
}

double Dyadic::scalar() const {
  double sum = 0;
  for (const Dyad& d : dyads_) sum += dot(d.antecedent, d.consequent);
  return sum;
}

Vector3 Dyadic::vector() const {
  Vector3 sum;
  for (const Dyad& d : dyads_) sum = sum + linkwright::cross(d.antecedent, d.consequent);
  return sum;
}

Matrix3x3 Dyadic::matrix() const {
  Matrix3x3 sum;
  for (const Dyad& d : dyads_) sum = sum + dyadic_product(d.antecedent, d.consequent);
  return sum;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  Dyadic sum = a;
  sum.dyads_.insert(sum.dyads_.end(), b.dyads_.begin(), b.dyads_.end());
  return sum;
}

Dyadic operator*(double s, const Dyadic& a) {
  Dyadic product = a;
  for (Dyadic::Dyad& d : product.dyads_) d.antecedent = s * d.antecedent;
  return product;
}

Vector3 dot(const Dyadic& a, Vector3 c) {
  Vector3 sum;
  for (const Dyadic::Dyad& d : a.dyads_) sum = sum + dot(d.consequent, c) * d.antecedent;
  return sum;
}

Vector3 dot(Vector3 c, const Dyadic& a) { return dot(a.conjugate(), c); }

Dyadic dot(const Dyadic& a, const Dyadic& b) {
  Dyadic product;
  for (const Dyadic::Dyad& d : a.dyads_) product.dyads_.push_back({d.antecedent, dot(d.consequent, b)});
  return product;
}

}  // namespace linkwright
