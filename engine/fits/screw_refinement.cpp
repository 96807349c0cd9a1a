#include "engine/fits/screw_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>

namespace glissade {
namespace {

/// Bins of the distances from the axis; a bin counts if it has at least this share of the vertices.
constexpr int kBins = 100;
constexpr double kFullBin = 0.04;
constexpr int kAxisRounds = 20;
/// Limit of the ratio of the pitch to the fitted one, or its inverse: coarse facets determine the pitch poorly.
constexpr double kMostFactor = 3.0;
/// Change of a vertex's phase between two trial pitches, in turns.
constexpr double kTurnsApart = 0.15;
constexpr int kHarmonics = 6;
constexpr int kMostTried = 4000;
constexpr int kNarrowings = 40;

struct Cylindrical {
  double radius;
  double angle;
  double height;
};

class ScrewRefinement {
 public:
  ScrewRefinement(const ScrewAxis& screw, const std::vector<Vector3>& vertices) : screw_(screw), vertices_(vertices) {}

  ScrewAxis refine() {
    for (int round = 0; round < kAxisRounds; ++round) {
      if (!sortByRadius()) return screw_;
      moveAxis();
    }
    if (sortByRadius()) findPitch();
    return screw_;
  }

 private:
  Cylindrical placed(const Vector3& vertex) const {
    const Vector3 p = vertex - screw_.point_W;
    const Eigen::Vector2d flat(p.dot(u_), p.dot(v_));
    return {flat.norm(), std::atan2(flat.y(), flat.x()), p.dot(screw_.axis_W)};
  }

  /// Collects the vertices in full bins; false if there is none.
  bool sortByRadius() {
    u_ = screw_.axis_W.unitOrthogonal();
    v_ = screw_.axis_W.cross(u_);
    std::vector<Cylindrical> all;
    double least = 1e300;
    double most = 0.0;
    for (const Vector3& vertex : vertices_) {
      all.push_back(placed(vertex));
      least = std::min(least, all.back().radius);
      most = std::max(most, all.back().radius);
    }
    std::map<int, std::vector<std::size_t>> bins;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double share = most > least ? (all[i].radius - least) / (most - least) : 0.0;
      // Neighbours at a border fall into one bin.
      bins[static_cast<int>(std::lround(share * kBins))].push_back(i);
    }
    rings_.clear();
    for (const auto& [number, members] : bins) {
      if (static_cast<double>(members.size()) < kFullBin * static_cast<double>(all.size())) continue;
      Ring& ring = rings_.emplace_back();
      for (const std::size_t i : members) {
        ring.points.push_back(all[i]);
        ring.radius += all[i].radius / static_cast<double>(members.size());
      }
    }
    return !rings_.empty();
  }

  /// One least squares' step for the position and direction of the axis.
  void moveAxis() {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Ring& ring : rings_) {
      for (const Cylindrical& p : ring.points) {
        const double c = std::cos(p.angle);
        const double s = std::sin(p.angle);
        const Eigen::Vector4d row(-c, -s, -p.height * c, -p.height * s);
        normal += row * row.transpose();
        right += row * (ring.radius - p.radius);
      }
    }
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    if (!step.allFinite()) return;
    screw_.point_W += step[0] * u_ + step[1] * v_;
    screw_.axis_W = (screw_.axis_W + step[2] * u_ + step[3] * v_).normalized();
  }

  /// Measure of how few helices contain the rings' points: larger for fewer.
  double coherence(double turnsForMetre) const {
    double sum = 0.0;
    for (const Ring& ring : rings_) {
      std::array<std::complex<double>, kHarmonics> means{};
      for (const Cylindrical& p : ring.points) {
        const std::complex<double> phase = std::polar(1.0, 2.0 * std::numbers::pi * p.height * turnsForMetre - p.angle);
        std::complex<double> power = phase;
        for (std::complex<double>& mean : means) {
          mean += power;
          power *= phase;
        }
      }
      for (const std::complex<double>& mean : means) sum += std::norm(mean) / static_cast<double>(ring.points.size());
    }
    return sum;
  }

  void findPitch() {
    double low = 1e300;
    double high = -1e300;
    for (const Ring& ring : rings_) {
      for (const Cylindrical& p : ring.points) {
        low = std::min(low, p.height);
        high = std::max(high, p.height);
      }
    }
    // Trial pitches are even in turns for a metre, so that phases change evenly.
    const double rate = 1.0 / screw_.pitch;
    const double turns = std::max(1.0, (high - low) * std::abs(rate));
    const double range = kMostFactor - 1.0 / kMostFactor;
    const int tried = std::min(kMostTried, static_cast<int>(std::ceil(range * turns * kHarmonics / kTurnsApart)));
    double best = rate;
    double most = coherence(best);
    const auto look = [&](double other) {
      const double found = coherence(other);
      if (found > most) most = found, best = other;
    };
    for (int i = 0; i <= tried; ++i) look(rate * (1.0 / kMostFactor + range * i / tried));
    double step = range / tried * std::abs(rate);
    for (int i = 0; i < kNarrowings; ++i, step *= 0.6) {
      const double middle = best;
      look(middle - step);
      look(middle + step);
    }
    screw_.pitch = 1.0 / best;
  }

  struct Ring {
    double radius = 0.0;
    std::vector<Cylindrical> points;
  };

  ScrewAxis screw_;
  const std::vector<Vector3>& vertices_;
  Vector3 u_ = Vector3::UnitX();
  Vector3 v_ = Vector3::UnitY();
  std::vector<Ring> rings_;
};

}  // namespace

ScrewAxis refinedScrew(const ScrewAxis& screw, const std::vector<Vector3>& vertices) {
  return vertices.empty() ? screw : ScrewRefinement(screw, vertices).refine();
}

}  // namespace glissade
