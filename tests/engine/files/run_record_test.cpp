#include "engine/files/run_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/files/run_journal.h"
#include "engine/files/same_problem.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/files/some_run_record.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::someRunRecord;

void expectSameLog(const RunLog& read, const RunLog& written) {
  EXPECT_EQ(read.start.planner, written.start.planner);
  EXPECT_EQ(read.start.seed, written.start.seed);
  ASSERT_TRUE(read.start.edits);
  EXPECT_EQ(*read.start.edits, *written.start.edits);
  ASSERT_TRUE(read.start.knowledge);
  EXPECT_EQ(read.start.knowledge->options, written.start.knowledge->options);
  EXPECT_EQ(read.parameterChanges[1].value, 1.0 / 7.0);
  ASSERT_EQ(read.semanticChanges.size(), 2U);
  EXPECT_EQ(*read.semanticChanges[0].edits, *written.semanticChanges[0].edits);
  EXPECT_EQ(read.semanticChanges[1].edits, nullptr);
  ASSERT_EQ(read.operatorStream.size(), written.operatorStream.size());
  for (std::size_t i = 0; i < written.operatorStream.size(); ++i) {
    EXPECT_EQ(read.operatorStream[i].step, written.operatorStream[i].step);
    EXPECT_EQ(read.operatorStream[i].q_device, written.operatorStream[i].q_device);
  }
  ASSERT_EQ(read.checkpoints.size(), 1U);
  EXPECT_EQ(read.checkpoints[0].hash, 0xfedcba9876543210U);
  EXPECT_EQ(read.checkpoints[0].seconds, 1.0 / 3.0);
  ASSERT_TRUE(read.end);
  EXPECT_EQ(read.end->step, 1500U);
}

TEST(RunRecordFile, ReadsBackBitByBit) {
  const test::TemporaryFolder folder;
  const RunRecord written = someRunRecord();
  ASSERT_TRUE(writeRunRecord(written, folder / "run.json").ok());
  const Result<RunRecord> read = readRunRecord(folder / "run.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->parameters, written.parameters);
  EXPECT_EQ(read->assets[0].sha256, written.assets[0].sha256);
  expectSameLog(read->log, written.log);
  RunRecord again = *read;
  again.scenario = written.scenario;  // the file does not exist, so that the record's name for it is kept
  ASSERT_TRUE(writeRunRecord(again, folder / "again.json").ok());
  EXPECT_EQ(test::readWhole(folder / "again.json"), test::readWhole(folder / "run.json"));
}

TEST(RunRecordFile, Version1IsStillRead) {
  const test::TemporaryFolder folder;
  const Result<RunRecord> read = readRunRecord(folder.write("old.json", test::kRunRecordOfVersion1));
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->version, 1);
  EXPECT_EQ(read->log.start.seed, 5U);
  EXPECT_EQ(read->log.parameterChanges[0].value, 0.5);
  EXPECT_EQ(read->log.operatorStream[0].q_device->position, Vector3(1, 2, 3));
  EXPECT_EQ(read->log.end->nodes, 42U);
}

