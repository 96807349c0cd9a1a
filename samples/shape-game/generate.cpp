// Writes the shape game of Cailhol et al. 2019 (section 6.2, figure 13): meshes and one scenario for
// each preset and object. The paper gives no dimensions; this layout makes its Table 1 hold and its
// shortest ways lead through the holes that its text names. Unit u = 0.1 m; x goes through the plate,
// the holes are polygons in (y, z).
//
// usage: generate-shape-game FOLDER
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/files/scenario_io.h"

namespace {

using namespace glissade;

constexpr double kUnit = 0.1;
constexpr double kSide = 24.0;  ///< edge of the cubic workspace

struct Point2 {
  double y;
  double z;
};
using Polygon = std::vector<Point2>;  ///< counter-clockwise, seen against x

Polygon regular(int corners, double radius, double firstAngle) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = firstAngle + 2.0 * std::numbers::pi * i / corners;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

Polygon circle(double radius) { return regular(64, radius, 0.0); }
Polygon square(double side) { return regular(4, side / std::sqrt(2.0), std::numbers::pi / 4.0); }
Polygon triangle(double side) { return regular(3, side / std::sqrt(3.0), std::numbers::pi / 2.0); }
Polygon pentagon(double radius) { return regular(5, radius, std::numbers::pi / 2.0); }

Polygon star(double radius) {
  constexpr double kInner = 0.382;
  Polygon polygon = regular(10, radius, std::numbers::pi / 2.0);
  for (std::size_t i = 1; i < polygon.size(); i += 2) {
    polygon[i].y *= kInner;
    polygon[i].z *= kInner;
  }
  return polygon;
}

struct Preset {
  std::string name;
  double holeCircle, holeSquare, holeTriangle, holePentagon;
  double circle, square, triangle, pentagon, star, depth;
};

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{{"paper-like", 0.62, 1.23, 1.62, 0.92, 0.56, 0.85, 1.12, 0.858, 0.735, 0.85},
                                       {"tight", 0.62, 1.23, 1.323, 0.92, 0.59, 0.86, 1.15, 0.895, 0.846, 1.0}};
  return all;
}

std::uint32_t add(TriangleMesh& mesh, double x, const Point2& p) {
  mesh.vertices.emplace_back(x * kUnit, p.y * kUnit, p.z * kUnit);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void addQuad(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// A polygon, star-shaped about the origin, extruded along x: the object with its reference point in the middle.
TriangleMesh prism(const Polygon& polygon, double depth) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double x : {-depth / 2.0, depth / 2.0}) {
    for (const Point2& p : polygon) add(mesh, x, p);
  }
  const std::uint32_t backMiddle = add(mesh, -depth / 2.0, {0.0, 0.0});
  const std::uint32_t frontMiddle = add(mesh, depth / 2.0, {0.0, 0.0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    addQuad(mesh, i, j, n + j, n + i);
    mesh.triangles.push_back({frontMiddle, n + i, n + j});
    mesh.triangles.push_back({backMiddle, j, i});
  }
  return mesh;
}

/// The ring between a hole and the rectangle around it. Every vertex of the hole is joined with the corner in its
/// direction, so that no triangle reaches into the hole.
void addRing(TriangleMesh& mesh, const std::vector<std::uint32_t>& hole, const std::vector<std::uint32_t>& corners,
             const Point2& centre, bool facingFront) {
  const auto angleOf = [&](std::uint32_t vertex) {
    const Vector3 p = mesh.vertices[vertex] / kUnit;
    return std::atan2(p.z() - centre.z, p.y() - centre.y);
  };
  const auto cornerOf = [&](std::uint32_t vertex) {
    const auto away = [&](std::uint32_t corner) { return -std::cos(angleOf(corner) - angleOf(vertex)); };
    const auto nearest = std::min_element(corners.begin(), corners.end(),
                                          [&](std::uint32_t a, std::uint32_t b) { return away(a) < away(b); });
    return static_cast<std::size_t>(std::distance(corners.begin(), nearest));
  };
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (facingFront) {
      mesh.triangles.push_back({a, b, c});
    } else {
      mesh.triangles.push_back({a, c, b});
    }
  };
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const std::uint32_t here = hole[i];
    const std::uint32_t next = hole[(i + 1) % hole.size()];
    const std::size_t last = cornerOf(next);
    std::size_t corner = cornerOf(here);
    for (; corner != last; corner = (corner + 1) % corners.size()) {
      face(here, corners[corner], corners[(corner + 1) % corners.size()]);
    }
    face(here, corners[corner], next);
  }
}

