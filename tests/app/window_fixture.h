#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "tests/app/golden_picture.h"
#include "tests/engine/support/directories.h"

namespace glissade::test {

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
    // The program must not read the user's own settings.
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.path());
    process.setProcessEnvironment(environment);
    process.start(QString::fromStdString(test::programDirectory() + "/glissade-offscreen"), arguments + options);
    EXPECT_TRUE(process.waitForFinished(120000));
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
  }

  void expectLike(const QString& picture, const QString& name) { expectLikeGolden(QImage(picture), name); }

  QTemporaryDir folder;
};

}  // namespace glissade::test