TEST(RunRecordFile, IsReadStrictly) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRunRecord(someRunRecord(), folder / "run.json").ok());
  const auto sound = nlohmann::json::parse(test::readWhole(folder / "run.json"));
  const std::vector<std::tuple<const char*, std::string>> table{
      {R"([{"op": "replace", "path": "/format", "value": "x"}])", "/format"},
      {R"([{"op": "replace", "path": "/version", "value": 3}])", "/version"},
      {R"([{"op": "add", "path": "/extra", "value": 2}])", "/extra"},
      {R"([{"op": "remove", "path": "/end"}])", "/end"},
      {R"([{"op": "replace", "path": "/operator_stream/3/0", "value": 1}])", "/operator_stream/3/0"},
      {R"([{"op": "replace", "path": "/operator_stream/3/7", "value": 9}])", "/operator_stream/3"},
      {R"([{"op": "remove", "path": "/operator_stream/3/7"}])", "/operator_stream/3"},
      {R"([{"op": "replace", "path": "/operator_stream/3/2", "value": 1e12}])", "/operator_stream/3/2"},
      {R"([{"op": "replace", "path": "/parameter_changes/0/parameter", "value": "x"}])",
       "/parameter_changes/0/parameter"},
      {R"([{"op": "add", "path": "/parameters/x", "value": 1}])", "/parameters/x"},
      {R"([{"op": "replace", "path": "/semantic_changes/1/step", "value": 1}])", "/semantic_changes/1/step"},
      {R"([{"op": "add", "path": "/semantics/x", "value": 1}])", "/semantics/x"},
      {R"([{"op": "replace", "path": "/knowledge/environment/places", "value": "x"}])",
       "/knowledge/environment/places"},
      {R"([{"op": "replace", "path": "/checkpoints/0/hash", "value": "12"}])", "/checkpoints/0/hash"},
      {R"([{"op": "replace", "path": "/end/step", "value": 999}])", "/end/step"},
      {R"([{"op": "replace", "path": "/assets/0/id", "value": 4}])", "/assets/0/id"},
  };
  for (const auto& [patch, place] : table) {
    const Result<RunRecord> read =
        readRunRecord(folder.write("broken.json", sound.patch(nlohmann::json::parse(patch)).dump()));
    ASSERT_FALSE(read.ok()) << patch;
    EXPECT_EQ(read.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(read.error().location), place);
  }
}

TEST(RunJournal, AKilledWriterLeavesAllButTheLineThatWasCutOff) {
  const test::TemporaryFolder folder;
  const RunRecord whole = someRunRecord();
  RunRecord head = whole;
  head.log = RunLog();
  head.log.start = whole.log.start;
  RunLog first;
  first.parameterChanges = whole.log.parameterChanges;
  first.semanticChanges = whole.log.semanticChanges;
  first.operatorStream = whole.log.operatorStream;
  RunLog second;
  second.checkpoints = whole.log.checkpoints;
  second.end = whole.log.end;
  auto journal = RunJournal::begin(head, folder / "recordings");
  ASSERT_TRUE(journal.ok()) << toString(journal.error());
  ASSERT_TRUE((*journal)->append(first).ok());
  ASSERT_TRUE((*journal)->append(second).ok());
  ASSERT_TRUE((*journal)->append(first).ok());
  EXPECT_TRUE(abandonedJournals(folder / "recordings").empty());  // its writer is running

  const std::string text = test::readWhole((*journal)->file());
  const std::string cut = folder.write("cut.journal", text.substr(0, text.size() - 20));
  const Result<RunRecord> read = readRunRecord(cut);
  ASSERT_TRUE(read.ok()) << toString(read.error());
  expectSameLog(read->log, whole.log);

  const std::string file = (*journal)->file();
  journal->reset();
  EXPECT_EQ(abandonedJournals(folder / "recordings"), std::vector<std::string>{file});
}

TEST(RunJournal, ALineThatAddsWhatTheFirstOneLacksIsLost) {
  const test::TemporaryFolder folder;
  const auto journal = RunJournal::begin(someRunRecord(), folder / "recordings");
  ASSERT_TRUE(journal.ok()) << toString(journal.error());
  std::string head = test::readWhole((*journal)->file());
  const std::size_t checksum = head.rfind(",\"checksum\"");
  head = head.substr(0, checksum) + "}\n";  // former format of journals: no line has a checksum
  const auto whole = readRunRecord(folder.write("head.journal", head));
  ASSERT_TRUE(whole.ok()) << toString(whole.error());
  EXPECT_FALSE(whole->loss);
  for (const std::string line : {"{\"extra\": 1}\n", "[1]\n", "{\"a\": [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1\n"}) {
    const auto read = readRunRecord(folder.write("broken.journal", head + line));
    ASSERT_TRUE(read.ok()) << line;
    EXPECT_TRUE(read->loss && read->loss->lines == 1) << line;
  }
}

