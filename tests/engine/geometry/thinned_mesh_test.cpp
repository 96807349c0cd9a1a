#include "engine/geometry/thinned_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/evidence/thinning.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

/// Bodies with flat, round, hollow, thin and sharp places, at random poses.
std::vector<TriangleMesh> bodies(RandomStream& random) {
  TriangleMesh lump = makeSphere(0.02, 2);
  for (Vector3& vertex : lump.vertices) vertex *= 0.7 + 0.6 * random.uniform();
  TriangleMesh angle = makeBox({0.04, 0.004, 0.03});
  append(angle, transformed(makeBox({0.004, 0.03, 0.03}), Pose::translation({0.01, 0.01, 0.0})));
  TriangleMesh wedge = makeBox({0.03, 0.02, 0.01});
  for (Vector3& vertex : wedge.vertices) vertex.z() *= vertex.x() > 0.0 ? 0.1 : 1.0;
  std::vector<TriangleMesh> all{makeBox({0.02, 0.03, 0.01}),
                                wedge,
                                angle,
                                lump,
                                makeCylinder(0.01, 0.03, 20),
                                test::makeRing(0.005, 0.012, 0.008, 24),
                                test::makeRing(0.0, 0.004, 0.05, 17),
                                test::makeRing(0.0095, 0.01, 0.02, 30)};
  for (TriangleMesh& mesh : all) mesh = transformed(mesh, randomPose(random, 0.1));
  return all;
}

Vector3 pointNear(const TriangleMesh& mesh, double way, RandomStream& random) {
  const auto& triangle = mesh.triangles[static_cast<std::size_t>(random.uniform() * mesh.triangles.size())];
  const double a = random.uniform();
  const double b = (1.0 - a) * random.uniform();
  const Vector3 on =
      a * mesh.vertices[triangle[0]] + b * mesh.vertices[triangle[1]] + (1.0 - a - b) * mesh.vertices[triangle[2]];
  const Vector3 aside{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
  return on + 2.0 * way * aside;
}

TEST(ThinnedMesh, ABoxLosesTheAllowanceOnEverySide) {
  const auto box = ThinnableMesh::of(makeBox({0.02, 0.03, 0.04}));
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->thickness(), 0.04, 1e-12);
  const auto thinned = box->thinned(0.001);
  ASSERT_TRUE(thinned);
  EXPECT_TRUE(boundingBox(*thinned).sizes().isApprox(Vector3(0.018, 0.028, 0.038), 1e-6));
}

TEST(ThinnedMesh, ARingLosesTheAllowanceInsideAndOutside) {
  constexpr double kAllowance = 0.0004;
  constexpr int kSegments = 24;
  const double cosine = std::cos(3.14159265358979323846 / kSegments);
  const auto ring = ThinnableMesh::of(test::makeRing(0.005, 0.012, 0.008, kSegments));
  ASSERT_TRUE(ring);
  const auto thinned = ring->thinned(kAllowance);
  ASSERT_TRUE(thinned);
  for (const Vector3& vertex : thinned->vertices) {
    const double radius = vertex.head<2>().norm();
    EXPECT_NEAR(radius, radius < 0.008 ? 0.005 + kAllowance / cosine : 0.012 - kAllowance / cosine, 1e-8);
    EXPECT_NEAR(std::abs(vertex.z()), 0.004 - kAllowance, 1e-8);
  }
}

