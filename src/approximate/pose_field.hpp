#pragma once

#include <array>
#include <span>
#include <vector>

#include "approximate/body_linkage.hpp"

namespace linkwright {

/// A point of the body, and the circle that the places it takes come nearest to.
struct BodyDyad {
  Point body{}, center{};
  double radius = 0;
  double error = 0;  ///< root mean square of its places' distances from the circle, to first order
};

/// How near to a circle each point of a body comes to lie at some poses: of four, its zeros are the circle points of
/// Burmester's curve. With places Z_j = d_j + r_j z, and q_j = |Z_j|² less the constant |z|², all affine in z: scatter
/// matrices S2 of (X, Y), S3 of (q, X, Y), whose determinants are D and N. The mean of squares of (|Z − C|² − R²)² is
/// least at the centre of S2, and is N/D; over 4 R², it is that of the distances from the circle to first order (G.
/// Taubin, 1991).
class PoseField {
 public:
  /// Weights have a positive sum. At least three poses.
  PoseField(std::span<const BodyPose> poses, std::span<const double> weights);

  /// The mean of squares of the 3 × 3 determinants of all triples of poses is D, up to a factor; of quadruples N.
  struct Scatter {
    double qq, qx, qy, xx, xy, yy;
    [[nodiscard]] double two() const { return xx * yy - xy * xy; }
    [[nodiscard]] double three() const { return qq * two() - qx * (qx * yy - xy * qy) + qy * (qx * xy - xx * qy); }
  };
  /// Of mean values: sums over the sum of the weights.
  [[nodiscard]] Scatter scatter(Point z) const;
  [[nodiscard]] BodyDyad dyad(Point z) const;
  /// Mean square of the distances; infinite where the places are in line.
  [[nodiscard]] double mean_square(Point z) const;

  /// Local minima of the error in the whole plane of the body, the lowest first.
  [[nodiscard]] std::vector<Point> minima() const;
  /// Points along the field's valleys, `count` at most: lowest first, spread out.
  [[nodiscard]] std::vector<Point> valleys(std::size_t count) const;

 private:
  // Quadratic in x, y: c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y².
  using Quadratic = std::array<double, 6>;
  struct GridPlace {
    Point z;
    double value;
  };

  [[nodiscard]] std::vector<GridPlace> grid() const;
  [[nodiscard]] Point descended(Point z) const;

  std::array<Quadratic, 6> scatter_{};
  Point mean_origin_{}, mean_axis_{}, mean_turned_{};  ///< of d, r and conj(d) r
  double mean_square_origin_ = 0;
};

}  // namespace linkwright
