#include "engine/sequence/tool_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/least_rotation.h"
#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kSwing = kFullTurn / 6.0;
/// Ratio of the inner radius of a tool about a head to the radius of the head.
constexpr double kAbout = 1.02;
constexpr double kLeastHandle = 0.006;

/// Volume between two radii and two heights.
struct Ring {
  double inner;
  double outer;
  double low;
  double high;
};

/// The ring over an angle, from x towards y; closed.
TriangleMesh sector(const Ring& ring, double angle) {
  const bool whole = angle >= kFullTurn;
  const auto segments = static_cast<std::uint32_t>(std::ceil(24.0 * angle / kFullTurn));
  TriangleMesh mesh;
  const std::uint32_t columns = whole ? segments : segments + 1;
  for (std::uint32_t i = 0; i < columns; ++i) {
    const double at = angle * i / segments;
    const Vector3 way(std::cos(at), std::sin(at), 0.0);
    for (const auto& [radius, height] : {std::pair{ring.inner, ring.low}, std::pair{ring.outer, ring.low},
                                         std::pair{ring.outer, ring.high}, std::pair{ring.inner, ring.high}}) {
      mesh.vertices.emplace_back(radius * way + height * Vector3::UnitZ());
    }
  }
  const auto quad = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t one = 4 * i;
    const std::uint32_t next = 4 * ((i + 1) % columns);
    for (std::uint32_t k = 0; k < 4; ++k) quad(one + k, next + k, next + (k + 1) % 4, one + (k + 1) % 4);
  }
  if (whole) return mesh;
  quad(0, 1, 2, 3);
  const std::uint32_t last = 4 * segments;
  quad(last + 3, last + 2, last + 1, last);
  return mesh;
}

/// A cylinder about z, from `low` to `high`.
TriangleMesh bar(double radius, double low, double high) {
  return transformed(makeCylinder(radius, high - low, 24), Pose::translation({0.0, 0.0, 0.5 * (low + high)}));
}

TriangleMesh both(TriangleMesh one, const TriangleMesh& other) {
  append(one, other);
  return one;
}

double keyRadius(const FastenerHead& head) { return std::min(0.55 * head.radius, 0.85 * head.shaft); }

TriangleMesh hexKey(const FastenerHead& head) {
  const double R = head.radius;
  const double leg = keyRadius(head);
  return both(bar(leg, 0.02 * R, 6.0 * R), sector({0.5 * leg, 14.0 * R, 6.0 * R - 2.0 * leg, 6.0 * R}, kSwing));
}

TriangleMesh shankOfSocket(const FastenerHead& head) {
  const double R = head.radius;
  TriangleMesh mesh = sector({kAbout * R, 1.22 * R, -0.9 * head.height, 4.0 * R}, kFullTurn);
  append(mesh, bar(1.22 * R, 4.0 * R, 5.0 * R));
  append(mesh, bar(0.6 * R, 5.0 * R, 11.0 * R));
  return mesh;
}

TriangleMesh socket(const FastenerHead& head) {
  const double R = head.radius;
  return both(shankOfSocket(head), sector({0.3 * R, 14.0 * R, 10.0 * R, 11.0 * R}, kSwing));
}

double handleRadius(const FastenerHead& head) { return std::max(1.5 * head.radius, kLeastHandle); }

TriangleMesh screwdriver(const FastenerHead& head) {
  const double R = head.radius;
  return both(bar(0.5 * R, 0.02 * R, 10.0 * R), bar(handleRadius(head), 10.0 * R, 25.0 * R));
}

TriangleMesh openWrench(const FastenerHead& head) {
  const double R = head.radius;
  const double low = -0.9 * head.height;
  const double high = -0.1 * head.height;
  return both(sector({kAbout * R, 1.6 * R, low, high}, kFullTurn), sector({1.5 * R, 12.0 * R, low, high}, kSwing));
}

/// The jaw of an open wrench: it opens away from the arm, and is as wide as the head.
TriangleMesh openJaw(const FastenerHead& head) {
  const double R = head.radius;
  const double low = -0.9 * head.height;
  const double high = -0.1 * head.height;
  Pose back = Pose::identity();
  back.orientation = Quaternion(Eigen::AngleAxisd(-0.25 * kFullTurn, Vector3::UnitZ()));
  TriangleMesh mesh = transformed(sector({kAbout * R, 1.6 * R, low, high}, 0.5 * kFullTurn), back);
  const TriangleMesh prong = makeBox({0.6 * R, (1.6 - kAbout) * R, high - low});
  for (const double side : {-1.0, 1.0}) {
    const Vector3 middle(-0.3 * R, side * 0.5 * (kAbout + 1.6) * R, 0.5 * (low + high));
    append(mesh, transformed(prong, Pose::translation(middle)));
  }
  return mesh;
}