TEST(ThinnedMesh, IsNeverLargerThanTheBodyAndHoldsWhatIsDeeperThanTwoAllowances) {
  RandomStream random(1, "thinned");
  int points = 0;
  int core = 0;
  for (int round = 0; round < 5; ++round) {
    for (const TriangleMesh& mesh : bodies(random)) {
      const double allowance = 0.0008 * random.uniform();
      const auto body = ThinnableMesh::of(mesh);
      ASSERT_TRUE(body);
      const auto thinned = body->thinned(allowance);
      ASSERT_TRUE(thinned);
      const TriangleTree surface(mesh);
      for (int i = 0; i < 2500; ++i, ++points) {
        const Vector3 p = pointNear(mesh, 4.0 * allowance, random);
        const bool inside = containsPoint(mesh, p);
        const bool left = containsPoint(*thinned, p);
        ASSERT_FALSE(left && !inside) << "larger than the body";
        if (!inside || surface.nearest(p, 1.0).distance <= kLongestThinning * allowance) continue;
        ++core;
        ASSERT_TRUE(left) << "the core is not in it";
      }
    }
  }
  EXPECT_EQ(points, 100'000);
  EXPECT_GT(core, 5000);
}

TEST(ThinnedMesh, NoWallLosesMoreThanTwoFifths) {
  constexpr double kWall = 0.0005;
  const auto tube = ThinnableMesh::of(test::makeRing(0.01 - kWall, 0.01, 0.02, 60));
  ASSERT_TRUE(tube);
  const auto thinned = tube->thinned(0.003);
  ASSERT_TRUE(thinned);
  for (const Vector3& vertex : thinned->vertices) {
    const double radius = vertex.head<2>().norm();
    EXPECT_GT(radius, 0.01 - 0.81 * kWall);
    EXPECT_LT(radius, 0.01 - 0.19 * kWall);
  }
}

void expectAlike(const TriangleMesh& judged, const TriangleMesh& thinned) {
  ASSERT_EQ(judged.triangles.size(), thinned.triangles.size());
  for (std::size_t f = 0; f < judged.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3& own = judged.vertices[judged.triangles[f][i]];
      ASSERT_NEAR((own - thinned.vertices[thinned.triangles[f][i]]).norm(), 0.0, 1e-10);
    }
  }
}

TEST(ThinnedMesh, TheJudgeThinsAlike) {
  RandomStream random(2, "judge");
  for (const TriangleMesh& mesh : bodies(random)) {
    const double allowance = 0.0005 * random.uniform();
    const auto thinned = ThinnableMesh::of(mesh)->thinned(allowance);
    ASSERT_TRUE(thinned);
    expectAlike(evidence::thinned(mesh, std::vector<double>(mesh.triangles.size(), allowance)), *thinned);
  }
}

TEST(ThinnedMesh, WhatHasNoInsideCannotBeThinned) {
  EXPECT_FALSE(ThinnableMesh::of({}));
  TriangleMesh open = makeBox({1.0, 1.0, 1.0});
  open.triangles.pop_back();
  EXPECT_FALSE(ThinnableMesh::of(open)->thinned(0.001)) << "beside the opening, too";
  TriangleMesh turned = makeBox({1.0, 1.0, 1.0});
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(ThinnableMesh::of(turned)->thinned(0.001));
}

/// Allowances for the faces that look along z.
std::vector<double> ofTop(const TriangleMesh& mesh, double allowance) {
  std::vector<double> allowances;
  for (const TriangleIndices& t : mesh.triangles) allowances.push_back(faceNormal(mesh, t).z() > 0.5 ? allowance : 0.0);
  return allowances;
}

/// A box of 20 x 30 x 40 mm without its bottom.
TriangleMesh openBox() {
  TriangleMesh box = makeBox({0.02, 0.03, 0.04});
  std::vector<TriangleIndices> kept;
  for (const TriangleIndices& t : box.triangles) {
    if (faceNormal(box, t).z() > -0.5) kept.push_back(t);
  }
  box.triangles = kept;
  return box;
}

TEST(ThinnedMesh, AnOpenBodyIsThinnedFarFromItsOpening) {
  const TriangleMesh box = openBox();
  const auto body = ThinnableMesh::of(box);
  ASSERT_TRUE(body);
  EXPECT_FALSE(body->openBeside(ofTop(box, 0.001)));
  const auto thinned = body->thinned(ofTop(box, 0.001));
  ASSERT_TRUE(thinned);
  EXPECT_NEAR(boundingBox(*thinned).max().z(), 0.019, 1e-8);
  EXPECT_EQ(boundingBox(*thinned).min().z(), -0.02);
}

