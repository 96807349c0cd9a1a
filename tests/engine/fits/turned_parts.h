#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/fits/assembled_product.h"

namespace glissade::test {

/// Distance of a surface from the z axis, as a function of the direction in radians.
using Contour = std::function<double(double)>;

/// A contour at a height.
struct Station {
  double height;
  Contour contour;
};

inline constexpr double kHalfTurn = 3.14159265358979323846;

inline Contour circle(double radius) {
  return [radius](double) { return radius; };
}

/// A regular prism with this number of sides; `across`: width across its flats.
inline Contour prism(double across, int sides) {
  return [across, sides](double angle) {
    const double side = 2.0 * kHalfTurn / sides;
    return 0.5 * across / std::cos(angle - side * (std::floor(angle / side + 1e-9) + 0.5));
  };
}

inline double inBox(double angle, double length, double width) {
  return std::min(0.5 * length / std::max(1e-12, std::abs(std::cos(angle))),
                  0.5 * width / std::max(1e-12, std::abs(std::sin(angle))));
}
inline Contour slot(double length, double width) {
  return [=](double angle) { return inBox(angle, length, width); };
}
inline Contour cross(double length, double width) {
  return [=](double angle) { return std::max(inBox(angle, length, width), inBox(angle, width, length)); };
}
inline Contour sixLobes(double outer) {
  return [=](double angle) { return 0.43 * outer + 0.07 * outer * std::cos(6.0 * angle); };
}

/// The surface from contour to contour: up outside and down inside. `isTube`: also from the last contour to the first.
inline TriangleMesh turnedMesh(const std::vector<Station>& stations, bool isTube, int directions = 72) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(directions);
  for (const Station& station : stations) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const double angle = 2.0 * kHalfTurn * i / directions;
      const double radius = station.contour(angle);
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), station.height);
    }
  }
  const auto levels = static_cast<std::uint32_t>(stations.size());
  for (std::uint32_t level = 0; level + (isTube ? 0 : 1) < levels; ++level) {
    const std::uint32_t low = level * count;
    const std::uint32_t high = (level + 1) % levels * count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t k = (i + 1) % count;
      mesh.triangles.push_back({low + i, low + k, high + i});
      mesh.triangles.push_back({high + i, low + k, high + k});
    }
  }
  return welded(mesh);
}

/// A screw along +z with its head's lower side at 0. The depth of the recess is half of the head's height.
inline TriangleMesh screwMesh(double diameter, double length, const Contour& head, double headHeight,
                              const Contour& recess) {
  std::vector<Station> stations{{-length, circle(0.0)},
                                {-length, circle(0.5 * diameter)},
                                {0.0, circle(0.5 * diameter)},
                                {0.0, head},
                                {headHeight, head}};
  if (recess) {
    stations.push_back({headHeight, recess});
    stations.push_back({0.5 * headHeight, recess});
    stations.push_back({0.5 * headHeight, circle(0.0)});
  } else {
    stations.push_back({headHeight, circle(0.0)});
  }
  return turnedMesh(stations, false);
}

/// A screw of ISO 4762.
inline TriangleMesh capScrew(double diameter, double length) {
  return screwMesh(diameter, length, circle(0.8 * diameter), diameter, prism(0.8 * diameter, 6));
}

inline TriangleMesh tubeMesh(const Contour& inner, const Contour& outer, double low, double high) {
  return turnedMesh({{low, inner}, {low, outer}, {high, outer}, {high, inner}}, true);
}

/// A square plate with a hole through it.
inline TriangleMesh plateMesh(double hole, double width, double low, double high) {
  return tubeMesh(circle(hole), prism(width, 4), low, high);
}

/// A square block with a hole of this depth from above.
inline TriangleMesh blockMesh(double hole, double depth, double width, double low, double high) {
  return turnedMesh({{low, circle(0.0)},
                     {low, prism(width, 4)},
                     {high, prism(width, 4)},
                     {high, circle(hole)},
                     {high - depth, circle(hole)},
                     {high - depth, circle(0.0)}},
                    false);
}

inline TriangleMesh rodMesh(double radius, double low, double high) {
  return turnedMesh({{low, circle(0.0)}, {low, circle(radius)}, {high, circle(radius)}, {high, circle(0.0)}}, false);
}

inline TriangleMesh ballMesh(double radius) {
  std::vector<Station> stations;
  constexpr int kLevels = 12;
  for (int i = 0; i <= kLevels; ++i) {
    const double angle = kHalfTurn * i / kLevels;
    stations.push_back({-radius * std::cos(angle), circle(i % kLevels == 0 ? 0.0 : radius * std::sin(angle))});
  }
  return turnedMesh(stations, false, 24);
}

/// Bodies in a common frame, at any pose.
class ProductOfParts {
 public:
  explicit ProductOfParts(const Pose& X_WF = {}) : X_WF_(X_WF) {}

  ProductOfParts& add(const std::string& id, TriangleMesh mesh, const Pose& X_FB = {}) {
    RigidBody body;
    body.id = BodyId(id);
    body.name = id;
    body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    body.X_WB = X_WF_ * X_FB;
    product_.bodies.push_back(std::move(body));
    product_.deflections.push_back(0.0);
    return *this;
  }

  AssembledProduct product() const {
    AssembledProduct product = product_;
    std::vector<ProductBody> bodies;
    for (const RigidBody& body : product.bodies) bodies.push_back({body.id, {body.name}});
    product.tree = Product(bodies);
    return product;
  }
  Vector3 direction(const Vector3& direction_F) const { return X_WF_.orientation * direction_F; }

 private:
  Pose X_WF_;
  AssembledProduct product_;
};

}  // namespace glissade::test
