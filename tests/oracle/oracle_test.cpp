#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/exact_judge.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/shapes.h"
#include "tests/oracle/triangle_files.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;

Placement at(double x, double y, double z) { return {{x, y, z}, {0, 0, 0, 1}}; }

/// A whole slide along a plate with a thickness of a thousandth of the size.
Verdict slideAt(double height, double size) {
  const auto sized = [&](Triangles triangles) {
    for (Triangle& triangle : triangles) {
      for (Point& p : triangle) p = size * p;
    }
    return triangles;
  };
  const ExactJudge judge({{sized(box(4, 4, 1e-3))}, sized(box(0.5, 0.5, 0.5))});
  Verdict verdict;
  judge.judge({at(-size, 0, size * height), at(size, 0.3 * size, size * height)}, 0.02, 300, verdict);
  return verdict;
}

TEST(Oracle, SeesTheLeastPenetrationAndTheLeastGapAtEveryScale) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    EXPECT_EQ(slideAt(0.2505 * (1.0 + 1e-13), size).penetrating, 0U) << size;
    const Verdict verdict = slideAt(0.2505 * (1.0 - 1e-13), size);
    EXPECT_EQ(verdict.penetrating, verdict.poses) << size;
    EXPECT_GT(verdict.poses, 100U);
    EXPECT_NEAR(slideAt(0.25, size).depth, 5e-4 * size, 1e-9 * size);
  }
}

TEST(Oracle, SeesSolidsInsideSolids) {
  const Triangles small = box(0.1, 0.1, 0.1);
  EXPECT_TRUE(ExactJudge({{box(1, 1, 1)}, small}).penetrates(at(0.2, 0.1, 0.0)));
  EXPECT_TRUE(ExactJudge({{small}, box(1, 1, 1)}).penetrates(at(0.2, 0.1, 0.0)));
  EXPECT_FALSE(ExactJudge({{hollowBox(1, 0.9)}, small}).penetrates(at(0.2, 0.1, 0.0))) << "in the cavity";
  EXPECT_TRUE(ExactJudge({{hollowBox(1, 0.5)}, small}).penetrates(at(0.37, 0.1, 0.0))) << "in the wall";
  EXPECT_FALSE(ExactJudge({{small}, hollowBox(1, 0.9)}).penetrates(at(0.2, 0.1, 0.0))) << "around it";
  EXPECT_FALSE(ExactJudge({{box(1, 1, 1)}, small}).penetrates(at(0.2, 0.9, 0.0)));
}

/// Corners of the box lie in the planes of distant triangles, and in no solid.
TEST(Oracle, WhatIsFlushWithADistantFaceIsNotInside) {
  const Triangles corner = lShape(1.0, 0.25, 1.0);
  const Triangles part = box(0.5, 0.5, 0.5);
  const ExactJudge judge({{corner}, part});
  EXPECT_EQ(judge.depthAt(at(0.5, 0.5, 0.0)), 0.0) << "in the notch, on both walls";
  EXPECT_EQ(judge.depthAt(at(0.75, 0.75, 0.0)), 0.0) << "flush with both arms";
  EXPECT_NEAR(judge.depthAt(at(0.49, 0.6, 0.0)), 0.01, 1e-12);
}

TEST(Oracle, InterpolatesAlongTheShorterArc) {
  const double half = std::sqrt(0.5);
  const Placement a{{0, 0, 0}, {0, 0, 0, 1}};
  const Placement b{{2, 0, 0}, {0, 0, -half, -half}};  // a quarter about z
  const Placement middle = between(a, b, 0.5);
  const Point turned = placed(middle, {1, 0, 0});
  EXPECT_NEAR(turned[0], 1.0 + half, 1e-15);
  EXPECT_NEAR(turned[1], half, 1e-15);
}

TEST(Oracle, ReadsEveryFormatThatItWrites) {
  const test::TemporaryFolder folder;
  const Triangles part = lShape(0.75, 0.25, 0.5);  // exact in single precision
  for (const MeshFormat format : {MeshFormat::TextStl, MeshFormat::BinaryStl, MeshFormat::Obj, MeshFormat::Glb}) {
    EXPECT_EQ(readTriangles(folder.write("part" + endingOf(format), meshFile(part, format))), part);
  }
}

/// The path maker uses the engine; the judge includes no code of it.
TEST(Oracle, SharesNothingWithTheEngine) {
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(test::sourceDirectory() + "/tests/oracle")) {
    const std::string name = entry.path().filename().string();
    if (name == "path_maker.cpp" || name == "oracle_test.cpp" || name == "CMakeLists.txt") continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("#include \"engine/"))) << name;
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

/// packaging/reliability.sh judges ten thousand paths.
TEST(Oracle, NoCertifiedPathPenetrates) {
  const test::TemporaryFolder folder;
  const std::string programs = test::programDirectory();
  const ChildEnd end = runChild(
      {programs + "/path_oracle", "campaign", programs + "/path_maker", folder.path(), "7", "60"}, {100, 4096});
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
  EXPECT_THAT(end.output, testing::HasSubstr("| 0 |"));
}

ChildEnd attack(const char* campaign, const std::string& folder, const char* seed, const char* count) {
  const std::string programs = test::programDirectory();
  return runChild({programs + "/check_attack", campaign, programs + "/glissade-cli", folder, seed, count}, {100, 4096});
}

/// packaging/reliability.sh tries a thousand pairs.
TEST(Oracle, NoTrappedPartLeaves) {
  const test::TemporaryFolder folder;
  const ChildEnd end = attack("trapped", folder.path(), "11", "6");
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
}

TEST(Oracle, NoTrappedPartWithAnOpenSurfaceLeaves) {
  const test::TemporaryFolder folder;
  const ChildEnd end = attack("open", folder.path(), "11", "6");
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
}

/// packaging/reliability.sh tries a thousand cases.
TEST(Oracle, NoOverlapFreesABodyElsewhere) {
  const test::TemporaryFolder folder;
  const ChildEnd end = attack("overlaps", folder.path(), "11", "4");
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
}

/// packaging/reliability.sh tries ten thousand mutants.
TEST(Oracle, NoFalsePathOrPlanIsValid) {
  const test::TemporaryFolder folder;
  const ChildEnd end = attack("mutants", folder.path(), "11", "60");
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
}

/// packaging/reliability.sh tries ten thousand mutants.
TEST(Oracle, NoPlanIsValidByItsOwnWords) {
  const test::TemporaryFolder folder;
  const std::string programs = test::programDirectory();
  const std::string product = test::stepFileDirectory() + "/fits.step";
  const ChildEnd end =
      runChild({programs + "/check_attack", "words", programs + "/glissade-cli", folder.path(), product, "11", "40"},
               {100, 4096});
  EXPECT_EQ(end.exitCode, 0) << end.errors << end.output;
}

}  // namespace
}  // namespace glissade::oracle
