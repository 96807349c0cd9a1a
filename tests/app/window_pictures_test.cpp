// The whole window without a display, run as its user would, against golden pictures.
// To make the pictures anew after a wanted change: GLISSADE_UPDATE_GOLDEN=1 ctest -R WindowPictures
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdlib>

namespace {

const QString kSource = QStringLiteral(GLISSADE_SOURCE_DIR);

struct Difference {
  double mean = 0.0;   ///< of all channels, 0...255
  double share = 0.0;  ///< of pixels that differ visibly
};

Difference difference(const QImage& a, const QImage& b) {
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

struct Outcome {
  int exitCode = -1;
  QString errors;
};

class WindowPictures : public testing::Test {
 protected:
  Outcome run(const QString& scenario, const QString& script, const QStringList& options = {}) {
    QFile file(folder.filePath(QStringLiteral("test.script")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(script.toUtf8());
    file.close();
    QStringList arguments{QStringLiteral("--script"), file.fileName(), QStringLiteral("--size"),
                          QStringLiteral("1280x720")};
    if (!scenario.isEmpty())
      arguments << kSource + QStringLiteral("/samples/") + scenario + QStringLiteral("/scenario.json");
    QProcess process;
    process.start(QStringLiteral(GLISSADE_BIN_DIR "/glissade-offscreen"), arguments + options);
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

TEST_F(WindowPictures, EverySampleIdleGrowingAndSolved) {
  for (const QString& sample :
       {QStringLiteral("environment-1"), QStringLiteral("environment-2"), QStringLiteral("sliding-plane")}) {
    const QString base = folder.filePath(sample);
    const QString growing = sample == QStringLiteral("sliding-plane") ? QStringLiteral("8") : QStringLiteral("300");
    QString script = QStringLiteral(
                         "screenshot %1-idle.png\nselect-operator expert\naction run.start\nsteps %2\n"
                         "screenshot %1-growing.png\nwait ended 24000\nexpect solved\n"
                         "screenshot %1-solved.png\n")
                         .arg(base, growing);
    const Outcome outcome = run(sample, script, {QStringLiteral("--seed"), QStringLiteral("3")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    for (const char* state : {"idle", "growing", "solved"}) {
      const QString name = sample + QStringLiteral("-") + QLatin1String(state);
      expectLike(folder.filePath(name + QStringLiteral(".png")), name);
    }
  }
}

TEST_F(WindowPictures, WelcomeAndDark) {
  const QString file = folder.filePath(QStringLiteral("welcome.png"));
  ASSERT_EQ(run(QString(), QStringLiteral("screenshot %1\n").arg(file)).exitCode, 0);
  expectLike(file, QStringLiteral("welcome"));
  ASSERT_EQ(
      run(QStringLiteral("environment-1"), QStringLiteral("action view.dark\nscreenshot %1\n").arg(file)).exitCode, 0);
  expectLike(file, QStringLiteral("environment-1-dark"));
}

TEST_F(WindowPictures, SteeringByKeysMovesTheObjectAndThePathIsExported) {
  const QString path = folder.filePath(QStringLiteral("path.csv"));
  const QString before = folder.filePath(QStringLiteral("before.png"));
  const QString after = folder.filePath(QStringLiteral("after.png"));
  const Outcome outcome = run(QStringLiteral("sliding-plane"),
                              QStringLiteral("screenshot %1\nkey press W\nsteps 60\nkey release W\nscreenshot %2\n"
                                             "set alpha 0.9\naction run.start\nwait solved 20000\nexport %3\n")
                                  .arg(before, after, path));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(difference(QImage(before), QImage(after)).mean, 0.2);
  QFile csv(path);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_TRUE(csv.readLine().startsWith("index,s,x,y,z"));
}

TEST_F(WindowPictures, ScriptsSayWhereTheyGoWrong) {
  const Outcome unknown = run(QStringLiteral("sliding-plane"), QStringLiteral("steps 1\naction no.such\n"));
  EXPECT_EQ(unknown.exitCode, 3);
  EXPECT_TRUE(unknown.errors.contains(QStringLiteral("line 2")));
  EXPECT_EQ(run(QStringLiteral("sliding-plane"), QStringLiteral("expect solved\n")).exitCode, 1);
}

TEST_F(WindowPictures, AMissingScenarioHasItsExitCode) {
  QProcess process;
  process.start(QStringLiteral(GLISSADE_BIN_DIR "/glissade-offscreen"),
                {QStringLiteral("nothing.json"), QStringLiteral("--offscreen")});
  ASSERT_TRUE(process.waitForFinished(60000));
  EXPECT_EQ(process.exitCode(), 3);
}

}  // namespace
