#include "tests/oracle/ring_solid.h"

#include <algorithm>

namespace glissade::oracle {
namespace {

Point cornerOf(const Ring& ring, std::size_t i) {
  const Corner& corner = ring.outline[i % ring.outline.size()];
  return {corner[0], corner[1], ring.z};
}

Polygon capOf(const Ring& ring, bool down) {
  Polygon cap{{}, true};
  for (std::size_t i = 0; i < ring.outline.size(); ++i) cap.corners.push_back(cornerOf(ring, i));
  if (down) std::reverse(cap.corners.begin(), cap.corners.end());
  return cap;
}

void addFan(Triangles& triangles, const Polygon& cap) {
  const Point middle{0.0, 0.0, cap.corners.front()[2]};
  for (std::size_t i = 0; i < cap.corners.size(); ++i) {
    triangles.push_back({middle, cap.corners[i], cap.corners[(i + 1) % cap.corners.size()]});
  }
}

}  // namespace

std::vector<Polygon> ringSolid(const std::vector<Ring>& rings) {
  std::vector<Polygon> polygons{capOf(rings.front(), true), capOf(rings.back(), false)};
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    const Ring& a = rings[r];
    const Ring& b = rings[r + 1];
    for (std::size_t i = 0; i < a.outline.size(); ++i) {
      Polygon face;
      for (const Point& corner : {cornerOf(a, i), cornerOf(a, i + 1), cornerOf(b, i + 1), cornerOf(b, i)}) {
        const auto& known = face.corners;
        if (std::find(known.begin(), known.end(), corner) == known.end()) face.corners.push_back(corner);
      }
      if (face.corners.size() > 2) polygons.push_back(std::move(face));
    }
  }
  return polygons;
}

Triangles trianglesOf(const std::vector<Polygon>& polygons) {
  Triangles triangles;
  for (const Polygon& polygon : polygons) {
    if (polygon.cap) {
      addFan(triangles, polygon);
      continue;
    }
    for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
      triangles.push_back({polygon.corners[0], polygon.corners[i], polygon.corners[i + 1]});
    }
  }
  return triangles;
}

Outline polarOutline(int corners, const std::vector<double>& radii) {
  Outline outline = regularPolygon(corners, 1.0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double radius = radii[i % radii.size()];
    outline[i] = {radius * outline[i][0], radius * outline[i][1]};
  }
  return outline;
}

}  // namespace glissade::oracle
