#include "engine/geometry/exact_predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2.0;

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// A number as an exact sum of doubles that do not overlap, smallest first, without zeros.
class Expansion {
 public:
  Expansion() = default;
  /// The exact difference a - b.
  static Expansion difference(double a, double b) {
    Expansion result;
    result.add(a);
    result.add(-b);
    return result;
  }

  /// Adds a double (grow-expansion): the error of each addition remains as a component.
  void add(double b) {
    std::size_t kept = 0;
    double sum = b;
    for (std::size_t i = 0; i < count_; ++i) {
      const double total = sum + parts_[i];
      const double virtualPart = total - sum;
      const double error = (sum - (total - virtualPart)) + (parts_[i] - virtualPart);
      if (error != 0.0) parts_[kept++] = error;
      sum = total;
    }
    if (sum != 0.0) parts_[kept++] = sum;
    count_ = kept;
  }

  void add(const Expansion& other, double sign) {
    for (std::size_t i = 0; i < other.count_; ++i) add(sign * other.parts_[i]);
  }

  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion result;
    for (std::size_t i = 0; i < a.count_; ++i) {
      for (std::size_t k = 0; k < b.count_; ++k) {
        const double product = a.parts_[i] * b.parts_[k];
        result.add(productError(a.parts_[i], b.parts_[k], product));
        result.add(product);
      }
    }
    return result;
  }

  int sign() const { return count_ == 0 ? 0 : signOf(parts_[count_ - 1]); }

 private:
  /// Rounding error of `product` against a * b (Dekker 1971).
  static double productError(double a, double b, double product) {
    const auto high = [](double x) {
      const double shifted = 134217729.0 * x;  // 2^27 + 1
      return shifted - (shifted - x);
    };
    const double ah = high(a);
    const double bh = high(b);
    const double al = a - ah;
    const double bl = b - bh;
    return al * bl - (((product - ah * bh) - al * bh) - ah * bl);
  }

  /// Three products of three differences of two parts each have 192 parts at most.
  std::array<double, 192> parts_;
  std::size_t count_ = 0;
};

/// The minor a0 b1 - a1 b0.
Expansion minor(const Expansion& a0, const Expansion& a1, const Expansion& b0, const Expansion& b1) {
  Expansion result = a0 * b1;
  result.add(a1 * b0, -1.0);
  return result;
}

int exactOrientation3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  std::array<std::array<Expansion, 3>, 3> m;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    m[0][i] = Expansion::difference(a[axis], d[axis]);
    m[1][i] = Expansion::difference(b[axis], d[axis]);
    m[2][i] = Expansion::difference(c[axis], d[axis]);
  }
  Expansion determinant = m[0][2] * minor(m[1][0], m[1][1], m[2][0], m[2][1]);
  determinant.add(m[1][2] * minor(m[2][0], m[2][1], m[0][0], m[0][1]), 1.0);
  determinant.add(m[2][2] * minor(m[0][0], m[0][1], m[1][0], m[1][1]), 1.0);
  return determinant.sign();
}

}  // namespace

int orientation3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Vector3 u = a - d;
  const Vector3 v = b - d;
  const Vector3 w = c - d;
  const double vw0 = v.x() * w.y();
  const double vw1 = w.x() * v.y();
  const double wu0 = w.x() * u.y();
  const double wu1 = u.x() * w.y();
  const double uv0 = u.x() * v.y();
  const double uv1 = v.x() * u.y();
  const double determinant = u.z() * (vw0 - vw1) + v.z() * (wu0 - wu1) + w.z() * (uv0 - uv1);
  const double permanent = (std::abs(vw0) + std::abs(vw1)) * std::abs(u.z()) +
                           (std::abs(wu0) + std::abs(wu1)) * std::abs(v.z()) +
                           (std::abs(uv0) + std::abs(uv1)) * std::abs(w.z());
  constexpr double kBound = (7.0 + 56.0 * kUnit) * kUnit;  // Shewchuk 1997, o3derrboundA
  if (std::abs(determinant) > kBound * permanent) return signOf(determinant);
  return exactOrientation3d(a, b, c, d);
}

int orientation2d(const Vector3& a, const Vector3& b, const Vector3& c, int dropped) {
  const int x = (dropped + 1) % 3;
  const int y = (dropped + 2) % 3;
  const double left = (a[x] - c[x]) * (b[y] - c[y]);
  const double right = (a[y] - c[y]) * (b[x] - c[x]);
  const double determinant = left - right;
  constexpr double kBound = (3.0 + 16.0 * kUnit) * kUnit;  // Shewchuk 1997, ccwerrboundA
  if (std::abs(determinant) > kBound * (std::abs(left) + std::abs(right))) return signOf(determinant);
  return minor(Expansion::difference(a[x], c[x]), Expansion::difference(a[y], c[y]), Expansion::difference(b[x], c[x]),
               Expansion::difference(b[y], c[y]))
      .sign();
}

}  // namespace glissade