TEST(RunJournal, NamesThatAreNoUtf8EndNoRun) {
  const test::TemporaryFolder folder;
  RunRecord record = someRunRecord();
  record.scenario = "/somewhere/s\xff.json";
  EXPECT_TRUE(RunJournal::begin(record, folder / "recordings").ok());
  ASSERT_TRUE(writeRunRecord(record, folder / "run.json").ok());
  EXPECT_TRUE(readRunRecord(folder / "run.json").ok());
}

TEST(RunRecordFile, AChecksumThatDoesNotFitIsAnError) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRunRecord(someRunRecord(), folder / "run.json").ok());
  std::string text = test::readWhole(folder / "run.json");
  const std::size_t step = text.find("\"step\":1500");
  ASSERT_NE(step, std::string::npos);
  text[step + 8] = '6';
  const Result<RunRecord> read = readRunRecord(folder.write("damaged.json", text));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(toString(read.error().location), "/checksum");
  const std::size_t checksum = text.find(",\n \"checksum\"");
  text.erase(checksum, text.find('\n', checksum + 2) - checksum);  // former format of records
  EXPECT_TRUE(readRunRecord(folder.write("edited.json", text)).ok());
}

/// The lines of a journal of three parts, whose checkpoints are at 10, 20 and 30.
std::vector<std::string> journalOfThreeParts(const test::TemporaryFolder& folder) {
  RunRecord head = someRunRecord();
  head.log = RunLog();
  head.log.start = someRunRecord().log.start;
  auto journal = RunJournal::begin(head, folder / "recordings");
  EXPECT_TRUE(journal.ok());
  for (std::uint64_t step = 10; step <= 30; step += 10) {
    RunLog part;
    part.checkpoints = {{step, step, step, step, 0.5}};
    EXPECT_TRUE((*journal)->append(part).ok());
  }
  std::istringstream stream(test::readWhole((*journal)->file()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line + "\n");
  return lines;
}

TEST(RunJournal, ADamagedLineCostsThatLineOnly) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> lines = journalOfThreeParts(folder);
  ASSERT_EQ(lines.size(), 4U);
  for (const std::string& damaged :
       {std::string("\n"), std::string("nonsense\n"), lines[2].substr(0, 30) + "\n", "7" + lines[2].substr(1),
        std::string(100, '\0') + "\n", std::string("{\"checkpoints\":[]}\n")}) {
    const Result<RunRecord> read =
        readRunRecord(folder.write("damaged.journal", lines[0] + lines[1] + damaged + lines[3]));
    ASSERT_TRUE(read.ok()) << toString(read.error());
    ASSERT_TRUE(read->loss);
    EXPECT_EQ(read->loss->lines, 1U);
    EXPECT_EQ(read->loss->afterStep, 10U);
    EXPECT_TRUE(lossWarning(*read, "damaged.journal"));
    ASSERT_EQ(read->log.checkpoints.size(), 2U);
    EXPECT_EQ(read->log.checkpoints[1].step, 30U);
    // The recording that is saved from it also states the loss.
    ASSERT_TRUE(writeRunRecord(*read, folder / "saved.json").ok());
    const Result<RunRecord> saved = readRunRecord(folder / "saved.json");
    ASSERT_TRUE(saved.ok()) << toString(saved.error());
    EXPECT_EQ(saved->loss->lines, 1U);
  }
  const Result<RunRecord> headless = readRunRecord(folder.write("headless.journal", lines[0].substr(0, 90) + "\n"));
  ASSERT_FALSE(headless.ok());
  EXPECT_EQ(toString(headless.error().location), "line 1");
}

