#include "widgets/scene3d/legend_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/files/scenario_io.h"
#include "engine/files/scenario_ptr.h"
#include "tests/engine/support/directories.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/contact_layer.h"
#include "widgets/scene3d/environment_layers.h"
#include "widgets/scene3d/guidance_layer.h"
#include "widgets/scene3d/label_placement.h"
#include "widgets/scene3d/scale_bar.h"
#include "widgets/scene3d/view_cube.h"

namespace glissade {
namespace {

class LegendOverlayTest : public testing::Test {
 protected:
  LegendOverlayTest() {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/sliding-plane/scenario.json");
    scenario = std::make_shared<const LoadedScenario>(std::move(*loaded));
    view.setScenario(scenario);
    scene.resize(900, 600);
    legend.resize(scene.size());
    scene.show();
  }
  ~LegendOverlayTest() override { scene.hide(); }

  /// Shows a run whose trees have a node of the operator.
  void showRun() {
    auto chunk = std::make_shared<RoadmapChunk>();
    chunk->nodes.resize(3);
    chunk->nodes[1].author = Author::Operator;
    chunk->nodes[2].side = TreeSide::Goal;
    chunk->edges = {{0, 1}, {1, 2}};
    auto snapshot = std::make_shared<SessionSnapshot>();
    snapshot->run = 1;
    snapshot->roadmap.push_back(chunk);
    view.setSnapshot(snapshot);
  }

  ScenarioPtr scenario;
  SceneView view;
  QWidget scene;
  ViewCube cube{view, &scene};
  ScaleBar scale{view, &scene};
  LegendOverlay legend{view, &scene};
};

TEST_F(LegendOverlayTest, ListsWhatIsDrawnNow) {
  EXPECT_EQ(legend.texts(), (QStringList{"Moving part", "Start", "Goal", "Workspace"}));
  showRun();
  for (const char* row : {"Searched from the start", "Searched from the goal", "By the operator"}) {
    EXPECT_TRUE(legend.texts().contains(QLatin1String(row))) << row;
  }
  EXPECT_FALSE(legend.texts().contains(QStringLiteral("In contact")));
  view.setLayerVisible(SceneLayer::Roadmap, false);
  view.setLayerVisible(SceneLayer::StartAndGoal, false);
  EXPECT_EQ(legend.texts(), (QStringList{"Moving part", "Workspace"}));
}

/// A highlight is drawn for obstacles; the object has none.
TEST_F(LegendOverlayTest, NamesASelectionOnlyWhereOneIsDrawn) {
  EnvironmentPicture environment;
  environment.selectedBodies = {scenario->objectBodies.front().id};
  view.setEnvironment(environment);
  EXPECT_FALSE(legend.texts().contains(QStringLiteral("Selected")));
  environment.selectedBodies = {scenario->obstacles.front().id};
  view.setEnvironment(environment);
  EXPECT_TRUE(legend.texts().contains(QStringLiteral("Selected")));
}

double difference(const Colour& a, const Colour& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// The colour as a person sees it who lacks a kind of cones (Machado, Oliveira and Fernandes 2009).
Colour seenBy(const Colour& colour, const Eigen::Matrix3d& eye) {
  const Vector3 seen = eye * Vector3(colour[0], colour[1], colour[2]);
  return {seen.x(), seen.y(), seen.z()};
}
Colour withoutRed(const Colour& colour) {
  Eigen::Matrix3d eye;
  eye << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  return seenBy(colour, eye);
}
Colour withoutGreen(const Colour& colour) {
  Eigen::Matrix3d eye;
  eye << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  return seenBy(colour, eye);
}

TEST_F(LegendOverlayTest, TheSelectionAStepAndItsPathHaveColoursOfTheirOwn) {
  const std::size_t obstacles = scenario->obstacles.size();
  EnvironmentPicture environment;
  environment.selectedBodies = {scenario->obstacles.front().id};
  view.setEnvironment(environment);
  SequencePicture step;
  step.bodies.resize(obstacles + 1);
  step.bodies.back().marked = true;
  step.way = {Vector3::Zero(), Vector3::UnitX()};
  view.setSequence(step);
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    view.setTheme(theme);
    std::vector<Colour> colours;
    for (const LegendRow& row : view.legend()) {
      const bool isOne =
          row.item == LegendItem::Selected || row.item == LegendItem::MovingPart || row.item == LegendItem::WayOfPart;
      if (isOne) colours.push_back(row.colours.front());
    }
    ASSERT_EQ(colours.size(), 3U);
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const Colour& a = colours[i];
      const Colour& b = colours[(i + 1) % colours.size()];
      EXPECT_GT(difference(a, b), 0.4) << i;
      EXPECT_GT(difference(withoutGreen(a), withoutGreen(b)), 0.3) << i;
      EXPECT_GT(difference(withoutRed(a), withoutRed(b)), 0.3) << i;
    }
  }
}

TEST_F(LegendOverlayTest, IsEmptyWithoutAScenarioAndWhereItIsHidden) {
  EXPECT_FALSE(legend.box().isEmpty());
  legend.hide();
  EXPECT_TRUE(legend.box().isEmpty());
  legend.show();
  view.setScenario(nullptr);
  EXPECT_TRUE(legend.box().isEmpty());
}

TEST_F(LegendOverlayTest, CoversNeitherTheCubeNorTheScaleAtAnySizeOfTextAndScene) {
  showRun();
  for (const int pixels : {10, 16, 24, 32}) {
    QFont font = legend.font();
    font.setPixelSize(pixels);
    legend.setFont(font);
    for (const QSize size : {QSize(320, 240), QSize(640, 360), QSize(1280, 720), QSize(2000, 300)}) {
      scene.resize(size);
      const QRect box = legend.box();
      EXPECT_FALSE(box.intersects(cube.geometry())) << pixels << " " << size.width();
      EXPECT_FALSE(box.intersects(scale.geometry())) << pixels << " " << size.width();
      EXPECT_TRUE(box.isEmpty() || scene.rect().contains(box)) << pixels << " " << size.width();
    }
  }
}

TEST(LabelPlacement, KeepsWhatIsCoveredFree) {
  const QRectF legend(0, 0, 100, 100);
  const auto places = placeLabels({{QRectF(90, 90, 40, 20), false, false}}, legend);
  ASSERT_TRUE(places[0]);
  EXPECT_FALSE(places[0]->intersects(legend));
}

/// Radius of the drawn node.
double reachOf(const osg::Node* node) { return node == nullptr ? 0.0 : node->getBound().radius(); }

TEST(OperatorMarks, FollowTheObjectAndNeverFillTheView) {
  SessionSnapshot snapshot;
  snapshot.device.nearest.body = 0;
  snapshot.device.nearest.distance = 1e-3;
  snapshot.device.nearest.p_WPn = Vector3(0.0, 0.0, 1e-3);
  snapshot.device.guidance.force_W = Vector3::UnitX();
  const ScenePalette palette = paletteOf(Theme::Light);
  for (const double radius : {0.005, 0.05, 5.0}) {
    for (const double view : {0.05, 1.0, 100.0}) {
      const MarkScale scale{radius, view};
      const double disc = reachOf(makeContact(snapshot, scale, palette));
      const double arrow = reachOf(makeGuidance(snapshot.device, scale, palette));
      for (const double reach : {disc, arrow}) {
        EXPECT_LT(reach, 0.2 * view) << radius << " " << view;
        EXPECT_LT(reach, 3.0 * radius + 2e-3) << radius << " " << view;
        EXPECT_GT(reach, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace glissade
