#include "engine/access/tool_holds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

constexpr int kTurns = 12;            ///< of a hand about a handle
constexpr std::size_t kBentBack = 1;  ///< of wristBends(): the forearm is in line with what is pinched
constexpr double kPadLength = 0.012;  ///< metres of an arm's end that are between the pads

Pose turnedAbout(const Vector3& axis, double angle) {
  return {Vector3::Zero(), Quaternion(Eigen::AngleAxisd(angle, axis))};
}

double turnOf(int i, int of) { return 2.0 * std::numbers::pi * i / of; }

/// Holds of one tool, as poses of the grip in the tool's frame.
class ToolHolds {
 public:
  ToolHolds(ToolKind kind, const FastenerHead& head, HandShapes& shapes)
      : shapes_(shapes),
        handle_(handleOf(kind, head)),
        mesh_(std::make_shared<const TriangleMesh>(toolAtRest(kind, head))) {}

  /// The handle is along the axis: its end is in the palm.
  void addBehind(const Pose& X_WT) {
    for (const double tilt : kPinchTilts) {
      const auto& shape = shapes_.pinch({handle_.thickness + kPadGap, 4, tilt});
      if (!shape) continue;
      const double length = (handle_.to - handle_.from).norm();
      const double z = handle_.to.z() - std::min(shape->room, 0.8 * length);
      for (int i = 0; i < kTurns; ++i) {
        const Pose X_TG =
            Pose::translation({0.0, 0.0, z}) * turnedAbout(Vector3::UnitZ(), turnOf(i, kTurns)) * facingIn();
        add(*shape, X_WT, X_TG, kBentBack);
      }
    }
  }

  /// The handle is an arm along x: a fist about its end.
  void addFists(const Pose& X_WT) {
    const HandShapes::Shape& shape = shapes_.fist(handle_.thickness);
    const Vector3 at = handle_.to - 0.45 * shapes_.measures().handBreadth * Vector3::UnitX();
    for (const double end : {1.0, -1.0}) {
      for (int i = 0; i < kTurns; ++i) {
        add(shape, X_WT, Pose::translation(at) * turnedAbout(Vector3::UnitX(), turnOf(i, kTurns)) * barAlongX(end), 0);
      }
    }
  }

  /// The same arm between thumb and fingers, from its end or from a side.
  void addPinches(const Pose& X_WT) {
    const Vector3 at = handle_.to - kPadLength * Vector3::UnitX();
    for (const double tilt : kPinchTilts) {
      const auto& shape = shapes_.pinch({handle_.thickness + kPadGap, 2, tilt});
      if (!shape) continue;
      for (int i = 0; i < 4; ++i) {
        const Pose about = Pose::translation(at) * turnedAbout(Vector3::UnitX(), turnOf(i, 4));
        add(*shape, X_WT, about * turnedAbout(Vector3::UnitY(), -0.5 * std::numbers::pi), 0);  // from the end
        const Pose back = Pose::translation({0.0, 0.0, -kPadBack * shapes_.measures().handBreadth});
        for (const Pose& depth : {Pose::identity(), back}) {  // from a side
          add(*shape, X_WT, about * barAlongX(1.0) * depth, 0);
        }
      }
    }
  }

  bool isLongForFist() const { return (handle_.to - handle_.from).norm() >= 1.3 * shapes_.measures().handBreadth; }
  std::vector<HandHold> take() { return std::move(holds_); }

 private:
  void add(const HandShapes::Shape& shape, const Pose& X_WT, const Pose& X_TG, std::size_t bend) {
    holds_.push_back({shape.mesh, X_WT * X_TG * inverse(shape.X_HG), mesh_, X_WT, bend});
  }
  /// The grip's y, along which a bar lies in a fist, is the tool's x or against it.
  static Pose barAlongX(double end) { return turnedAbout(Vector3::UnitZ(), -end * 0.5 * std::numbers::pi); }
  /// The grip looks along -z, to the head.
  static Pose facingIn() { return turnedAbout(Vector3::UnitX(), std::numbers::pi); }

  HandShapes& shapes_;
  ToolHandle handle_;
  MeshPtr mesh_;
  std::vector<HandHold> holds_;
};

}  // namespace

std::vector<HandHold> toolHolds(ToolKind kind, const FastenerHead& head, const Pose& X_WT, HandShapes& shapes) {
  ToolHolds holds(kind, head, shapes);
  const int positions = handlePositions(kind);
  for (int i = 0; i < positions; ++i) {
    const Pose turned = X_WT * turnedAbout(Vector3::UnitZ(), turnOf(i, positions));
    if (kind == ToolKind::Screwdriver) {
      holds.addBehind(turned);
    } else if (holds.isLongForFist()) {
      holds.addFists(turned);
    }
  }
  for (int i = 0; kind != ToolKind::Screwdriver && i < positions; ++i) {
    holds.addPinches(X_WT * turnedAbout(Vector3::UnitZ(), turnOf(i, positions)));
  }
  return holds.take();
}

}  // namespace glissade