/// The open wrench at the beginning of its swing.
TriangleMesh wrenchAtRest(const FastenerHead& head) {
  const double R = head.radius;
  return both(openJaw(head), sector({1.5 * R, 12.0 * R, -0.9 * head.height, -0.1 * head.height}, kSwing / 5.0));
}

/// The mesh of a handle across the axis.
TriangleMesh armShape(const ToolHandle& handle) {
  const TriangleMesh arm = makeBox({(handle.to - handle.from).norm(), handle.thickness, handle.thickness});
  return transformed(arm, Pose::translation(0.5 * (handle.from + handle.to)));
}

}  // namespace

TriangleMesh toolShape(ToolKind kind, const FastenerHead& head) {
  switch (kind) {
    case ToolKind::HexKey: return hexKey(head);
    case ToolKind::Socket: return socket(head);
    case ToolKind::Screwdriver: return screwdriver(head);
    case ToolKind::OpenWrench: return openWrench(head);
    case ToolKind::CirclipPliers:
    case ToolKind::None: break;
  }
  return {};
}

std::optional<TriangleMesh> enteringToolShape(ToolKind kind, const FastenerHead& head) {
  if (kind != ToolKind::OpenWrench) return std::nullopt;
  return wrenchAtRest(head);
}

ToolHandle handleOf(ToolKind kind, const FastenerHead& head) {
  const double R = head.radius;
  const double leg = keyRadius(head);
  const double middle = -0.5 * head.height;
  switch (kind) {
    case ToolKind::HexKey: return {{0.0, 0.0, 6.0 * R - leg}, {14.0 * R, 0.0, 6.0 * R - leg}, 2.0 * leg};
    case ToolKind::Socket: return {{0.0, 0.0, 10.5 * R}, {14.0 * R, 0.0, 10.5 * R}, R};
    case ToolKind::Screwdriver: return {{0.0, 0.0, 10.0 * R}, {0.0, 0.0, 25.0 * R}, 2.0 * handleRadius(head)};
    case ToolKind::OpenWrench: return {{1.5 * R, 0.0, middle}, {12.0 * R, 0.0, middle}, 0.8 * head.height};
    case ToolKind::CirclipPliers:
    case ToolKind::None: break;
  }
  return {Vector3::Zero(), Vector3::Zero(), 0.0};
}

TriangleMesh toolAtRest(ToolKind kind, const FastenerHead& head) {
  const double R = head.radius;
  const ToolHandle handle = handleOf(kind, head);
  switch (kind) {
    case ToolKind::HexKey: return both(bar(keyRadius(head), 0.02 * R, 6.0 * R), armShape(handle));
    case ToolKind::Socket: return both(shankOfSocket(head), armShape(handle));
    case ToolKind::Screwdriver: return screwdriver(head);
    case ToolKind::OpenWrench: return both(openJaw(head), armShape(handle));
    case ToolKind::CirclipPliers:
    case ToolKind::None: break;
  }
  return {};
}

Pose toolFrame(const FastenerHead& head, const Pose& X_WB, const Vector3& exit, double turn) {
  Vector3 end = X_WB * head.end;
  Vector3 outwards = X_WB.orientation * head.outwards;
  if (head.bothEnds && outwards.dot(exit) < 0.0) {
    end -= head.height * outwards;
    outwards = -outwards;
  }
  Pose X_WT = Pose::translation(end);
  X_WT.orientation = leastRotation(Vector3::UnitZ(), outwards) * Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitZ()));
  return X_WT;
}

std::vector<Vector3> takeOffWays(ToolKind kind, const FastenerHead& head) {
  const double R = head.radius;
  switch (kind) {
    case ToolKind::OpenWrench: return {{2.0 * R, 0.0, 0.0}, {0.0, 0.0, head.height}};
    case ToolKind::Socket: return {{0.0, 0.0, head.height + R}};
    case ToolKind::HexKey:
    case ToolKind::Screwdriver: return {{0.0, 0.0, R}};
    case ToolKind::CirclipPliers:
    case ToolKind::None: break;
  }
  return {};
}

int handlePositions(ToolKind kind) { return kind == ToolKind::Screwdriver ? 1 : 12; }

}  // namespace glissade
