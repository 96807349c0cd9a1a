#include "engine/files/unit_guess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

Box3 cube(double edge) { return {Vector3::Zero(), Vector3::Constant(edge)}; }

void expectGuess(const std::vector<Box3>& boxes, double unit, bool inDoubt) {
  const UnitGuess guess = guessUnit(boxes);
  EXPECT_EQ(guess.unit, unit);
  EXPECT_EQ(guess.inDoubt, inDoubt);
}

TEST(UnitGuess, FollowsTheSize) {
  expectGuess({cube(0.024)}, 1.0, false);  // 24 mm, not 24 µm
  expectGuess({cube(60.0), cube(10.0)}, 0.001, false);
  expectGuess({cube(1.0)}, 0.001, true);             // a small part, or a cabinet
  expectGuess({cube(1.2), cube(0.01)}, 1.0, false);  // a rail and its screw
  expectGuess({cube(5000.0)}, 0.001, false);
  expectGuess({cube(1e6)}, 0.001, true);  // a kilometre
  expectGuess({cube(1e-6)}, 0.001, true);
}

std::string tetrahedron(double edge) {
  const std::string e = std::to_string(edge);
  return "v 0 0 0\nv " + e + " 0 0\nv 0 " + e + " 0\nv 0 0 " + e + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
}

TEST(UnitGuess, IsToldWithTheOption) {
  const TemporaryFolder folder;
  GeometryCache read;
  std::vector<PartFile> metres{usualPart(folder.write("a.obj", tetrahedron(0.024))),
                               usualPart(folder.write("b.obj", tetrahedron(0.5)))};
  auto told = guessUnits(metres, read);
  ASSERT_TRUE(told) << toString(told.error());
  EXPECT_EQ(metres[0].unit, 1.0);
  EXPECT_EQ(metres[1].unit, 1.0);
  ASSERT_EQ(told->size(), 1U);
  EXPECT_THAT(toString(told->front().reason), HasSubstr("0.024 x 0.024 x 0.024"));
  EXPECT_THAT(toString(told->front().reason), HasSubstr("it is taken in metres; other files taken in the same way: 1"));
  EXPECT_THAT(toString(told->front().advice), HasSubstr("--unit 1m"));

  std::vector<PartFile> usual{usualPart(folder.write("c.obj", tetrahedron(24.0)))};
  told = guessUnits(usual, read);
  ASSERT_TRUE(told) << toString(told.error());
  EXPECT_EQ(usual[0].unit, 0.001);
  EXPECT_TRUE(told->empty());

  std::vector<PartFile> doubtful{usualPart(folder.write("d.obj", tetrahedron(2.0)))};
  told = guessUnits(doubtful, read);
  ASSERT_TRUE(told) << toString(told.error());
  ASSERT_EQ(told->size(), 1U);
  EXPECT_THAT(toString(told->front().reason), HasSubstr("taken in millimetres; the size does not decide this"));
  EXPECT_FALSE(guessUnits(doubtful = {usualPart(folder / "gone.stl")}, read).ok());
}

}  // namespace
}  // namespace glissade
