#include "widgets/paths/path_panel.h"
#include "tests/engine/support/directories.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "app/window/window_actions.h"
#include "engine/files/scenario_io.h"

namespace glissade {
namespace {

class PathPanelTest : public testing::Test {
 protected:
  PathPanelTest() {
    auto loaded = loadScenario(test::sourceDirectory() + "/samples/sliding-plane/scenario.json");
    scenario = std::move(*loaded);
    scenario.obstacles[1].label = "Cover <11 kW>";
  }

  /// A path of a metre along x, blocked half way along the second of its two edges.
  std::shared_ptr<const PathExamination> refused() const {
    PathExamination examined;
    for (const double x : {0.0, 0.5, 1.0}) examined.path.points.push_back({Pose::translation({x, 0.0, 0.0})});
    examined.ends = {true, false};
    BlockedEdge blocked;
    blocked.edge = 1;
    blocked.at = 0.5;
    blocked.nearest.body = 1;
    examined.blocked = {blocked};
    return std::make_shared<const PathExamination>(examined);
  }
  QString text() const { return panel.findChild<QLabel*>(QStringLiteral("certificate"))->text(); }

  ActionCatalogue actions{windowActions(), nullptr};
  PathPanel panel{actions};
  LoadedScenario scenario;
};

TEST_F(PathPanelTest, ARefusedPathSaysWhyAndByWhatItIsBlocked) {
  panel.setPath(nullptr, refused(), scenario);
  EXPECT_TRUE(text().contains(QStringLiteral("no longer valid"))) << text().toStdString();
  EXPECT_FALSE(text().contains(QStringLiteral("starts at the start pose"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("ends at the goal pose"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("1 of 2 edges"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("75 % by Cover &lt;11 kW&gt;"))) << text().toStdString();
  panel.setPath(nullptr, nullptr, scenario);
  EXPECT_EQ(text(), QStringLiteral("No path yet."));
}

TEST_F(PathPanelTest, TheObjectIsShownWhereThePathIsBlockedFirst) {
  panel.setPath(nullptr, refused(), scenario);
  std::optional<Pose> shown;
  QObject::connect(&panel, &PathPanel::poseShown, [&](const std::optional<Pose>& pose) { shown = pose; });
  panel.showFirstBlocked();
  ASSERT_TRUE(shown);
  EXPECT_NEAR(shown->position.x(), 0.75, 1e-3);
}

/// The object is at 0 % again, as are the slider, the cursor of the curve and its text.
TEST_F(PathPanelTest, ANewPathIsShownFromItsBeginning) {
  const auto profile = [](int atBegin, int atEnd) {
    auto measured = std::make_shared<ClearanceProfile>();
    for (const double share : {0.0, 1.0}) {
      ClearanceSample sample;
      sample.share = share;
      sample.nearest.body = share == 0.0 ? atBegin : atEnd;
      sample.nearest.distance = 0.01;
      measured->samples.push_back(sample);
    }
    return measured;
  };
  auto path = std::make_shared<Path>();
  path->points = refused()->path.points;
  const auto* curve = panel.findChild<ClearanceCurve*>();
  panel.setPath(path, nullptr, scenario);
  panel.setProfile(profile(0, 1), scenario);
  panel.showAt(1.0);
  EXPECT_TRUE(curve->accessibleDescription().contains(QStringLiteral("Cover")));
  panel.setPath(std::make_shared<Path>(*path), nullptr, scenario);
  EXPECT_EQ(curve->accessibleDescription(), QString()) << "nothing is known of the new path";
  panel.setProfile(profile(0, 1), scenario);
  EXPECT_EQ(panel.slider().share(), 0.0);
  EXPECT_FALSE(curve->accessibleDescription().contains(QStringLiteral("Cover")));
}

TEST_F(PathPanelTest, ACertificateAboutTrianglesSaysByHowMuchSurfacesMayBeNearer) {
  auto path = std::make_shared<Path>();
  path->points = refused()->path.points;
  path->certificate.nearest.body = 1;
  panel.setPath(path, nullptr, scenario);
  EXPECT_TRUE(text().contains(QStringLiteral("Cover &lt;11 kW&gt;"))) << text().toStdString();
  EXPECT_FALSE(text().contains(QStringLiteral("CAD accuracy"))) << text().toStdString();
  scenario.deflections = {{scenario.object.id, 1e-4}, {"a", 2e-4}, {"b", 5e-5}};
  panel.setPath(std::make_shared<Path>(*path), nullptr, scenario);
  EXPECT_TRUE(text().contains(QStringLiteral("CAD accuracy ± 0.300 mm"))) << text().toStdString();
  EXPECT_FALSE(text().contains(QStringLiteral("32-bit"))) << text().toStdString();
  scenario.coordinateSpacings = {{scenario.object.id, 1e-6}, {"a", 2e-6}};
  panel.setPath(std::make_shared<Path>(*path), nullptr, scenario);
  EXPECT_TRUE(text().contains(QStringLiteral("3.00 µm nearer"))) << text().toStdString();
}

}  // namespace
}  // namespace glissade
