#include "engine/base/parameters.h"

#include <gtest/gtest.h>

#include <limits>

namespace glissade {
namespace {

TEST(ParameterTable, OrderIsThatOfTheIds) {
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    EXPECT_EQ(static_cast<std::size_t>(parameterTable()[i].id), i);
  }
}

TEST(ParameterTable, DefaultsLieInTheirRangesForSmallAndLargeObjects) {
  for (const double radius : {1e-3, 1.5, 500.0}) {
    ParameterValues values(radius);
    for (const ParameterSpec& spec : parameterTable()) {
      EXPECT_TRUE(values.set(spec.id, values[spec.id])) << spec.key << " at r = " << radius;
    }
  }
}

TEST(ParameterTable, KeysAreFoundAgain) {
  for (const ParameterSpec& spec : parameterTable()) EXPECT_EQ(parameterByKey(spec.key), spec.id);
  EXPECT_FALSE(parameterByKey("alhpa"));
}

TEST(ParameterValues, RefusesWhatIsOutOfRangeAndKeepsTheOldValue) {
  ParameterValues values(1.0);
  const double before = values[ParameterId::Alpha];
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    const Outcome outcome = values.set(ParameterId::Alpha, bad);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().kind, ErrorKind::Usage);
    EXPECT_EQ(toString(outcome.error().location), "alpha");
  }
  EXPECT_EQ(values[ParameterId::Alpha], before);
}

TEST(ParameterValues, RefusesAFractionWhereAWholeNumberIsAsked) {
  ParameterValues values(1.0);
  EXPECT_FALSE(values.set(ParameterId::ContactSamples, 2.5));
  EXPECT_TRUE(values.set(ParameterId::ContactSamples, 7));
  EXPECT_EQ(values.integer(ParameterId::ContactSamples), 7);
}

TEST(ParameterValues, LengthsScaleWithTheObject) {
  EXPECT_DOUBLE_EQ(ParameterValues(2.0)[ParameterId::ContactDistance],
                   2.0 * ParameterValues(1.0)[ParameterId::ContactDistance]);
  EXPECT_DOUBLE_EQ(ParameterValues(2.0)[ParameterId::Alpha], ParameterValues(1.0)[ParameterId::Alpha]);
}

TEST(ParameterValues, TheUsualRequiredClearanceIsARoundNumberBelowItsShareOfTheRadius) {
  const auto usual = [](double radius) { return ParameterValues(radius)[ParameterId::RequiredClearance]; };
  EXPECT_DOUBLE_EQ(usual(0.0126), 1e-7);
  EXPECT_DOUBLE_EQ(usual(0.0032), 2e-8);
  EXPECT_DOUBLE_EQ(usual(0.1), 1e-6);
  EXPECT_DOUBLE_EQ(usual(1.49), 1e-5);
  for (double radius = 1e-3; radius < 1e3; radius *= 1.37) {
    EXPECT_LE(usual(radius), 1.0000001e-5 * radius);
    EXPECT_GT(usual(radius), 0.39e-5 * radius);
  }
}

}  // namespace
}  // namespace glissade
