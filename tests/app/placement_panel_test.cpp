#include "widgets/panels/placement_panel.h"

#include <gtest/gtest.h>

#include <QVector>

namespace glissade {
namespace {

class PlacementPanelTest : public testing::Test {
 protected:
  PlacementPanelTest() {
    QObject::connect(&panel, &PlacementPanel::placed, [this](const Pose& X_WB) { placed.push_back(X_WB); });
  }
  QDoubleSpinBox& box(const char* name) { return *panel.findChild<QDoubleSpinBox*>(QLatin1String(name)); }

  PlacementPanel panel;
  QVector<Pose> placed;
};

TEST_F(PlacementPanelTest, ShowsMillimetresAndDegreesAndAnnouncesNothingItself) {
  panel.show(QStringLiteral("part"), Pose{Vector3(0.0125, -2.0, 3.0), fromRollPitchYaw(0.0, 0.0, -std::acos(0.0) / 3)});
  EXPECT_EQ(box("place-x").value(), 12.5);
  EXPECT_EQ(box("place-y").value(), -2000.0);
  EXPECT_EQ(box("turn-x").value(), 0.0);
  EXPECT_EQ(box("turn-z").value(), -30.0);
  EXPECT_TRUE(box("turn-z").isEnabled());
  panel.show(QString(), std::nullopt);
  EXPECT_FALSE(box("place-x").isEnabled());
  EXPECT_TRUE(placed.isEmpty());
}

TEST_F(PlacementPanelTest, OnlyTheNumberThatIsChangedChanges) {
  // More digits than are shown.
  const Pose before{Vector3(1.0 / 3.0, 2.0 / 3.0, 1.0 / 7.0), fromRollPitchYaw(0.1, 0.2, 0.3)};
  panel.show(QStringLiteral("part"), before);
  box("place-y").setValue(500.0);
  ASSERT_EQ(placed.size(), 1);
  EXPECT_EQ(placed.back().position, Vector3(1.0 / 3.0, 0.5, 1.0 / 7.0));
  EXPECT_EQ(placed.back().orientation.coeffs(), before.orientation.coeffs());
  box("turn-z").setValue(0.0);
  ASSERT_EQ(placed.size(), 2);
  EXPECT_LT(angleBetween(placed.back().orientation, fromRollPitchYaw(0.1, 0.2, 0.0)), 1e-6);
  EXPECT_EQ(placed.back().position, Vector3(1.0 / 3.0, 0.5, 1.0 / 7.0));
}

TEST_F(PlacementPanelTest, NumbersAreAboutThePointThatIsChosen) {
  const Pose before{Vector3(0.1, 0.2, 0.3), fromRollPitchYaw(0.0, 0.0, std::acos(0.0))};  // a quarter about z
  const PlacementPoints points{Vector3(-0.01, 0, 0), Vector3(0, 0.04, 0)};
  panel.show(QStringLiteral("part"), before, points);
  auto& about = *panel.findChild<QComboBox*>(QStringLiteral("place-about"));
  EXPECT_FALSE(about.isHidden());
  EXPECT_NEAR(box("place-y").value(), 190.0, 1e-9) << "the origin of the file";
  about.setCurrentIndex(about.findText(QStringLiteral("Middle")));
  EXPECT_NEAR(box("place-x").value(), 60.0, 1e-9);
  EXPECT_TRUE(placed.isEmpty()) << "nothing has moved";
  box("place-x").setValue(0.0);
  EXPECT_TRUE((placed.back() * points.middle).isApprox(Vector3(0, 0.2, 0.3), 1e-12));
  box("turn-z").setValue(0.0);
  EXPECT_TRUE((placed.back() * points.middle).isApprox(Vector3(0, 0.2, 0.3), 1e-12)) << "it turns about its middle";
  about.setCurrentIndex(about.findText(QStringLiteral("Reference point")));
  EXPECT_NEAR(box("place-y").value(), 160.0, 1e-9);
  panel.show(QString(), std::nullopt);
  EXPECT_TRUE(about.isHidden());
}

/// A part is put where its axis or its face is to lie.
TEST_F(PlacementPanelTest, APickedFrameIsPlacedByPositionAndTurn) {
  const Pose before{Vector3(0.1, 0.2, 0.3), fromRollPitchYaw(0.2, -0.3, 0.4)};
  PlacementPoints points;
  panel.show(QStringLiteral("part"), before, points);
  auto& about = *panel.findChild<QComboBox*>(QStringLiteral("place-about"));
  EXPECT_LT(about.findText(QStringLiteral("Picked face or axis")), 0);
  points.picked = Pose{Vector3(0.01, 0.02, -0.03), fromRollPitchYaw(0.5, 0.1, -0.2)};
  panel.show(QStringLiteral("part"), before, points);
  EXPECT_EQ(panel.chosenPoint(), QStringLiteral("Picked face or axis"));
  EXPECT_NEAR(box("place-x").value(), 1e3 * (before * points.picked->position).x(), 0.006);
  EXPECT_TRUE(placed.isEmpty()) << "nothing has moved";
  for (const char* name : {"turn-x", "turn-y", "turn-z", "place-x", "place-y", "place-z"}) {
    box(name).setValue(box(name).value() + 1.0);
    box(name).setValue(0.0);
    panel.show(QStringLiteral("part"), placed.back(), points);
  }
  const Pose X_WF = placed.back() * *points.picked;
  EXPECT_LT(X_WF.position.norm(), 1e-9);
  EXPECT_LT(angleBetween(X_WF.orientation, Quaternion::Identity()), 1e-7);
  panel.show(QStringLiteral("other"), before);
  EXPECT_EQ(panel.chosenPoint(), QStringLiteral("Origin of the file"));
}

}  // namespace
}  // namespace glissade
