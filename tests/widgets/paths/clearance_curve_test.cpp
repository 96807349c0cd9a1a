#include "widgets/paths/clearance_curve.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QMouseEvent>
#include <QSignalSpy>

#include <cmath>

namespace glissade {
namespace {

std::shared_ptr<const ClearanceProfile> narrowInTheMiddle() {
  auto profile = std::make_shared<ClearanceProfile>();
  for (int i = 0; i <= 100; ++i) {
    ClearanceSample sample;
    sample.share = 0.01 * i;
    sample.nearest.body = i < 50 ? 0 : 1;
    sample.nearest.distance = 1e-5 + 1e-2 * std::abs(sample.share - 0.5);
    profile->samples.push_back(sample);
  }
  return profile;
}

class ClearanceCurveTest : public ::testing::Test {
 protected:
  ClearanceCurveTest() {
    curve.resize(300, 100);
    curve.setProfile(narrowInTheMiddle(), {QStringLiteral("left"), QStringLiteral("right")}, 1e-4);
  }

  void press(double x) {
    QMouseEvent event(QEvent::MouseButtonPress, QPointF(x, 60.0), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&curve, &event);
  }

  ClearanceCurve curve;
};

TEST_F(ClearanceCurveTest, SaysDistanceAndBodyOfThePlaceThatIsShown) {
  curve.setPlace(0.5);
  EXPECT_TRUE(curve.accessibleDescription().contains(QStringLiteral("right")));
  curve.setPlace(0.1);
  EXPECT_TRUE(curve.accessibleDescription().contains(QStringLiteral("left")));
}

TEST_F(ClearanceCurveTest, LengthsAreInTheUnitOfItsAxis) {
  QLocale::setDefault(QLocale::c());
  setLengthUnit(LengthUnit::Metres);
  curve.setPlace(0.0);
  EXPECT_EQ(curve.accessibleDescription(), QStringLiteral("5.01 mm to left"));
  curve.setPlace(0.5);
  EXPECT_EQ(curve.accessibleDescription(), QStringLiteral("0.0100 mm to right"));
  setLengthUnit(LengthUnit::Millimetres);
}

TEST_F(ClearanceCurveTest, AClickChoosesThePlaceUnderIt) {
  QSignalSpy chosen(&curve, &ClearanceCurve::placeChosen);
  press(299.0);
  press(0.0);
  ASSERT_EQ(chosen.size(), 2);
  EXPECT_NEAR(chosen[0][0].toDouble(), 1.0, 0.01);
  EXPECT_EQ(chosen[1][0].toDouble(), 0.0);
}

TEST_F(ClearanceCurveTest, IsDrawnWithAndWithoutAProfile) {
  const QImage with = curve.grab().toImage();
  curve.setProfile(nullptr, {}, 0.0);
  const QImage without = curve.grab().toImage();
  EXPECT_NE(with, without);
  press(100.0);
  EXPECT_FALSE(curve.profile());
}

}  // namespace
}  // namespace glissade
