// Compares pictures with those in tests/golden.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>

#include <algorithm>
#include <cstdlib>

#include "tests/engine/support/directories.h"

namespace glissade::test {

inline const QString kSource = QString::fromStdString(test::sourceDirectory());

struct Difference {
  double mean = 0.0;   ///< mean difference of all channels, 0...255
  double share = 0.0;  ///< share of the pixels that differ visibly
};

inline Difference difference(const QImage& a, const QImage& b) {
  constexpr int kVisible = 40;
  double sum = 0.0;
  int visible = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int most =
          std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      sum += most;
      visible += most > kVisible ? 1 : 0;
    }
  }
  const double pixels = static_cast<double>(a.width()) * a.height();
  return {sum / pixels, visible / pixels};
}

/// With GLISSADE_UPDATE_GOLDEN in the environment, `actual` becomes the golden picture of this name.
inline void expectLikeGolden(const QImage& actual, const QString& name) {
  const QString golden = kSource + QStringLiteral("/tests/golden/") + name + QStringLiteral(".png");
  if (qEnvironmentVariableIsSet("GLISSADE_UPDATE_GOLDEN")) {
    ASSERT_TRUE(actual.save(golden));
  }
  const QImage expected(golden);
  ASSERT_FALSE(expected.isNull()) << golden.toStdString();
  ASSERT_EQ(actual.size(), expected.size());
  const Difference found = difference(actual, expected);
  EXPECT_LT(found.mean, 4.0) << name.toStdString();
  EXPECT_LT(found.share, 0.04) << name.toStdString();
}

}  // namespace glissade::test
