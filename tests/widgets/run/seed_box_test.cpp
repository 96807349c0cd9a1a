#include "widgets/run/seed_box.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest>

#include <limits>

namespace glissade {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

TEST(SeedBox, HoldsEverySeed) {
  SeedBox box;
  QSignalSpy chosen(&box, &SeedBox::seedChosen);
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1} << 31U, std::uint64_t{1} << 63U, kLargest}) {
    box.setSeed(seed);
    EXPECT_EQ(box.seed(), seed);
    EXPECT_EQ(box.text(), QString::number(static_cast<qulonglong>(seed)));
  }
  EXPECT_TRUE(chosen.isEmpty());
}

TEST(SeedBox, IsTypedAndStepped) {
  SeedBox box;
  QSignalSpy chosen(&box, &SeedBox::seedChosen);
  box.selectAll();
  QTest::keyClicks(&box, QStringLiteral("4294967296123"));
  EXPECT_EQ(box.seed(), 4294967296123U);
  EXPECT_EQ(chosen.last().first().toULongLong(), 4294967296123U);
  QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_EQ(box.seed(), 4294967296124U);
  QTest::keyClick(&box, Qt::Key_PageDown);
  EXPECT_EQ(box.seed(), 4294967296114U);
}

TEST(SeedBox, StaysInItsRange) {
  SeedBox box;
  box.setSeed(kLargest - 3);
  box.stepBy(10);
  EXPECT_EQ(box.seed(), kLargest);
  box.setSeed(3);
  box.stepBy(-10);
  EXPECT_EQ(box.seed(), 0U);
  int position = 0;
  for (const char* bad : {"-1", "1.5", "18446744073709551616", "x"}) {
    QString text = QLatin1String(bad);
    EXPECT_EQ(box.validate(text, position), QValidator::Invalid) << bad;
  }
}

}  // namespace
}  // namespace glissade
