#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace glissade {

// Estimates the largest absolute value of a function from its values at nodes: the largest absolute value at a node
// plus a quarter of the largest second difference of three neighbours in a line. A function that is quadratic between
// the nodes exceeds the nodes by at most an eighth of that difference on a line and a sixth on a triangle. The rest is
// a reserve for functions that are not quadratic.

/// Values at the nodes of a line that is divided into `Parts` equal lengths.
template <int Parts>
class LineSamples {
 public:
  double& at(int i) { return values_[static_cast<std::size_t>(i)]; }

  /// Estimate of the largest absolute value on the whole line.
  double largest() const {
    double most = 0.0;
    double bend = 0.0;
    for (std::size_t i = 0; i <= Parts; ++i) {
      most = std::max(most, std::abs(values_[i]));
      if (i > 0 && i < Parts) bend = std::max(bend, std::abs(values_[i - 1] - 2.0 * values_[i] + values_[i + 1]));
    }
    return most + 0.25 * bend;
  }

 private:
  std::array<double, Parts + 1> values_{};
};

/// Values at the nodes of a triangle whose sides are divided into `Parts` equal lengths.
template <int Parts>
class TriangleSamples {
 public:
  /// Value at node (i, j): i / Parts of the first corner, j / Parts of the second, the rest of the third.
  double& at(int i, int j) { return values_[numberOf(i, j)]; }

  /// Estimate of the largest absolute value on the whole triangle.
  double largest() const {
    double most = 0.0;
    double bend = 0.0;
    for (int i = 0; i <= Parts; ++i) {
      for (int j = 0; i + j <= Parts; ++j) {
        most = std::max(most, std::abs(value(i, j)));
        bend = std::max({bend, bendAt(i, j, 1, 0), bendAt(i, j, 0, 1), bendAt(i, j, 1, -1)});
      }
    }
    return most + 0.25 * bend;
  }

 private:
  static constexpr std::size_t kNodes = static_cast<std::size_t>(Parts) + 1;  ///< number of nodes along a side

  static std::size_t numberOf(int i, int j) {
    return static_cast<std::size_t>(i) * kNodes + static_cast<std::size_t>(j);
  }
  double value(int i, int j) const { return values_[numberOf(i, j)]; }
  static bool isNode(int i, int j) { return i >= 0 && j >= 0 && i + j <= Parts; }

  /// Second difference along (di, dj); 0 where the node has no neighbour on one side.
  double bendAt(int i, int j, int di, int dj) const {
    if (!isNode(i - di, j - dj) || !isNode(i + di, j + dj)) return 0.0;
    return std::abs(value(i - di, j - dj) - 2.0 * value(i, j) + value(i + di, j + dj));
  }

  std::array<double, kNodes * kNodes> values_{};
};

}  // namespace glissade
