#include "widgets/product/placement_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QLayout>
#include <QVector>
#include <QtTest/QTest>

#include <utility>

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

TEST_F(PlacementPanelTest, TheFieldsStayWhereTheyAreWhenABodyIsChosen) {
  panel.show(QString(), std::nullopt);
  panel.resize(300, panel.sizeHint().height());
  panel.layout()->activate();
  const int height = panel.sizeHint().height();
  const QPoint before = box("place-x").pos();
  panel.show(QStringLiteral("part"), Pose::identity());
  panel.layout()->activate();
  EXPECT_EQ(panel.sizeHint().height(), height);
  EXPECT_EQ(box("place-x").pos(), before);
}

TEST_F(PlacementPanelTest, UndoInAFieldIsThatOfTheDocument) {
  QAction undo;
  undo.setShortcut(QKeySequence::Undo);
  panel.addAction(&undo);
  int undone = 0;
  QObject::connect(&undo, &QAction::triggered, [&undone] { ++undone; });
  panel.show(QStringLiteral("part"), Pose::identity());
  panel.setVisible(true);
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  box("place-x").setFocus();
  QTest::keyClicks(&box("place-x"), QStringLiteral("5"));
  QTest::keyClick(&box("place-x"), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(undone, 1);
}

TEST_F(PlacementPanelTest, OnlyTheNumberThatIsChangedChanges) {
  // The numbers have more digits than the panel shows.
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
  const Pose before{Vector3(0.1, 0.2, 0.3), fromRollPitchYaw(0.0, 0.0, std::acos(0.0))};  // a quarter turn about z
  const PlacementPoints points{Vector3(-0.01, 0, 0), Vector3(0, 0.04, 0)};
  panel.show(QStringLiteral("part"), before, points);
  auto& about = *panel.findChild<QComboBox*>(QStringLiteral("place-about"));
  EXPECT_TRUE(about.isEnabled());
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
  EXPECT_FALSE(about.isEnabled());
}

/// The person places the axis or the face of a part.
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

/// Writes over the box's text as a person does, with Enter at the end.
void write(QDoubleSpinBox& box, const QString& text) {
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, text);
  QTest::keyClick(&box, Qt::Key_Return);
}

TEST_F(PlacementPanelTest, NumbersAreWrittenInAnyUnit) {
  panel.show(QStringLiteral("part"), Pose{});
  const auto expectX = [&](const char* text, double metres) {
    write(box("place-x"), QString::fromUtf8(text));
    ASSERT_FALSE(placed.isEmpty()) << text;
    EXPECT_DOUBLE_EQ(placed.back().position.x(), metres) << text;
    EXPECT_TRUE(panel.findChild<QLabel*>(QStringLiteral("place-refused"))->isHidden());
  };
  expectX("25.4 mm", 0.0254);
  expectX("2 in", 0.0508);
  expectX("0.5\"", 0.0127);
  expectX("7", 0.007);
  expectX("-1.5cm", -0.015);
  write(box("turn-z"), QStringLiteral("0.1 rad"));
  EXPECT_NEAR(rollPitchYawOf(placed.back().orientation).z(), 0.1, 1e-12) << "not only the digits that are shown";
  write(box("turn-z"), QStringLiteral("30 deg"));
  EXPECT_NEAR(rollPitchYawOf(placed.back().orientation).z(), std::acos(0.0) / 3.0, 1e-12);
}

TEST_F(PlacementPanelTest, WhatCannotBeReadIsRefusedVisiblyAndChangesNothing) {
  const Pose before{Vector3(1.0 / 3.0, 0, 0), fromRollPitchYaw(0.0, 0.0, 0.3)};
  panel.show(QStringLiteral("part"), before);
  const QLabel& refused = *panel.findChild<QLabel*>(QStringLiteral("place-refused"));
  panel.resize(330, panel.sizeHint().height());
  const auto layOut = [&] {
    panel.layout()->activate();
    return std::pair(panel.sizeHint().height(), box("place-x").pos());
  };
  const auto placesBefore = layOut();
  for (const char* text : {"12 mn", "abc", "3 deg", "2000 m"}) {
    write(box("place-x"), QString::fromUtf8(text));
    EXPECT_TRUE(placed.isEmpty()) << text;
    EXPECT_FALSE(refused.isHidden()) << text;
    EXPECT_TRUE(refused.toolTip().contains(QString::fromUtf8(text))) << refused.toolTip().toStdString();
    EXPECT_TRUE(refused.text().contains(QString::fromUtf8(text))) << refused.text().toStdString();
    EXPECT_EQ(layOut(), placesBefore) << "no field moves";
    EXPECT_EQ(box("place-x").text(), QStringLiteral("333.33"));
  }
  write(box("turn-z"), QStringLiteral("1 mm"));
  EXPECT_TRUE(placed.isEmpty());
  write(box("place-x"), box("place-x").text());
  EXPECT_TRUE(placed.isEmpty()) << "the digits that are shown are the number that is there";
  write(box("place-x"), QStringLiteral("1 in"));
  EXPECT_EQ(placed.size(), 1);
  EXPECT_TRUE(refused.isHidden());
}

TEST(QuantityBox, ReadsTheDecimalSignOfTheUserAndAPoint) {
  QuantityBox box(QuantityBox::Quantity::Length, nullptr);
  box.setLocale(QLocale(QLocale::French));
  box.setRange(-1e6, 1e6);
  box.setSuffix(QStringLiteral(" mm"));
  box.setValue(1234.5);
  EXPECT_EQ(box.text(), QStringLiteral("1234,50 mm"));
  write(box, QStringLiteral("25,4 mm"));
  EXPECT_DOUBLE_EQ(box.value(), 25.4);
  write(box, QStringLiteral("1.5 in"));
  EXPECT_DOUBLE_EQ(box.value(), 38.1);
  write(box, QStringLiteral("-3"));
  EXPECT_DOUBLE_EQ(box.value(), -3.0);
}

}  // namespace
}  // namespace glissade
