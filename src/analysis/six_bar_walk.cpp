#include "analysis/six_bar_walk.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

using Vector4 = std::array<double, 4>;

/// Lower triangle L of the Gram matrix J Jᵀ = L Lᵀ, with the inverses of its diagonal.
struct Cholesky {
  std::array<Vector4, 4> l{};
  bool regular = true;

  explicit Cholesky(const std::array<Vector4, 4>& gram) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k <= i; ++k) {
        double sum = gram[i][k];
        for (std::size_t m = 0; m < k; ++m) sum -= l[i][m] * l[k][m];
        if (k < i) {
          l[i][k] = sum * l[k][k];
          continue;
        }
        regular = regular && sum > 0;
        l[i][i] = sum > 0 ? 1 / std::sqrt(sum) : 0;
      }
  }

  /// L⁻¹ b.
  [[nodiscard]] Vector4 forwards(Vector4 b) const {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t m = 0; m < i; ++m) b[i] -= l[i][m] * b[m];
      b[i] *= l[i][i];
    }
    return b;
  }
  /// L⁻ᵀ b.
  [[nodiscard]] Vector4 backwards(Vector4 b) const {
    for (std::size_t i = 4; i-- > 0;) {
      for (std::size_t m = i + 1; m < 4; ++m) b[i] -= l[m][i] * b[m];
      b[i] *= l[i][i];
    }
    return b;
  }
};

double squares(const Vector4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]; }

// The Jacobian's columns are i·(uᵢ, vᵢ). Turned back by i, which changes neither the Gram matrix nor lengths, they are
// the terms themselves.
Vector4 column(Point u, Point v) { return {u.real(), u.imag(), v.real(), v.imag()}; }
Vector4 turned_column(Point u, Point v) { return {-u.imag(), u.real(), -v.imag(), v.real()}; }

Cholesky gram_of(const LoopValues& values) {
  std::array<Vector4, 4> gram{};
  for (std::size_t i = 0; i < 5; ++i) {
    const Vector4 c = column(values.u[i], values.v[i]);
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t k = 0; k <= r; ++k) gram[r][k] += c[r] * c[k];
  }
  return Cholesky(gram);
}

}  // namespace

double dot(const TurnVector& a, const TurnVector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(const TurnVector& a) { return std::sqrt(dot(a, a)); }

TurnVector shortest_way(const SixBarTurns& from, const SixBarTurns& to) {
  TurnVector way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = std::arg(std::conj(from[i + 1]) * to[i + 1]);
  return way;
}

SixBarTurns stepped(const SixBarTurns& turns, const TurnVector& way) {
  SixBarTurns result = turns;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double x = way[i], size = 1 + x * x / 4;
    const Point r = turns[i + 1] * Point{(1 - x * x / 4) / size, x / size};
    result[i + 1] = r * ((3 - std::norm(r)) / 2);  // rounding must not add up
  }
  return result;
}

// With J the Jacobian and J⁺ its inverse on the planes normal to the tangent, body i's column changes over a distance d
// by at most dᵢ times a vector of the plane of that column and the column turned by a right angle: after J⁺ at most
// βᵢ dᵢ, βᵢ² = |J⁺ i cᵢ|² + |J⁺ cᵢ|². With Λ = max βᵢ the Jacobian thus stays regular on those planes within |d| < 1/Λ,
// and the loops are injective on the part of each plane within the ball: one strand. At a quarter of that radius the
// strand's slope against the tangent is at most (1/4)/(1 − 1/4) = 1/3 and Newton's method converges from the tangent
// (Kantorovich). Units of the loops and their combination do not matter.
SixBarStrand strand_at(const SixBarLoops& loops, const SixBarTurns& turns) {
  SixBarStrand strand{turns, {}, {}, 0, LoopValues(loops, turns)};
  const LoopValues& values = strand.values;
  const Cholesky factor = gram_of(values);
  const TurnVector minors = values.minors();
  const double volume = norm(minors);
  if (!factor.regular || !(volume > 0)) return strand;
  for (std::size_t i = 0; i < 5; ++i) strand.tangent[i] = minors[i] / volume;

  double steepest = 0;
  // J δ = −F with J = i·column: the columns' sum Σ cᵢ δᵢ is i F.
  const Vector4 error = factor.forwards(turned_column(values.f, values.g));
  const Vector4 weights = factor.backwards(error);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vector4 c = column(values.u[i], values.v[i]);
    const double beta = squares(factor.forwards(c)) + squares(factor.forwards(turned_column(values.u[i], values.v[i])));
    steepest = std::max(steepest, beta);
    strand.correction[i] = c[0] * weights[0] + c[1] * weights[1] + c[2] * weights[2] + c[3] * weights[3];
  }
  strand.reach = steepest > 0 ? 0.25 / std::sqrt(steepest) : 0;
  return strand;
}

std::optional<SixBarStrand> corrected(const SixBarLoops& loops, const SixBarTurns& turns, double accuracy) {
  constexpr int max_corrections = 12;
  SixBarStrand strand = strand_at(loops, turns);
  for (int i = 0; i < max_corrections; ++i) {
    if (!(strand.reach > 0)) return std::nullopt;
    const double size = norm(strand.correction);
    // Near singular places rounding of the loops, 1e-15, is magnified as the reach is diminished.
    if (size <= std::max(accuracy, tolerance::loop_rounding_per_reach / strand.reach)) return strand;
    if (!(size < 1)) return std::nullopt;
    strand = strand_at(loops, stepped(strand.turns, strand.correction));
  }
  return std::nullopt;
}

}  // namespace linkwright
