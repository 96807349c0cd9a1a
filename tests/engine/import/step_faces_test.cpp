#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/geometry/surface_deviation.h"
#include "engine/import/step_deflection.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/step_instances.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using Kind = SurfaceFace::Kind;
using test::stepFile;

constexpr double kRounding = 1e-13;

StepProduct read(const std::string& file, double deflection = 0.0) {
  auto product = importStep(file, deflection);
  EXPECT_TRUE(product) << toString(product.error());
  return product ? std::move(*product) : StepProduct();
}

/// The surfaces of faces.step, metres; independent of the file's text.
SurfaceFace expectedIn(std::size_t part) {
  const Vector3 point(0.005, -0.003, 0.007);
  const Vector3 axis = Vector3(1, 2, 3).normalized();
  switch (part) {
    case 0: return {Kind::Cylinder, point, axis, 0.010};
    case 1: return {Kind::Cone, point, -axis, 0.012, std::atan(8.0 / 30.0)};
    case 2: return {Kind::Sphere, point, axis, 0.015};
    default: return {Kind::Torus, point, axis, 0.020, 0.006};
  }
}

void expectSame(const SurfaceFace& face, const SurfaceFace& expected) {
  EXPECT_NEAR(face.radius, expected.radius, 1e-12);
  EXPECT_NEAR(face.second, expected.second, 1e-12);
  EXPECT_NEAR((face.point - expected.point).cross(expected.axis).norm(), 0.0, 1e-12) << "on the axis";
  if (face.kind == Kind::Sphere) return;
  EXPECT_TRUE(face.axis.isApprox(expected.axis, 1e-12) || face.axis.isApprox(-expected.axis, 1e-12));
  if (face.kind == Kind::Cone) {
    EXPECT_TRUE(face.axis.isApprox(expected.axis, 1e-12)) << "the cone opens along its axis";
  }
}

/// The largest value at many points of a triangle.
template <class Function>
double largestOf(const TriangleMesh& mesh, std::size_t triangle, const Function& of) {
  constexpr int kParts = 12;
  const auto& [a, b, c] = mesh.triangles[triangle];
  double largest = 0.0;
  for (int i = 0; i <= kParts; ++i) {
    for (int j = 0; i + j <= kParts; ++j) {
      largest = std::max(
          largest, of((i * mesh.vertices[a] + j * mesh.vertices[b] + (kParts - i - j) * mesh.vertices[c]) / kParts));
    }
  }
  return largest;
}

/// The largest distance of the triangles of each face; `distance` gives that of a point.
template <class Function>
std::vector<double> measured(const TriangleMesh& mesh, const Function& distance) {
  std::vector<double> largest(mesh.faces.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t face = mesh.faceOf[t];
    largest[face] =
        std::max(largest[face], largestOf(mesh, t, [&](const Vector3& p) { return distance(mesh.faces[face], p); }));
  }
  return largest;
}

double distanceFrom(const SurfaceFace& face, const Vector3& p) { return std::abs(signedDistance(face, p)); }

TEST(StepFaces, AreWhatTheFileStatesAndTheirDeflectionIsThatOfTheirTriangles) {
  for (const double asked : {0.0, 1e-3, 1e-4}) {
    const auto parts = read(stepFile("faces.step"), asked).parts;
    ASSERT_EQ(parts.size(), 5U);
    for (std::size_t i = 0; i < 4; ++i) {
      const TriangleMesh& mesh = *parts[i].mesh;
      SCOPED_TRACE(testing::Message() << "part " << i << ", asked for " << asked);
      ASSERT_EQ(mesh.faceOf.size(), mesh.triangles.size());
      const std::vector<double> largest = measured(mesh, distanceFrom);
      double most = 0.0;
      for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const SurfaceFace& face = mesh.faces[f];
        most = std::max(most, face.deflection);
        EXPECT_GE(face.deflection, largest[f] - kRounding);
        EXPECT_LE(face.deflection, 1.06 * largest[f] + 1e-12);
        if (face.kind != Kind::Plane) expectSame(face, expectedIn(i));
      }
      EXPECT_EQ(parts[i].deflection, most);
      EXPECT_EQ(std::count_if(mesh.faces.begin(), mesh.faces.end(),
                              [&](const SurfaceFace& face) { return face.kind == expectedIn(i).kind; }),
                1);
    }
  }
}

/// Distance to first order, which is sufficient because the triangles are near.
double distanceFromEllipsoid(const Vector3& p) {
  const Vector3 axes(0.030, 0.020, 0.010);
  const Vector3 q = (p - Vector3(0.001, 0.002, 0.003)).cwiseQuotient(axes);
  const Vector3 gradient = q.cwiseQuotient(axes) / q.norm();
  return std::abs(q.norm() - 1.0) / gradient.norm();
}