TEST(RunJournal, EveryChangedDigitCostsItsLine) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> lines = journalOfThreeParts(folder);
  for (std::size_t i = 0; i < lines[2].size(); ++i) {
    if (lines[2][i] < '0' || lines[2][i] > '9') continue;
    std::string damaged = lines[2];
    damaged[i] = damaged[i] == '7' ? '8' : '7';
    const Result<RunRecord> read =
        readRunRecord(folder.write("damaged.journal", lines[0] + lines[1] + damaged + lines[3]));
    ASSERT_TRUE(read.ok()) << toString(read.error());
    EXPECT_TRUE(read->loss && read->loss->lines == 1 && read->log.checkpoints.size() == 2) << "at " << i;
  }
}

TEST(RunJournal, ALineThatTheDiskDoesNotTakeLeavesTheOthersWhole) {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();  // the limit cannot be restored
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    RunRecord head = someRunRecord();
    head.log = RunLog();
    head.log.start = someRunRecord().log.start;
    auto journal = RunJournal::begin(head, folder / "recordings");
    if (!journal) ::_exit(1);
    const auto size = std::filesystem::file_size((*journal)->file());
    const rlimit limit{size + 50, size + 50};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(2);
    const bool reported = !(*journal)->append(someRunRecord().log).ok();
    ::_exit(reported && std::filesystem::file_size((*journal)->file()) == size ? 0 : 3);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  const std::vector<std::string> left = abandonedJournals(folder / "recordings");
  ASSERT_EQ(left.size(), 1U);
  const Result<RunRecord> read = readRunRecord(left[0]);
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_FALSE(read->loss);
}

TEST(RunJournal, OnesThatAreNotNeededGoAndBadFoldersAreSaid) {
  const test::TemporaryFolder folder;
  auto journal = RunJournal::begin(someRunRecord(), folder / "recordings");
  ASSERT_TRUE(journal.ok());
  (*journal)->discard();
  journal->reset();
  EXPECT_TRUE(abandonedJournals(folder / "recordings").empty());
  EXPECT_FALSE(RunJournal::begin(someRunRecord(), folder.write("file", "") + "/below").ok());
  const Result<RunRecord> broken =
      readRunRecord(folder.write("x.journal", "{\"format\":\"glissade-run\",\"version\":2}\nnonsense\n"));
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().kind, ErrorKind::MalformedInput);
}

