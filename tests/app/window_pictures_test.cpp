// Compares pictures of the whole window without a display, run as a user would, with golden pictures. After an intended
// change, GLISSADE_UPDATE_GOLDEN=1 ctest -R WindowPictures writes them again.
#include "tests/app/window_fixture.h"
#include "tests/engine/support/directories.h"

namespace {

using namespace glissade::test;

class WindowPictures : public WindowTest {};

TEST_F(WindowPictures, EverySampleIdleGrowingAndSolved) {
  for (const QString& sample :
       {QStringLiteral("environment-1"), QStringLiteral("environment-2"), QStringLiteral("sliding-plane")}) {
    const QString base = folder.filePath(sample);
    // The steps are divided into several parts, so that the curves of the run have as many points.
    const QString growing = sample == QStringLiteral("sliding-plane") ? QStringLiteral("steps 1\n").repeated(8)
                                                                      : QStringLiteral("steps 30\n").repeated(10);
    QString script = QStringLiteral(
                         "screenshot %1-idle.png\nselect-operator expert\naction run.start\n%2"
                         "screenshot %1-growing.png\nwait ended 24000\nexpect solved\n"
                         "screenshot %1-solved.png\n")
                         .arg(base, growing);
    const WindowResult outcome = run(sample, script, {QStringLiteral("--seed"), QStringLiteral("6")});
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
  const WindowResult outcome = run(QStringLiteral("sliding-plane"),
                                   QStringLiteral("screenshot %1\nkey press W\nsteps 60\nkey release W\nscreenshot %2\n"
                                                  "set alpha 0.9\naction run.start\nwait solved 20000\nexport %3\n")
                                       .arg(before, after, path));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_GT(difference(QImage(before), QImage(after)).mean, 0.2);
  QFile csv(path);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_TRUE(csv.readLine().startsWith("index,s,x,y,z"));
}

TEST_F(WindowPictures, ThePathIsSmoothedAndShownAsPlannedAgain) {
  const auto read = [this](const char* name) {
    QFile file(folder.filePath(QLatin1String(name)));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  const WindowResult outcome =
      run(QStringLiteral("environment-1"),
          QStringLiteral("set required_clearance 0.0004\nselect-operator expert\naction run.start\nwait solved 24000\n"
                         "export %1/a.csv\naction path.smooth\nsteps 1\nexport %1/b.csv\n"
                         "screenshot %1/smooth.png\naction path.smooth\nsteps 1\nexport %1/c.csv\n")
              .arg(folder.path()));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_EQ(read("a.csv"), read("c.csv"));
  EXPECT_LT(read("b.csv").count('\n'), read("a.csv").count('\n'));
}

TEST_F(WindowPictures, ScriptsSayWhereTheyGoWrong) {
  const WindowResult unknown = run(QStringLiteral("sliding-plane"), QStringLiteral("steps 1\naction no.such\n"));
  EXPECT_EQ(unknown.exitCode, 3);
  EXPECT_TRUE(unknown.errors.contains(QStringLiteral("line 2")));
  EXPECT_EQ(run(QStringLiteral("sliding-plane"), QStringLiteral("expect solved\n")).exitCode, 1);
}

TEST_F(WindowPictures, AMissingScenarioHasItsExitCode) {
  QProcess process;
  process.start(QString::fromStdString(programDirectory() + "/glissade-offscreen"),
                {QStringLiteral("nothing.json"), QStringLiteral("--offscreen")});
  ASSERT_TRUE(process.waitForFinished(60000));
  EXPECT_EQ(process.exitCode(), 3);
}

}  // namespace