struct Hole {
  std::string place;
  std::string shape;
  Point2 centre;
  Polygon polygon;
};

std::vector<Hole> holesOf(const Preset& preset) {
  return {{"P6", "circle", {13.75, 10.5}, circle(preset.holeCircle)},
          {"P7", "square", {13.75, 13.5}, square(preset.holeSquare)},
          {"P8", "triangle", {10.25, 13.5}, triangle(preset.holeTriangle)},
          {"P9", "pentagon", {10.25, 10.5}, pentagon(preset.holePentagon)}};
}

constexpr double kPlateFront = 7.2;
constexpr double kPlateBack = 7.5;

/// O1: the plate with the holes, each in its own quarter.
TriangleMesh plate(const Preset& preset) {
  TriangleMesh mesh;
  constexpr double kMiddle = kSide / 2.0;
  std::map<int, std::vector<std::uint32_t>> lattice;  // 3 x 3 points a face
  for (const double x : {kPlateFront, kPlateBack}) {
    auto& points = lattice[x == kPlateBack ? 1 : 0];
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) points.push_back(add(mesh, x, {kMiddle * y, kMiddle * z}));
    }
  }
  const auto at = [&](int face, int y, int z) { return lattice[face][3 * static_cast<std::size_t>(y) + z]; };
  for (const Hole& hole : holesOf(preset)) {
    const int y = hole.centre.y > kMiddle ? 1 : 0;
    const int z = hole.centre.z > kMiddle ? 1 : 0;
    std::vector<std::vector<std::uint32_t>> rim(2);
    for (int face = 0; face < 2; ++face) {
      for (const Point2& p : hole.polygon) {
        const double x = face == 1 ? kPlateBack : kPlateFront;
        rim[static_cast<std::size_t>(face)].push_back(add(mesh, x, {hole.centre.y + p.y, hole.centre.z + p.z}));
      }
      const std::vector<std::uint32_t> corners{at(face, y, z), at(face, y + 1, z), at(face, y + 1, z + 1),
                                               at(face, y, z + 1)};
      addRing(mesh, rim[static_cast<std::size_t>(face)], corners, hole.centre, face == 1);
    }
    for (std::size_t i = 0; i < hole.polygon.size(); ++i) {
      const std::size_t j = (i + 1) % hole.polygon.size();
      addQuad(mesh, rim[0][j], rim[0][i], rim[1][i], rim[1][j]);
    }
  }
  for (int i = 0; i < 2; ++i) {
    addQuad(mesh, at(0, i, 0), at(0, i + 1, 0), at(1, i + 1, 0), at(1, i, 0));
    addQuad(mesh, at(0, i + 1, 2), at(0, i, 2), at(1, i, 2), at(1, i + 1, 2));
    addQuad(mesh, at(0, 0, i + 1), at(0, 0, i), at(1, 0, i), at(1, 0, i + 1));
    addQuad(mesh, at(0, 2, i), at(0, 2, i + 1), at(1, 2, i + 1), at(1, 2, i));
  }
  return mesh;
}

std::string toObj(const TriangleMesh& mesh) {
  std::string text;
  for (const Vector3& v : mesh.vertices) {
    text += "v";
    for (int i = 0; i < 3; ++i) text += " " + toText(std::round(v[i] * 1e7) / 1e7);
    text += "\n";
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  }
  return text;
}

BodyDescription box(const std::string& id, Mobility mobility, const Vector3& least, const Vector3& most,
                    const Colour& colour) {
  BodyDescription body;
  body.id = BodyId(id);
  body.name = id;
  body.mobility = mobility;
  body.geometry = BoxGeometry{(most - least) * kUnit};
  body.pose = Pose::translation((least + most) / 2.0 * kUnit);
  body.colour = colour;
  return body;
}

