#include "engine/evidence/hollow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/check/path_verdict.h"
#include "engine/evidence/thinning.h"
#include "engine/geometry/triangle_pair.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/support/random_pose.h"

namespace glissade::check {
namespace {

/// A solid by its mesh and by a formula, for points in its frame.
struct Solid {
  TriangleMesh mesh;
  std::function<bool(const Vector3&)> holds;
};

Solid boxOf(const Vector3& half) {
  return {makeBox(2.0 * half), [half](const Vector3& p) { return (p.cwiseAbs() - half).maxCoeff() < 0.0; }};
}

/// A prism's side is inside of the circle: its apothem is the radius times a cosine.
Solid prismOf(int sides, double radius, double height) {
  return {test::prism(sides, radius, height), [=](const Vector3& p) {
            if (p.z() <= 0.0 || p.z() >= height) return false;
            const double step = 2.0 * std::numbers::pi / sides;
            const double angle = std::atan2(p.y(), p.x());
            const double middle = (std::floor(angle / step) + 0.5) * step;
            return std::hypot(p.x(), p.y()) * std::cos(angle - middle) < radius * std::cos(0.5 * step);
          }};
}

Solid plateOf(int sides, double radius, double outer, double height) {
  const Solid hole = prismOf(sides, radius, height);
  const Solid rim = prismOf(sides, outer, height);
  return {test::holedPlate(sides, radius, outer, 0.0, height),
          [=](const Vector3& p) { return rim.holds(p) && !hole.holds(p); }};
}

/// True if a ray from the point crosses the triangles an odd number of times.
bool isEnclosed(const TriangleMesh& mesh, const Vector3& from, const Vector3& direction) {
  bool odd = false;
  for (const TriangleIndices& t : mesh.triangles) {
    Eigen::Matrix3d edges;
    edges << mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]], -direction;
    if (std::abs(edges.determinant()) < 1e-30) continue;
    const Vector3 solved = edges.inverse() * (from - mesh.vertices[t[0]]);
    if (solved[0] > 0.0 && solved[1] > 0.0 && solved[0] + solved[1] < 1.0 && solved[2] > 0.0) odd = !odd;
  }
  return odd;
}

PlacedBody placed(const Solid& solid, const Pose& pose) {
  return PlacedBody(test::checkBody("solid", solid.mesh), pose);
}

/// Share of random points that mesh and formulas classify differently. Each uses one ray, so a few rays through edges
/// are wrong.
double wrongShare(const Solid& body, const Pose& X_WA, const Solid& guest, const Pose& X_WB, const TriangleMesh& left,
                  RandomStream& random) {
  constexpr int kPoints = 2000;
  int wrong = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3 p = randomPose(random, 0.03).position;
    const Vector3 direction = randomPose(random, 1.0).orientation * Vector3::UnitZ();
    const bool expected = body.holds(inverse(X_WA) * p) && !guest.holds(inverse(X_WB) * p);
    if (isEnclosed(left, p, direction) != expected) ++wrong;
  }
  return static_cast<double>(wrong) / kPoints;
}

/// True if the solid contains all points at 1 micrometre from this one along the axes.
bool holdsAllAt(const Solid& solid, const Vector3& p) {
  for (int i = 0; i < 6; ++i) {
    if (!solid.holds(p + (i < 3 ? 1e-6 : -1e-6) * Vector3::Unit(i % 3))) return false;
  }
  return true;
}
bool holdsAnyAt(const Solid& solid, const Vector3& p) {
  for (int i = 0; i < 6; ++i) {
    if (solid.holds(p + (i < 3 ? 1e-6 : -1e-6) * Vector3::Unit(i % 3))) return true;
  }
  return false;
}

Vector3 anyPoint(const TriangleMesh& mesh, RandomStream& random) {
  const auto number = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(mesh.triangles.size())));
  const TriangleIndices& t = mesh.triangles[std::min(number, mesh.triangles.size() - 1)];
  const double u = random.uniform(0.0, 1.0);
  const double v = random.uniform(0.0, 1.0 - u);
  return (1.0 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] + v * mesh.vertices[t[2]];
}

