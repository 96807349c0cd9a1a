#include "widgets/instruction/step_drawer.h"

#include <gtest/gtest.h>

#include "tests/engine/documents/instruction/instructed_products.h"

namespace glissade {
namespace {

constexpr QSize kPixels(600, 400);

bool isOrange(QRgb pixel) { return qRed(pixel) > 160 && qBlue(pixel) < 100 && qGreen(pixel) > 90; }
bool isArrow(QRgb pixel) { return qRed(pixel) > 180 && qGreen(pixel) < 80 && qBlue(pixel) < 30; }
bool isPale(QRgb pixel) { return qBlue(pixel) > 150 && pixel != qRgb(255, 255, 255); }

template <class Is>
std::size_t count(const QImage& picture, const Is& is) {
  std::size_t found = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (is(picture.pixel(x, y))) ++found;
    }
  }
  return found;
}

WorkInstruction instructionOf(const test::InstructedProduct& made) { return test::instructed(made); }

TEST(LineDrawing, WhatIsInFrontHidesWhatIsBehind) {
  const Projection along(Vector3::UnitX(), Vector3::UnitZ());
  Projection projection = along;
  const auto mesh = boxBody("box", {1.0, 1.0, 1.0}, Pose::identity()).mesh;
  projection.fit(projection.boxOf(*mesh, Pose::identity()), QRectF(10.0, 10.0, 80.0, 80.0));
  const std::vector<DrawnBody> bodies{{mesh, Pose::translation({2.0, 0.0, 0.0}), Qt::red, Qt::black},
                                      {mesh, Pose::identity(), Qt::blue, Qt::black}};
  const QImage picture = lineDrawing(bodies, projection, {100, 100});
  EXPECT_GT(qRed(picture.pixel(50, 50)), 150);
  EXPECT_EQ(qBlue(picture.pixel(50, 50)), 0);
  EXPECT_EQ(picture.pixel(2, 2), qRgb(255, 255, 255));
  EXPECT_LT(qRed(picture.pixel(50, 10)), 160) << "a line where the body ends";
}

TEST(LineDrawing, LinesAreDrawnAtSharpEdgesOnly) {
  Projection projection(Vector3(1.0, 1.0, 1.0).normalized(), Vector3::UnitZ());
  const auto box = boxBody("box", {1.0, 1.0, 1.0}, Pose::identity()).mesh;
  projection.fit(projection.boxOf(*box, Pose::identity()), QRectF(10.0, 10.0, 180.0, 180.0));
  const QImage picture = lineDrawing({{box, Pose::identity(), Qt::white, Qt::black}}, projection, {200, 200});
  const std::size_t lines = count(picture, [](QRgb pixel) { return qRed(pixel) < 100; });
  EXPECT_GT(lines, 350U) << "nine edges of about 100 pixels";
  EXPECT_LT(lines, 2500U) << "no diagonals of faces";
}

TEST(StepDrawer, AllThatComesIsMarkedAndTheRestIsPale) {
  test::InstructedProduct made = test::blocksOnABase(4);
  for (AssemblyStep& step : made.plan.steps) step.task = 1;
  const WorkInstruction together = instructionOf(made);
  for (AssemblyStep& step : made.plan.steps) step.task = 0;
  const WorkInstruction alone = instructionOf(made);
  const StepDrawer drawer(made.product);
  const QImage four = drawer.panel(together.panels[1], kPixels);
  const QImage one = drawer.panel(alone.panels[1], kPixels);
  EXPECT_GT(count(one, isOrange), 200U);
  EXPECT_GT(count(four, isOrange), 3 * count(one, isOrange));
  EXPECT_GT(count(one, isPale), 1000U);
  EXPECT_GT(count(one, isArrow), 20U) << "an arrow of the motion";
}

TEST(StepDrawer, ACloseUpHasAFrameAndShowsThePartLarger) {
  test::InstructedProduct made = test::blocksOnABase(40);
  InstructionPanel panel = instructionOf(made).panels[1];
  panel.closeUp = false;
  const StepDrawer drawer(made.product);
  const std::size_t small = count(drawer.panel(panel, kPixels), isOrange);
  panel.closeUp = true;
  EXPECT_GT(count(drawer.panel(panel, kPixels), isOrange), 4 * small);
}

TEST(StepDrawer, WhatComesIsSeenThroughWhatHidesIt) {
  test::InstructedProduct made;
  made.product = test::productOf({boxBody("wall", {0.1, 4.0, 4.0}, Pose::translation({-1.0, 0.0, 0.0})),
                                  boxBody("box", {0.4, 0.4, 0.4}, Pose::identity())});
  InstructionPanel panel;
  panel.present = {"wall"};
  panel.steps = {test::stepAlong("box", Vector3::UnitY())};
  const StepDrawer drawer(made.product);
  const auto isTinted = [](QRgb pixel) { return qRed(pixel) - qBlue(pixel) > 40 && !isArrow(pixel); };
  EXPECT_GT(count(drawer.panel(panel, kPixels), isTinted), 500U);
}

/// A large part that is seen does not make up for a small one that is hidden.
TEST(StepDrawer, EachMotionIsSeen) {
  test::InstructedProduct made;
  made.product = test::productOf({boxBody("wall", {0.1, 4.0, 4.0}, Pose::translation({-1.0, 0.0, 0.0})),
                                  boxBody("box", {0.4, 0.4, 0.4}, Pose::identity()),
                                  boxBody("slab", {1.0, 3.0, 3.0}, Pose::translation({-2.0, 0.0, 0.0}))});
  InstructionPanel panel;
  panel.present = {"wall"};
  const StepDrawer drawer(made.product);
  const auto isTinted = [](QRgb pixel) { return qRed(pixel) - qBlue(pixel) > 40 && !isArrow(pixel); };
  panel.steps = {test::stepAlong("slab", -Vector3::UnitX())};
  const std::size_t slab = count(drawer.panel(panel, kPixels), isTinted);
  panel.steps = {test::stepAlong("slab", -Vector3::UnitX()), test::stepAlong("box", Vector3::UnitY())};
  const QImage both = drawer.panel(panel, kPixels);
  const auto isBlended = [&](QRgb pixel) { return isTinted(pixel) && !isOrange(pixel); };
  EXPECT_GT(slab, 5000U);
  EXPECT_GT(count(both, isBlended), 100U) << "the box shows through";
}

TEST(StepDrawer, PicturesHaveTheirSize) {
  const test::InstructedProduct made = test::blocksOnABase(2);
  const StepDrawer drawer(made.product);
  EXPECT_EQ(drawer.finished(made.plan.bodies, kPixels).size(), kPixels);
  EXPECT_EQ(drawer.parts({"block0"}, {64, 64}).size(), QSize(64, 64));
  EXPECT_NE(drawer.finished(made.plan.bodies, kPixels, Vector3::UnitY()), drawer.finished(made.plan.bodies, kPixels))
      << "the product lies as it does at the work place";
  EXPECT_EQ(drawer.exploded(std::vector<Pose>(3), kPixels), drawer.finished(made.plan.bodies, kPixels));
}

}  // namespace
}  // namespace glissade
