#include "widgets/openxr/picture_rate.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

constexpr double kInTime = 1.0 / 90.0;
constexpr double kLate = 1.0 / 45.0;

class PictureRateTest : public testing::Test {
 protected:
  PictureRateTest() { rate_.advance(now_, period_); }

  /// Shows this number of pictures, each this many seconds after the one before.
  void show(int pictures, double seconds) {
    for (int i = 0; i < pictures; ++i) {
      now_ += std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
      rate_.advance(now_, period_);
    }
  }
  /// Shows a scene that can be drawn in time from this step on.
  void showSceneThatNeeds(int step, int pictures) {
    for (int i = 0; i < pictures; ++i) show(1, rate_.step() < step ? kLate : kInTime);
  }

  PictureRate rate_;
  std::chrono::nanoseconds now_{0};
  std::chrono::nanoseconds period_{11'111'111};
};

TEST_F(PictureRateTest, PicturesInTimeAreInFullDetail) {
  show(10000, kInTime);
  EXPECT_EQ(rate_.step(), 0);
  show(1000, 1.0 / 72.0);
  EXPECT_EQ(rate_.step(), 0);
}

TEST_F(PictureRateTest, LatePicturesMakeTheSceneSimplerStepByStep) {
  EyeDetail before = rate_.detail();
  for (int step = 1; step < PictureRate::kSteps; ++step) {
    show(4, kLate);
    ASSERT_EQ(rate_.step(), step);
    EXPECT_GE(rate_.detail().tolerance, before.tolerance);
    EXPECT_GT(rate_.detail().tolerance + rate_.detail().leastBody, before.tolerance + before.leastBody);
    before = rate_.detail();
  }
  show(100, kLate);
  EXPECT_EQ(rate_.step(), PictureRate::kSteps - 1);
}

TEST_F(PictureRateTest, AStallIsNoReason) {
  for (int i = 0; i < 20; ++i) {
    show(1, 2.0);
    show(100, kInTime);
  }
  EXPECT_EQ(rate_.step(), 0);
}

TEST_F(PictureRateTest, WhenThereIsTimeDetailComesBack) {
  show(8, kLate);
  ASSERT_EQ(rate_.step(), 2);
  show(PictureRate::kPatience - 1, kInTime);
  EXPECT_EQ(rate_.step(), 2);
  show(2 * PictureRate::kPatience, kInTime);
  EXPECT_EQ(rate_.step(), 0);
}

TEST_F(PictureRateTest, AFinerStepThatWasTooMuchIsTriedMoreAndMoreSeldom) {
  int changes = 0;
  const auto changesIn = [&](int pictures) {
    int found = 0;
    for (int i = 0; i < pictures; ++i) {
      const int before = rate_.step();
      showSceneThatNeeds(2, 1);
      found += rate_.step() == before ? 0 : 1;
    }
    return found;
  };
  changesIn(100);
  ASSERT_EQ(rate_.step(), 2);
  changes = changesIn(5000);
  EXPECT_GT(changes, 0);
  EXPECT_LT(changesIn(5000), changes);
  EXPECT_EQ(rate_.step(), 2);
}

TEST_F(PictureRateTest, ADisplayOfFewerPicturesIsInTimeWithThese) {
  period_ = std::chrono::nanoseconds(16'666'667);
  show(100, 1.0 / 60.0);
  EXPECT_EQ(rate_.step(), 0);
  show(100, 1.0 / 30.0);
  EXPECT_GT(rate_.step(), 0);
}

TEST_F(PictureRateTest, APauseIsNotLate) {
  for (int i = 0; i < 20; ++i) {
    show(1, kInTime);
    rate_.interrupt();
    now_ += std::chrono::seconds(1);
    rate_.advance(now_, period_);
  }
  EXPECT_EQ(rate_.step(), 0);
}

}  // namespace
}  // namespace glissade