TEST(StepFaces, OfAFreeSurfaceAreMeasuredOnSamplesThatMissLittle) {
  for (const double asked : {0.0, 2e-4, 1e-4}) {
    const auto parts = read(stepFile("faces.step"), asked).parts;
    ASSERT_EQ(parts.size(), 5U);
    const TriangleMesh& mesh = *parts[4].mesh;
    const std::vector<double> largest =
        measured(mesh, [](const SurfaceFace&, const Vector3& p) { return distanceFromEllipsoid(p); });
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      SCOPED_TRACE(testing::Message() << "face " << f << ", asked for " << asked);
      EXPECT_EQ(mesh.faces[f].kind, Kind::Free);
      EXPECT_GE(mesh.faces[f].deflection, largest[f]);
      EXPECT_LE(mesh.faces[f].deflection, 1.5 * largest[f]);
    }
  }
}

/// The distance from the nearer side of the tube was 13 mm.
TEST(StepFaces, ATorusThatMeetsItselfIsMeasuredOnItsOwnSide) {
  const TriangleMesh mesh = *read(stepFile("barrel.step")).parts.at(0).mesh;
  const std::vector<double> largest = measured(mesh, [](const SurfaceFace& face, const Vector3& p) {
    if (face.kind == Kind::Plane) return distanceFrom(face, p);
    return std::abs(std::hypot(p.head<2>().norm() + 0.0345, p.z()) - 0.041);
  });
  ASSERT_EQ(mesh.faces.size(), 3U);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    EXPECT_GE(mesh.faces[f].deflection, largest[f] - kRounding);
    EXPECT_LE(mesh.faces[f].deflection, 1.5 * largest[f] + 1e-12);
  }
}

TEST(StepFaces, PlanesHaveNoDeflectionAndLookOutwards) {
  const TriangleMesh mesh = *read(stepFile("plate.step")).parts.at(0).mesh;
  EXPECT_EQ(mesh.faces.size(), 7U);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SurfaceFace& face = mesh.faces[mesh.faceOf[t]];
    if (face.kind != Kind::Plane) continue;
    EXPECT_LT(mesh.deflectionOf(t), 1e-15);
    EXPECT_TRUE(faceNormal(mesh, mesh.triangles[t]).isApprox(face.axis, 1e-9));
  }
}

/// The chords of the bore have a known sagitta.
TEST(StepFaces, ABoreIsAsFarOffAsTheSagittaOfItsChords) {
  const TriangleMesh mesh = *read(stepFile("plate.step"), 1e-3).parts.at(0).mesh;
  const auto bore = std::find_if(mesh.faces.begin(), mesh.faces.end(),
                                 [](const SurfaceFace& face) { return face.kind == Kind::Cylinder; });
  ASSERT_NE(bore, mesh.faces.end());
  const auto index = static_cast<std::uint32_t>(bore - mesh.faces.begin());
  double longest = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.faceOf[t] != index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 side = mesh.vertices[mesh.triangles[t][(i + 1) % 3]] - mesh.vertices[mesh.triangles[t][i]];
      longest = std::max(longest, std::hypot(side.x(), side.y()));
    }
  }
  EXPECT_NEAR(bore->deflection, 0.0085 - std::sqrt(0.0085 * 0.0085 - 0.25 * longest * longest), 1e-9);
}

TEST(StepFaces, OfAMirroredAndScaledInstanceAreMirroredAndScaled) {
  const test::TemporaryFolder folder;
  test::SecondPart second;
  second.y = "0.,-1.,0.";
  second.scale = "2.";
  const std::string text = test::partTwice(second, "cone.step");
  const auto parts = read(folder.write("two.step", text)).parts;
  ASSERT_EQ(parts.size(), 2U);
  const bool isFirst = parts[0].mesh->faces.size() == 3 && boundingBox(*parts[0].mesh).diagonal().norm() >
                                                               1.5 * boundingBox(*parts[1].mesh).diagonal().norm();
  const TriangleMesh& large = *parts[isFirst ? 0 : 1].mesh;
  const TriangleMesh& plain = *parts[isFirst ? 1 : 0].mesh;
  const auto coneOf = [](const TriangleMesh& mesh) {
    return *std::find_if(mesh.faces.begin(), mesh.faces.end(),
                         [](const SurfaceFace& face) { return face.kind == Kind::Cone; });
  };
  EXPECT_NEAR(coneOf(large).radius, 2.0 * coneOf(plain).radius, 1e-12);
  EXPECT_EQ(coneOf(large).second, coneOf(plain).second);
  const std::vector<double> largest = measured(large, distanceFrom);
  for (std::size_t f = 0; f < large.faces.size(); ++f) {
    EXPECT_GE(large.faces[f].deflection, largest[f] - kRounding);
    EXPECT_LE(large.faces[f].deflection, 1.01 * largest[f] + 1e-12);
  }
  EXPECT_LT(coneOf(plain).deflection, usualDeflection(boundingBox(plain).diagonal().norm()));
}

}  // namespace
}  // namespace glissade
