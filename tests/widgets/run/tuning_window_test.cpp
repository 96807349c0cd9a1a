// Scripts use automatic tuning in the window: it is switched on, parameters are taken back one by one and all together,
// and a run with tuning replays.
#include <QRegularExpression>

#include "tests/app/window_fixture.h"

namespace {

using namespace glissade::test;

class TuningWindow : public WindowTest {
 protected:
  void expectGood(const QString& script) {
    const WindowResult result = run(QStringLiteral("environment-1"), script);
    EXPECT_EQ(result.exitCode, 0) << result.errors.toStdString();
  }
  void expectBad(const QString& script) { EXPECT_NE(run(QStringLiteral("environment-1"), script).exitCode, 0); }
};

const QString kOwn = QStringLiteral("set alpha 0.37\nset contact_samples 9\nset contact_distance 0.25\n");
const QString kTunedRun =
    QStringLiteral("select-operator expert\naction run.tuning\nexpect-value tuning 7\naction run.start\nsteps 400\n");

TEST_F(TuningWindow, ParametersSetThemselves) {
  expectBad(kOwn + kTunedRun + QStringLiteral("expect-value alpha 0.37\n"));
  expectBad(kOwn + kTunedRun + QStringLiteral("expect-value contact_samples 9\n"));
  expectBad(kOwn + kTunedRun + QStringLiteral("expect-value contact_distance 0.25\n"));
}

TEST_F(TuningWindow, OneIsTakenBackByHandAndTheRestByTheSwitchWithTheUsersOwnValues) {
  expectGood(kOwn + kTunedRun +
             QStringLiteral("set contact_samples 4\nsteps 10\nexpect-value tuning 5\nexpect-value contact_samples 4\n"
                            "action run.tuning\nsteps 10\nexpect-value tuning 0\nexpect-value alpha 0.37\n"
                            "expect-value contact_samples 4\nexpect-value contact_distance 0.25\n"));
}

TEST_F(TuningWindow, ItsRunsReplayAndItIsKeptInFiles) {
  const QString record = folder.filePath(QStringLiteral("run.json"));
  const QString scenario = folder.filePath(QStringLiteral("tuned.json"));
  expectGood(kTunedRun + QStringLiteral("set alpha 0.3\nsteps 200\naction run.stop\nsave-recording %1\nreplay %1\n"
                                        "expect-replay same\naction replay.close\nsave %2\n")
                             .arg(record, scenario));
  QFile file(scenario);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(QString::fromUtf8(file.readAll()).contains(QRegularExpression(QStringLiteral("\"tuning\": 6"))));
}

}  // namespace