struct Piece {
  std::string shape;
  Point2 start;
  Colour colour;
};

Scenario scenarioOf(const Preset& preset, const Piece& piece) {
  Scenario scenario;
  scenario.name = "Shape game: " + piece.shape + ", " + preset.name;
  scenario.description =
      "The shape game of Cailhol et al. 2019 (figure 13): through a hole of the plate, past the mobile box, round "
      "the second plate.";
  scenario.assets = {{"plate", preset.name + "-plate.obj", "", 1.0, UpAxis::Z},
                     {"object", preset.name + "-" + piece.shape + ".obj", "", 1.0, UpAxis::Z}};
  BodyDescription o1;
  o1.id = "O1";
  o1.name = "O1";
  o1.geometry = MeshGeometry{"plate"};
  o1.colour = Colour{0.62, 0.66, 0.72};
  scenario.bodies = {o1, box("O2", Mobility::Static, {14.4, 2.2, 0.0}, {15.0, 16.0, kSide}, {0.62, 0.66, 0.72}),
                     box("O3", Mobility::Mobile, {10.0, 13.0, 9.0}, {12.0, 17.0, 15.0}, {0.85, 0.65, 0.35})};
  scenario.object.first().id = BodyId(piece.shape);
  scenario.object.first().name = piece.shape;
  scenario.object.first().geometry = MeshGeometry{"object"};
  scenario.object.first().colour = piece.colour;
  scenario.object.first().attributes["shape"] = piece.shape;
  scenario.start = Pose::translation(Vector3(2.4, piece.start.y, piece.start.z) * kUnit);
  scenario.goal = Pose::translation(Vector3(21.6, 8.0, 12.0) * kUnit);
  scenario.workspace = Box3(Vector3::Zero(), Vector3::Constant(kSide * kUnit));
  scenario.planner = "gts";
  const auto place = [&](const std::string& name, const Vector3& at, const std::string& shape) {
    PlaceEdit edit;
    edit.at = at * kUnit;
    edit.name = name;
    if (!shape.empty()) edit.attributes["shape"] = shape;
    scenario.places.push_back(edit);
  };
  place("P1", {3.6, 12.0, 12.0}, "");
  place("P2", {10.95, 8.0, 12.0}, "");
  place("P3", {19.5, 12.0, 12.0}, "");
  place("P4", {14.7, 1.1, 12.0}, "");
  place("P5", {14.7, 20.0, 12.0}, "");
  for (const Hole& hole : holesOf(preset)) place(hole.place, {7.35, hole.centre.y, hole.centre.z}, hole.shape);
  return scenario;
}

bool report(const Outcome& outcome) {
  if (!outcome) std::cerr << toString(outcome.error()) << "\n";
  return outcome.ok();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate-shape-game FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<Piece> pieces{{"circle", {11.0, 20.0}, {0.90, 0.35, 0.30}},
                                  {"square", {4.0, 12.5}, {0.30, 0.60, 0.90}},
                                  {"triangle", {4.0, 4.0}, {0.35, 0.75, 0.40}},
                                  {"pentagon", {10.0, 4.0}, {0.95, 0.75, 0.25}},
                                  {"star", {10.0, 20.0}, {0.70, 0.45, 0.85}}};
  bool good = true;
  for (const Preset& preset : presets()) {
    const std::map<std::string, Polygon> polygons{{"circle", circle(preset.circle)},
                                                  {"square", square(preset.square)},
                                                  {"triangle", triangle(preset.triangle)},
                                                  {"pentagon", pentagon(preset.pentagon)},
                                                  {"star", star(preset.star)}};
    good &= report(writeFileAtomically(folder + "/" + preset.name + "-plate.obj", toObj(plate(preset))));
    for (const Piece& piece : pieces) {
      const std::string name = folder + "/" + preset.name + "-" + piece.shape;
      good &= report(writeFileAtomically(name + ".obj", toObj(prism(polygons.at(piece.shape), preset.depth))));
      good &= report(saveScenario(scenarioOf(preset, piece), name + ".json"));
    }
  }
  return good ? 0 : 1;
}