/// Largest distance from the remainder, metres, of random points of the body's surface outside of the guest, and of the
/// guest's surface in the body.
double lostSurface(const Solid& body, const Pose& X_WA, const Solid& guest, const Pose& X_WB, const TriangleMesh& left,
                   RandomStream& random) {
  const TriangleTree tree(left);
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 own = X_WA * anyPoint(body.mesh, random);
    const Vector3 others = X_WB * anyPoint(guest.mesh, random);
    if (!holdsAnyAt(guest, inverse(X_WB) * own)) most = std::max(most, tree.nearest(own, 1.0).distance);
    if (holdsAllAt(body, inverse(X_WA) * others)) most = std::max(most, tree.nearest(others, 1.0).distance);
  }
  return most;
}

TEST(Hollow, HoldsThePointsOfTheBodyThatAreNotInTheGuest) {
  RandomStream random(7, "hollow");
  const std::vector<Solid> solids{boxOf({0.01, 0.02, 0.015}), prismOf(24, 0.012, 0.03), prismOf(5, 0.02, 0.01),
                                  plateOf(16, 0.006, 0.02, 0.012)};
  int overlaps = 0;
  for (const Solid& body : solids) {
    for (const Solid& guest : solids) {
      for (int round = 0; round < 3; ++round) {
        const Pose X_WA = randomPose(random, 0.008);
        const Pose X_WB = randomPose(random, 0.008);
        const auto hollow = hollowed(placed(body, X_WA), placed(guest, X_WB));
        if (!hollow) continue;
        ++overlaps;
        EXPECT_LT(wrongShare(body, X_WA, guest, X_WB, *hollow, random), 0.002);
        EXPECT_LT(lostSurface(body, X_WA, guest, X_WB, *hollow, random), 1e-8);
      }
    }
  }
  EXPECT_GT(overlaps, 40);
}

TEST(Hollow, FlushFacesAndContactsLoseNoSurface) {
  RandomStream random(8, "flush");
  const Solid block = boxOf({0.01, 0.01, 0.01});
  const Solid bar = boxOf({0.005, 0.004, 0.02});
  // The guest's faces are in planes of the block's faces, or go through its edges and corners.
  for (const Vector3& at : {Vector3(0.005, 0.0, 0.0), Vector3(0.0, 0.006, 0.01), Vector3(0.01, 0.01, 0.0),
                            Vector3(0.005, 0.006, -0.01), Vector3(0.0, 0.0, 0.0)}) {
    const Pose X_WB = Pose::translation(at);
    const auto hollow = hollowed(placed(block, Pose::identity()), placed(bar, X_WB));
    ASSERT_TRUE(hollow) << at.transpose();
    EXPECT_LT(lostSurface(block, Pose::identity(), bar, X_WB, *hollow, random), 1e-8) << at.transpose();
  }
}

TEST(Hollow, ThereIsNoneWithoutAnOverlapOrAnInside) {
  const Solid block = boxOf({0.01, 0.01, 0.01});
  const PlacedBody own = placed(block, Pose::identity());
  EXPECT_FALSE(hollowed(own, placed(block, Pose::translation({0.03, 0.0, 0.0})))) << "apart";
  EXPECT_FALSE(hollowed(own, placed(block, Pose::translation({0.02, 0.0, 0.0})))) << "they touch";
  EXPECT_FALSE(hollowed(own, placed(boxOf({0.02, 0.02, 0.02}), Pose::identity()))) << "nothing is left";
  Solid open = block;
  open.mesh.triangles.pop_back();
  EXPECT_FALSE(hollowed(placed(open, Pose::identity()), placed(block, Pose::translation({0.01, 0.0, 0.0}))));
  EXPECT_FALSE(hollowed(own, placed(open, Pose::translation({0.01, 0.0, 0.0}))));
}

/// A knob with twelve sides whose lip overlaps it by less than 0.8 mm; `accepted`: depth of the accepted clash.
Question knobInItsLip(double accepted) {
  Question question;
  question.product.bodies = {test::checkBody("lip", test::holedPlate(12, 0.0192, 0.04, 0.015, 0.03)),
                             test::checkBody("knob", test::prism(12, 0.02, 0.02))};
  question.product.fits.on = true;
  question.product.fits.acceptedClash = accepted;
  question.workspace = Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0));
  question.requiredClearance = 2e-7;
  question.contactGap = 2e-5;
  return question;
}

/// The claims about the lip and the knob, in this order.
Path along(double z, const std::vector<StatedAllowance>& claims) {
  Path path;
  path.points = {{Pose::identity()}, {Pose::translation({0.0, 0.0, z})}};
  path.allowances = claims;
  return path;
}