TEST(ThinnedMesh, NearTheOpeningItSaysHowNear) {
  const TriangleMesh box = openBox();
  const auto body = ThinnableMesh::of(box);
  EXPECT_FALSE(body->thinned(0.001)) << "the sides, too, which end at the opening";
  ASSERT_TRUE(body->openBeside(std::vector<double>(box.triangles.size(), 0.001)));
  EXPECT_EQ(*body->openBeside(std::vector<double>(box.triangles.size(), 0.001)), 0.0);
  EXPECT_NEAR(*body->openBeside(ofTop(box, 0.0041)), 0.04, 1e-12) << "ten allowances are 41 mm";
}

TEST(ThinnedMesh, ASheetHasNoInside) {
  TriangleMesh sheet = makeBox({1.0, 1.0, 0.1});
  std::vector<TriangleIndices> top;
  for (const TriangleIndices& t : sheet.triangles) {
    if (faceNormal(sheet, t).z() > 0.5) top.push_back(t);
  }
  // Its middle, among sixteen times as many triangles, is far from its edges.
  TriangleMesh fine;
  for (int i = -2; i < 2; ++i) {
    for (int k = -2; k < 2; ++k) {
      TriangleMesh part{sheet.vertices, top};
      append(fine, transformed(part, Pose::translation({1.0 * i, 1.0 * k, 0.0})));
    }
  }
  fine = welded(fine);
  std::vector<double> allowances;
  for (const auto& [a, b, c] : fine.triangles) {
    const Vector3 middle = (fine.vertices[a] + fine.vertices[b] + fine.vertices[c]) / 3.0;
    allowances.push_back(middle.head<2>().cwiseAbs().maxCoeff() < 0.9 ? 0.01 : 0.0);
  }
  const auto body = ThinnableMesh::of(fine);
  EXPECT_FALSE(body && body->thinned(allowances));
}

/// Random bodies lose triangles, and the rest is thinned or refused. Where it is thinned, the whole body decides that
/// the result is behind the true surface.
TEST(ThinnedMesh, AnOpenBodyIsNeverLargerThanTheWholeOne) {
  RandomStream random(5, "open");
  int thinnedOnes = 0;
  int refused = 0;
  for (int round = 0; round < 12; ++round) {
    for (const TriangleMesh& whole : bodies(random)) {
      TriangleMesh open = whole;
      const std::size_t lost = 1 + static_cast<std::size_t>(3.0 * random.uniform());
      for (std::size_t i = 0; i < lost; ++i) {
        const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(open.triangles.size()));
        open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(at));
      }
      const auto body = ThinnableMesh::of(open);
      ASSERT_TRUE(body);
      const double allowance = 0.0004 * random.uniform();
      std::vector<double> allowances(open.triangles.size(), 0.0);
      allowances[static_cast<std::size_t>(random.uniform() * static_cast<double>(allowances.size()))] = allowance;
      const auto thinned = body->thinned(allowances);
      ++(thinned ? thinnedOnes : refused);
      if (!thinned) continue;
      expectAlike(evidence::thinned(open, allowances), *thinned);
      const double rounding = 1e-9 + 0.01 * allowance;
      const TriangleTree surface(whole);
      for (const TriangleIndices& t : thinned->triangles) {
        for (int i = 0; i < 20; ++i) {
          const double a = random.uniform();
          const double b = (1.0 - a) * random.uniform();
          const Vector3 p =
              a * thinned->vertices[t[0]] + b * thinned->vertices[t[1]] + (1.0 - a - b) * thinned->vertices[t[2]];
          ASSERT_TRUE(containsPoint(whole, p) || surface.nearest(p, 1.0).distance <= rounding)
              << "larger than the body";
        }
      }
    }
  }
  EXPECT_GT(thinnedOnes, 30);
  EXPECT_GT(refused, 5);
}

TEST(ThinnedMesh, TrianglesMayRunEitherWay) {
  TriangleMesh inverted = makeBox({0.02, 0.03, 0.04});
  for (TriangleIndices& triangle : inverted.triangles) std::swap(triangle[0], triangle[1]);
  const auto thinned = ThinnableMesh::of(inverted)->thinned(0.001);
  ASSERT_TRUE(thinned);
  EXPECT_TRUE(boundingBox(*thinned).sizes().isApprox(Vector3(0.018, 0.028, 0.038), 1e-6));
}

}  // namespace
}  // namespace glissade
