#include "engine/places/coverage.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/geometry/cube_intersector.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

constexpr int kDepth = 4;  // cells of 1/16, which is exact in binary
const CellFrame kFrame{Vector3::Zero(), 1.0};
constexpr double kSize = 1.0 / 16;

using Index = std::array<std::uint32_t, 3>;

/// A box with corners in whole cells.
TriangleMesh boxOfCells(const Vector3& first, const Vector3& last) {
  return test::boxBetween(kSize * first, kSize * last);
}

TriangleMesh insideOut(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

template <class Occupied>
CellRuns runsWhere(Occupied&& occupied) {
  std::set<std::uint64_t> codes;
  for (std::uint32_t x = 0; x < 16; ++x) {
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t z = 0; z < 16; ++z) {
        if (occupied(Index{x, y, z})) codes.insert(mortonCode({x, y, z}));
      }
    }
  }
  CellRuns runs;
  for (const std::uint64_t code : codes) {
    if (!runs.empty() && runs.back().end == code) {
      ++runs.back().end;
    } else {
      runs.push_back({code, code + 1});
    }
  }
  return runs;
}

CellRuns cellsBetween(const Index& first, const Index& last) {
  return runsWhere([&](const Index& c) {
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) within = within && c[a] >= first[a] && c[a] < last[a];
    return within;
  });
}

TEST(Coverage, ABoxAlignedWithTheCellsOccupiesExactlyItsCells) {
  const TriangleMesh box = boxOfCells({2, 1, 4}, {5, 3, 8});
  EXPECT_EQ(coverageOf(box, true, kFrame, kDepth), cellsBetween({2, 1, 4}, {5, 3, 8}));
  // Its surface alone only touches cells.
  EXPECT_TRUE(coverageOf(box, false, kFrame, kDepth).empty());
}

TEST(Coverage, OfAnOpenSurfaceTheInsideDoesNotCount) {
  const TriangleMesh box = boxOfCells({2.5, 2.5, 2.5}, {7.5, 7.5, 7.5});
  EXPECT_EQ(cellCount(coverageOf(box, true, kFrame, kDepth)), 6U * 6U * 6U);
  EXPECT_EQ(cellCount(coverageOf(box, false, kFrame, kDepth)), 6U * 6U * 6U - 4U * 4U * 4U);
}

TEST(Coverage, AgreesWithAskingEveryCell) {
  RandomStream stream(5, "bodies");
  for (int trial = 0; trial < 40; ++trial) {
    Pose X_WB = randomPose(stream, 0.5);
    X_WB.position += Vector3::Constant(0.5);
    const TriangleMesh mesh_W =
        transformed(trial % 2 == 0 ? makeBox({stream.uniform(0.02, 0.7), 0.3, 0.2}) : makeCylinder(0.2, 0.5, 9), X_WB);
    const CellRuns expected = runsWhere([&](const Index& c) {
      const Vector3 centre = kFrame.box(Cell{kDepth, c}).center();
      for (const auto& t : mesh_W.triangles) {
        const CubeIntersector triangle({mesh_W.vertices[t[0]], mesh_W.vertices[t[1]], mesh_W.vertices[t[2]]});
        if (triangle.enters(centre, kSize / 2)) {
          return true;
        }
      }
      return containsPoint(mesh_W, centre);
    });
    EXPECT_EQ(coverageOf(mesh_W, true, kFrame, kDepth), expected) << "trial " << trial;
    EXPECT_EQ(coverageOf(insideOut(mesh_W), true, kFrame, kDepth), expected) << "inside out, trial " << trial;
  }
}

TEST(Coverage, WhereClosedPartsOverlapIsInside) {
  TriangleMesh cross = boxOfCells({1, 6, 6}, {15, 10, 10});
  append(cross, boxOfCells({6, 1, 6}, {10, 15, 10}));
  append(cross, boxOfCells({6, 6, 1}, {10, 10, 15}));
  EXPECT_EQ(cellCount(coverageOf(cross, true, kFrame, kDepth)), 3U * 14 * 4 * 4 - 2U * 4 * 4 * 4);
}

TEST(Coverage, ACavityIsFree) {
  TriangleMesh shell = boxOfCells({2, 2, 2}, {12, 12, 12});
  append(shell, insideOut(boxOfCells({4, 4, 4}, {10, 10, 10})));
  const CellRuns covered = coverageOf(shell, true, kFrame, kDepth);
  EXPECT_EQ(covered, difference(cellsBetween({2, 2, 2}, {12, 12, 12}), cellsBetween({4, 4, 4}, {10, 10, 10})));
}

TEST(Coverage, PartsOutsideTheRootAreLeftOutAndTheRestKeepsItsInside) {
  const TriangleMesh round = test::boxBetween(Vector3(-3, -2, -1), Vector3(0.5, 4, 5));
  EXPECT_EQ(coverageOf(round, true, kFrame, kDepth), cellsBetween({0, 0, 0}, {8, 16, 16}));
  EXPECT_TRUE(coverageOf(test::boxBetween(Vector3(1, 0, 0), Vector3(2, 1, 1)), true, kFrame, kDepth).empty());
  EXPECT_EQ(coverageOf(test::boxBetween(Vector3::Constant(-1), Vector3::Constant(2)), true, kFrame, kDepth),
            (CellRuns{{0, 4096}}));
}

TEST(CellRuns, DifferenceIsThatOfTheSets) {
  RandomStream stream(9, "runs");
  const auto randomRuns = [&] {
    CellRuns runs;
    std::uint64_t at = static_cast<std::uint64_t>(stream.uniform(0, 5));
    while (at < 60) {
      const auto length = 1 + static_cast<std::uint64_t>(stream.uniform(0, 9));
      runs.push_back({at, at + length});
      at += length + 1 + static_cast<std::uint64_t>(stream.uniform(0, 6));
    }
    return runs;
  };
  const auto cells = [](const CellRuns& runs) {
    std::set<std::uint64_t> all;
    for (const CellRun& run : runs) {
      for (std::uint64_t c = run.begin; c < run.end; ++c) all.insert(c);
    }
    return all;
  };
  for (int trial = 0; trial < 500; ++trial) {
    const CellRuns a = randomRuns();
    const CellRuns b = trial % 50 == 0 ? CellRuns{} : randomRuns();
    const CellRuns result = difference(a, b);
    std::set<std::uint64_t> expected = cells(a);
    for (const std::uint64_t c : cells(b)) expected.erase(c);
    EXPECT_EQ(cells(result), expected);
    EXPECT_EQ(cellCount(result), expected.size());
    for (std::size_t i = 1; i < result.size(); ++i) EXPECT_LT(result[i - 1].end, result[i].begin);
  }
}

}  // namespace
}  // namespace glissade
