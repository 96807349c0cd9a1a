#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdlib>

#include "tests/engine/support/directories.h"

namespace glissade::test {

inline const QString kSource = QString::fromStdString(test::sourceDirectory());

struct Difference {
  double mean = 0.0;   ///< of all channels, 0...255
  double share = 0.0;  ///< of pixels that differ visibly
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

struct WindowResult {
  int exitCode = -1;
  QString errors;
};

class WindowTest : public testing::Test {
 protected:
  /// Runs the window on a sample, or on a scenario file (ending in .json), with a script.
  WindowResult run(const QString& scenario, const QString& script, const QStringList& options = {}) {
    QFile file(folder.filePath(QStringLiteral("test.script")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(script.toUtf8());
    file.close();
    QStringList arguments{QStringLiteral("--script"), file.fileName(), QStringLiteral("--size"),
                          QStringLiteral("1280x720")};
    if (scenario.endsWith(QStringLiteral(".json"))) {
      arguments << scenario;
    } else if (!scenario.isEmpty()) {
      arguments << kSource + QStringLiteral("/samples/") + scenario + QStringLiteral("/scenario.json");
    }
    QProcess process;
    // The user's own settings stay out of it.
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.path());
    process.setProcessEnvironment(environment);
    process.start(QString::fromStdString(test::programDirectory() + "/glissade-offscreen"), arguments + options);
    EXPECT_TRUE(process.waitForFinished(120000));
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
  }

  void expectLike(const QString& picture, const QString& name) {
    const QString golden = kSource + QStringLiteral("/tests/golden/") + name + QStringLiteral(".png");
    if (qEnvironmentVariableIsSet("GLISSADE_UPDATE_GOLDEN")) {
      QFile::remove(golden);
      ASSERT_TRUE(QFile::copy(picture, golden));
    }
    const QImage expected(golden);
    const QImage actual(picture);
    ASSERT_FALSE(expected.isNull()) << golden.toStdString();
    ASSERT_EQ(actual.size(), expected.size());
    const Difference found = difference(actual, expected);
    EXPECT_LT(found.mean, 4.0) << name.toStdString();
    EXPECT_LT(found.share, 0.04) << name.toStdString();
  }

  QTemporaryDir folder;
};

}  // namespace glissade::test