TEST(RunJournal, GoesOnceItsRecordingIsWritten) {
  const test::TemporaryFolder folder;
  const RunRecord whole = test::someRunRecord();
  RunRecord head = whole;
  head.log = {};
  head.log.start = whole.log.start;
  auto journal = RunJournal::begin(head, folder / "recordings");
  ASSERT_TRUE(journal.ok());
  ASSERT_TRUE((*journal)->append(whole.log).ok());
  const std::string file = (*journal)->file();
  journal->reset();

  StopSource source;
  source.requestStop();
  EXPECT_FALSE(saveJournal(file, folder / "run.json", source.token()).ok());
  EXPECT_FALSE(saveJournal(file, folder.write("file", "") + "/run.json").ok());
  EXPECT_EQ(abandonedJournals(folder / "recordings"), std::vector<std::string>{file});  // nothing is lost
  const SaveResult saved = saveJournal(file, folder / "run.json");
  ASSERT_TRUE(saved.ok()) << toString(saved.why);
  EXPECT_TRUE(abandonedJournals(folder / "recordings").empty());
  const auto read = readRunRecord(folder / "run.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  expectSameLog(read->log, whole.log);
}

class ReplayLog : public testing::Test {
 protected:
  void SetUp() override {
    auto loaded = loadScenario(test::sample("sliding-plane"));
    ASSERT_TRUE(loaded.ok());
    scenario_.emplace(std::move(*loaded));
    RunLog log;
    log.start.planner = "contact-birrt";
    log.start.parameters = scenario_->parameters;
    auto record = makeRunRecord(*scenario_, log);
    ASSERT_TRUE(record.ok());
    record_ = std::move(*record);
  }

  std::string refusal() {
    const auto log = replayLog(record_, *scenario_, "run.json");
    return log ? "" : log.error().file + ": " + toString(log.error().location);
  }

  std::optional<LoadedScenario> scenario_;
  RunRecord record_;
};

TEST_F(ReplayLog, IsThatOfTheScenarioWhateverElseItSaysNow) {
  EXPECT_EQ(refusal(), "");
  scenario_->scenario.seed += 1;
  scenario_->scenario.name = "renamed";
  scenario_->scenario.planner = "birrt";
  scenario_->scenario.places.push_back({Vector3::Zero(), "x", {}});
  EXPECT_EQ(refusal(), "");
}

TEST_F(ReplayLog, OfAVersionWithoutSlotsHasOne) {
  EXPECT_GT(replayLog(record_, *scenario_, "run.json")->start.parameters.integer(ParameterId::Slots), 1);
  record_.parameters.erase(ParameterId::Slots);
  EXPECT_EQ(replayLog(record_, *scenario_, "run.json")->start.parameters.integer(ParameterId::Slots), 1);
}

TEST_F(ReplayLog, IsRefusedOnAnotherScenario) {
  scenario_->scenario.bodies[0].pose.position.x() += 1e-9;
  scenario_->problemSha256 = problemSha256(scenario_->scenario);
  EXPECT_EQ(refusal(), "run.json: /problem_sha256");
}

TEST_F(ReplayLog, IsThatOfTheScenarioWithOtherNamesAndJoints) {
  Scenario& scenario = scenario_->scenario;
  scenario.bodies[0].name = scenario.object.first().name = "renamed";
  scenario.joints.push_back({});
  scenario_->problemSha256 = problemSha256(scenario);
  EXPECT_EQ(refusal(), "");
}

TEST_F(ReplayLog, OfAnEarlierProgramHasTheNamesInItsHash) {
  record_.problemSha256 = "428db8b8cd22141a60deeaacf764364668c214152f323a7b3263cc5d135bbe66";
  EXPECT_EQ(refusal(), "");
  scenario_->scenario.bodies[0].name = "renamed";
  EXPECT_EQ(refusal(), "run.json: /problem_sha256");
}

TEST_F(ReplayLog, IsRefusedWithValuesThatCannotBe) {
  record_.log.parameterChanges = {{1, ParameterId::Alpha, 7.0}};
  EXPECT_EQ(refusal(), "run.json: alpha");
  record_.log.parameterChanges.clear();
  for (const char* planner : {"warp", "peer-rrt"}) {
    record_.log.start.planner = planner;
    EXPECT_EQ(refusal(), "run.json: /planner") << planner;
  }
  record_.log.start.planner = "gts";
  auto edits = std::make_shared<SemanticEdits>();
  edits->bodies["nowhere"]["mobility"] = std::string("mobile");
  record_.log.semanticChanges = {{1, edits}};
  EXPECT_EQ(refusal(), "run.json: /bodies/nowhere");
}

TEST(RunRecordFile, ReadingTellsHowFarItIsAndEndsWhenStopped) {
  const test::TemporaryFolder folder;
  RunRecord record = test::someRunRecord();
  const Pose q = Pose::translation({0.1, 0.2, 0.3});
  for (std::uint64_t step = 1; step < 5000; ++step) record.log.operatorStream.push_back({1000 + step, q});
  const std::string file = folder / "long.json";
  ASSERT_TRUE(writeRunRecord(record, file).ok());
  std::vector<double> shares;
  const auto read = readRunRecord(file, WorkWatch({}, [&](double share) { shares.push_back(share); }));
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->log.operatorStream.size(), record.log.operatorStream.size());
  EXPECT_GT(shares.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1.0);
  StopSource source;
  source.requestStop();
  const auto stopped = readRunRecord(file, source.token());
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

}  // namespace
}  // namespace glissade
