#include "widgets/document/run_recorder.h"
#include "tests/engine/support/directories.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <functional>

#include "engine/files/scenario_io.h"
#include "engine/session/run_comparison.h"
#include "widgets/document/replay_runner.h"

namespace glissade {
namespace {

ScenarioPtr closedScenario() {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/environment-2/scenario.json");
  return std::make_shared<const LoadedScenario>(std::move(*loaded));
}

/// Runs the event loop until the condition holds, for at most 30 seconds.
bool until(const std::function<bool()>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < 30000) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  return condition();
}

TEST(RunRecorder, AKilledProgramLeavesAJournalThatReplays) {
  const QTemporaryDir folder;
  const std::string recordings = folder.filePath(QStringLiteral("recordings")).toStdString();
  const ScenarioPtr scenario = closedScenario();
  std::string kept;
  {
    SessionBridge bridge(SessionClock::RealTime);
    RunRecorder recorder;
    recorder.keepJournals(recordings);
    QObject::connect(&bridge, &SessionBridge::snapshotChanged,
                     [&](const SnapshotPtr& snapshot) { recorder.follow(*snapshot); });
    recorder.open(scenario);
    bridge.open(scenario);
    bridge.setDevice("novice");
    bridge.post(command::Start{});
    // A log of more than two parts means that more than a second of it is on disk.
    ASSERT_TRUE(until([&] { return bridge.snapshot()->log.size() > 2; }));
    recorder.waitUntilJournalled();
    ASSERT_FALSE(recorder.trouble());
    EXPECT_TRUE(abandonedJournals(recordings).empty());
    // A program that was killed now would leave this file.
    const QStringList files = QDir(QString::fromStdString(recordings)).entryList(QDir::Files);
    ASSERT_EQ(files.size(), 1);
    kept = folder.filePath(QStringLiteral("kept.journal")).toStdString();
    ASSERT_TRUE(QFile::copy(QString::fromStdString(recordings) + QLatin1Char('/') + files.front(),
                            QString::fromStdString(kept)));
  }
  EXPECT_TRUE(QDir(QString::fromStdString(recordings)).entryList(QDir::Files).isEmpty());  // after a regular end

  const auto record = readRunRecord(kept);
  ASSERT_TRUE(record.ok()) << toString(record.error());
  const auto log = replayLog(*record, *scenario, kept);
  ASSERT_TRUE(log.ok()) << toString(log.error());
  ASSERT_TRUE(log->end);
  EXPECT_FALSE(log->operatorStream.empty());
  ReplayRunner runner;
  ReplayProgress last;
  QObject::connect(&runner, &ReplayRunner::progressed, [&](const ReplayProgress& progress) { last = progress; });
  runner.run(scenario->problem, std::make_shared<const RunLog>(*log), ReplayEnd::WithTheLog, false);
  ASSERT_TRUE(until([&] { return last.ended; }));
  EXPECT_EQ(last.track->lastStep(), log->end->step);
  EXPECT_FALSE(firstDifference(*log, joined(last.latest->log)));
}

TEST(RunRecorder, NamesTheFileToWhichTheScenarioWasSavedAfterTheRun) {
  const ScenarioPtr scenario = closedScenario();
  RunRecorder recorder;
  recorder.open(scenario);
  SessionSnapshot snapshot;
  snapshot.log = {std::make_shared<const RunLog>()};
  ASSERT_TRUE(recorder.follow(snapshot));
  auto saved = std::make_shared<LoadedScenario>(*scenario);
  saved->file = "/elsewhere/saved.json";
  EXPECT_TRUE(recorder.renew(saved));
  EXPECT_EQ(recorder.record()->scenario, saved->file);
  auto other = std::make_shared<LoadedScenario>(*saved);
  other->problemSha256 = "another";
  other->file = "/elsewhere/other.json";
  EXPECT_FALSE(recorder.renew(other));
  recorder.rearrange(other);
  EXPECT_EQ(recorder.record()->scenario, saved->file) << "the recording is about the scenario of its run";
}

TEST(RunRecorder, SaysWhyTheDiskHoldsNoJournal) {
  const QTemporaryDir folder;
  QFile inTheWay(folder.filePath(QStringLiteral("recordings")));
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  RunRecorder recorder;
  recorder.keepJournals(inTheWay.fileName().toStdString());
  recorder.open(closedScenario());
  SessionSnapshot snapshot;
  snapshot.log = {std::make_shared<const RunLog>()};
  EXPECT_TRUE(recorder.follow(snapshot));
  recorder.waitUntilJournalled();
  ASSERT_TRUE(recorder.trouble());
  EXPECT_FALSE(recorder.trouble()->advice.empty());
}

}  // namespace
}  // namespace glissade