std::vector<StatedAllowance> hollowLip(double allowance = 1e-6) {
  StatedAllowance lip{"knob", "lip", 8e-4, true};
  lip.hollow = true;
  return {lip, {"knob", "lip", allowance}};
}

TEST(Hollow, AnAcceptedClashLeavesTheKnobNoWayThroughTheLip) {
  const Question question = knobInItsLip(1e-3);
  const PathVerdict up = judgePath(question, along(0.1, hollowLip()));
  EXPECT_TRUE(up.refusals.empty()) << toString(up.refusals.front());
  EXPECT_EQ(up.motion.verdict.status, Status::Violated) << "above the knob the lip is whole";
  const PathVerdict down = judgePath(question, along(-0.1, hollowLip()));
  EXPECT_TRUE(down.valid());
  ASSERT_EQ(down.allowances.size(), 2U);
  EXPECT_TRUE(down.allowances[0].hollow);
  EXPECT_NEAR(down.allowances[0].applied, 7.7e-4, 2e-5);
}

/// The wall of the cut consists of the guest's triangles, and corners of the guest would collide with its facets.
TEST(Hollow, ARoundGuestTurnsInTheHoleThatItMakes) {
  constexpr int kSides = 24;
  constexpr double kRadius = 0.005;
  Body rod = test::checkBody("rod", test::prism(kSides, kRadius, 0.04), {0.0, 0.0, -0.02});
  rod.deflection = kRadius * (1.0 - std::cos(std::numbers::pi / kSides));
  const PlacedBody guest(rod, rod.X_WB);
  const PlacedBody plate(test::checkBody("plate", makeBox({0.03, 0.03, 0.006})), Pose::identity());
  const auto left = hollowed(plate, guest);
  ASSERT_TRUE(left);
  const TriangleTree wall(*left);
  const auto meets = [&](double room, double turn) {
    const TriangleMesh thin = thinned(*rod.mesh, std::vector<double>(rod.mesh->triangles.size(), room));
    const Pose turned{rod.X_WB.position, fromRollPitchYaw(0.0, 0.0, turn)};
    bool any = false;
    TriangleTree(transformed(thin, turned)).visitPairs(wall, 0.0, [&](std::uint32_t i, std::uint32_t k) {
      const auto& [a, b, c] = thin.triangles[i];
      const Triangle moved{turned * thin.vertices[a], turned * thin.vertices[b], turned * thin.vertices[c]};
      any = trianglesMeet(moved, wall.triangles()[k]);
      return !any;
    });
    return any;
  };
  const double room = hollowRoom(plate, guest);
  const double half = std::numbers::pi / kSides;  // from a corner to the middle of a facet
  EXPECT_FALSE(meets(room, 0.0));
  EXPECT_FALSE(meets(room, half));
  EXPECT_TRUE(meets(room - wallDeflection(guest), half));
}

TEST(Hollow, FalseClaimsAreRefused) {
  const auto refused = [](double accepted, const std::vector<StatedAllowance>& claims) {
    const PathVerdict verdict = judgePath(knobInItsLip(accepted), along(-0.1, claims));
    return verdict.valid() || verdict.refusals.empty() ? std::string() : toString(verdict.refusals.front());
  };
  EXPECT_NE(refused(0.0, hollowLip()).find("not accepted"), std::string::npos);
  EXPECT_NE(refused(5e-4, hollowLip()).find("not accepted"), std::string::npos) << "a deeper clash than accepted";
  EXPECT_NE(refused(1e-3, hollowLip(1e-4)), "") << "the knob is taken thinner than it may be";
  std::vector<StatedAllowance> both = hollowLip();
  both[1].hollow = true;
  EXPECT_NE(refused(1e-3, both), "") << "both are hollow";
  EXPECT_NE(refused(1e-3, {hollowLip().front()}), "") << "the knob is whole, and no claim says otherwise";
  Question thread = knobInItsLip(1e-3);
  thread.product.fits.pairs.push_back({"knob", "lip", "thread"});
  EXPECT_FALSE(judgePath(thread, along(-0.1, hollowLip())).valid()) << "a person calls the pair a thread";
  Question apart = knobInItsLip(1e-3);
  apart.product.bodies[0].X_WB = Pose::translation({0.0, 0.0, 0.05});
  EXPECT_FALSE(judgePath(apart, along(-0.1, hollowLip())).valid()) << "nothing overlaps";
}

}  // namespace
}  // namespace glissade::check
