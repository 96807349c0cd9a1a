#include "engine/fits/screw_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

constexpr int kRounds = 20;
/// Sines within which patches count fully: in the first round, the factor for each round, and in the last round.
constexpr double kFirstSine = 0.3;
constexpr double kSineShare = 0.8;
constexpr double kLastSine = 0.04;
constexpr double kAlongItself = 0.1;
constexpr double kLeastMovedShare = 0.5;
/// Mean square of the normals' axial components below which the patches could be moved straight along the axis.
constexpr double kLeastSlope = 1e-3;
/// Limits of the pitch, in largest radii of the thread.
constexpr double kLeastPitch = 0.01;
constexpr double kMostPitch = 4.0;
constexpr std::size_t kSectors = 12;
constexpr std::size_t kLeastSectors = 11;

/// Velocity c_bar + c x p.
struct Twist {
  Vector3 turn;
  Vector3 velocity;

  double sineAt(const Vector3& p, const Vector3& normal) const {
    const Vector3 v = velocity + turn.cross(p);
    const double speed = v.norm();
    return speed > 0.0 ? std::abs(v.dot(normal)) / speed : 1.0;
  }
};

/// The twist with a unit turn that moves the patches best along themselves.
Twist bestTwist(const std::vector<SurfacePatch>& patches, const std::vector<double>& weights) {
  Eigen::Matrix3d turns = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d velocities = Eigen::Matrix3d::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Vector3 moment = patches[i].point.cross(patches[i].normal);
    turns += weights[i] * moment * moment.transpose();
    mixed += weights[i] * moment * patches[i].normal.transpose();
    velocities += weights[i] * patches[i].normal * patches[i].normal.transpose();
    sum += weights[i];
  }
  velocities += 1e-9 * sum * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inverse = velocities.inverse();
  const Eigen::Matrix3d reduced = turns - mixed * inverse * mixed.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (reduced + reduced.transpose()));
  const Vector3 turn = solver.eigenvectors().col(0);
  return {turn, -inverse * mixed.transpose() * turn};
}

/// The patches about their middle, in units of their mean distance from it.
struct Scaled {
  Vector3 middle = Vector3::Zero();
  double length = 0.0;
  std::vector<SurfacePatch> patches;

  explicit Scaled(const std::vector<SurfacePatch>& given) : patches(given) {
    double area = 0.0;
    for (const SurfacePatch& patch : given) middle += patch.area * patch.point, area += patch.area;
    middle /= area;
    for (const SurfacePatch& patch : given) length += patch.area / area * (patch.point - middle).norm();
    for (SurfacePatch& patch : patches) patch.point = (patch.point - middle) / length;
  }
};

}  // namespace

bool isMovedAlongItself(const ScrewAxis& screw, const SurfacePatch& patch) {
  const Twist twist{screw.axis_W, screw.pitch / (2.0 * std::numbers::pi) * screw.axis_W};
  return twist.sineAt(patch.point - screw.point_W, patch.normal) < kAlongItself;
}

std::optional<FittedScrew> fitScrew(const std::vector<SurfacePatch>& patches) {
  constexpr std::size_t kFewest = 24;
  if (patches.size() < kFewest) return std::nullopt;
  const Scaled scaled(patches);
  if (!(scaled.length > 0.0)) return std::nullopt;
  std::vector<double> weights;
  for (const SurfacePatch& patch : patches) weights.push_back(patch.area);
  Twist twist{};
  double sine = kFirstSine;
  for (int round = 0; round < kRounds; ++round, sine = std::max(kLastSine, kSineShare * sine)) {
    twist = bestTwist(scaled.patches, weights);
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const double off = twist.sineAt(scaled.patches[i].point, scaled.patches[i].normal) / sine;
      weights[i] = patches[i].area / ((1.0 + off * off) * (1.0 + off * off));
    }
  }
  FittedScrew fitted;
  fitted.screw = {scaled.middle + scaled.length * twist.turn.cross(twist.velocity), twist.turn,
                  2.0 * std::numbers::pi * scaled.length * twist.turn.dot(twist.velocity)};
  fitted.nearest = std::numeric_limits<double>::infinity();
  const Vector3 u = twist.turn.unitOrthogonal();
  const Vector3 v = twist.turn.cross(u);
  double area = 0.0;
  double moved = 0.0;
  double slope = 0.0;
  std::bitset<kSectors> sectors;
  for (const SurfacePatch& patch : patches) {
    area += patch.area;
    if (!isMovedAlongItself(fitted.screw, patch)) continue;
    moved += patch.area;
    slope += patch.area * std::pow(patch.normal.dot(twist.turn), 2);
    const Vector3 p = patch.point - fitted.screw.point_W;
    const double radius = p.cross(twist.turn).norm();
    fitted.nearest = std::min(fitted.nearest, radius);
    fitted.farthest = std::max(fitted.farthest, radius);
    const double angle = std::atan2(p.dot(v), p.dot(u)) / (2.0 * std::numbers::pi) + 0.5;
    sectors.set(std::min(kSectors - 1, static_cast<std::size_t>(angle * kSectors)));
  }
  const double pitch = std::abs(fitted.screw.pitch);
  const bool isThread = moved >= kLeastMovedShare * area && slope >= kLeastSlope * moved &&
                        sectors.count() >= kLeastSectors && pitch >= kLeastPitch * fitted.farthest &&
                        pitch <= kMostPitch * fitted.farthest;
  return isThread ? std::optional(fitted) : std::nullopt;
}

}  // namespace glissade
