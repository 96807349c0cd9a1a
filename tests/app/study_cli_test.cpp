// Runs glissade-cli study and merge as a user would: shards, kills, limits, messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "engine/base/child_process.h"
#include "tests/engine/study/study_fixture.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Json = nlohmann::json;

const std::string kCli = test::programDirectory() + "/glissade-cli";

class StudyCli : public testing::Test {
 protected:
  /// Runs a shell command and returns its exit code; `said` holds its output.
  int shell(const std::string& command) {
    const std::string log = files.folder / "said";
    const int status = std::system(("( " + command + " ) >" + log + " 2>&1").c_str());
    said = test::readWhole(log);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string command(const std::string& out, const std::string& more = "") const {
    return kCli + " study " + files.file + " --out " + path(out) + " " + more;
  }
  std::string path(const std::string& name) const { return files.folder / name; }
  void use(const Json& study) { files.folder.write("study.json", study.dump()); }
  std::size_t finishedRuns(const std::string& out) const {
    if (!fs::exists(path(out) + "/runs")) return 0;
    const fs::directory_iterator runs(path(out) + "/runs");
    return static_cast<std::size_t>(std::count_if(
        begin(runs), end(runs), [](const fs::directory_entry& entry) { return entry.path().extension() == ".json"; }));
  }
  void expectSameTables(const std::string& a, const std::string& b) const {
    for (const char* table : {"/runs.csv", "/summary.csv", "/summary.json", "/plan.json", "/study.json"}) {
      const std::string content = test::readWhole(path(a) + table);
      EXPECT_FALSE(content.empty()) << table;
      EXPECT_TRUE(content == test::readWhole(path(b) + table)) << table << " of " << a << " and " << b;
    }
  }
  /// Starts the study, sends it a signal when some runs have finished, and returns its exit status.
  int interruptAfter(std::size_t runs, int signal, const std::string& out) {
    const pid_t pid = fork();
    if (pid == 0) {
      execl(kCli.c_str(), kCli.c_str(), "study", files.file.c_str(), "--out", path(out).c_str(), "--jobs", "2",
            nullptr);
      _exit(127);
    }
    while (finishedRuns(out) < runs) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kill(pid, signal);
    int status = 0;
    waitpid(pid, &status, 0);
    return status;
  }

  /// A study with interactive runs of about 50 ms each, so that a signal comes during a run.
  static Json slidingStudy() {
    Json study = test::tinyStudy();
    study["scenarios"] = {test::sourceDirectory() + "/samples/sliding-plane/scenario.json"};
    study["strategies"] = {"contact-birrt", "birrt"};
    study["operators"] = {"expert", "novice"};
    study["limits"]["max_steps"] = 800;
    study["rows"] = {{{"label", "a"}, {"grid", {{"alpha", {0.2, 0.8}}}}}};
    study["seeds"] = {{"first", 1}, {"count", 3}};
    study.erase("quick");
    return study;
  }

  test::StudyFiles files;
  std::string said;
};

TEST_F(StudyCli, TwoShardsMergedAreTheStudyInOneProcess) {
  use(slidingStudy());
  ASSERT_EQ(shell(command("whole")), 0) << said;
  const bool parallel = std::system("parallel --version 2>/dev/null | grep -q GNU") == 0;
  if (!parallel) std::cout << "GNU parallel is not installed: two plain processes instead\n";
  const std::string shard = kCli + " study " + files.file + " --out " + path("shard-{}") + " --shard {}/2";
  const auto numbered = [&](const std::string& number) {
    std::string text = shard;
    for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}")) text.replace(at, 2, number);
    return text;
  };
  ASSERT_EQ(shell(parallel ? "parallel --will-cite '" + shard + "' ::: 1 2"
                           : numbered("1") + " & " + numbered("2") + " && wait $!"),
            0)
      << said;
  EXPECT_EQ(finishedRuns("shard-1") + finishedRuns("shard-2"), finishedRuns("whole"));
  ASSERT_EQ(shell(kCli + " merge " + path("shard-1") + " " + path("shard-2") + " --out " + path("merged")), 0) << said;
  expectSameTables("whole", "merged");
}

TEST_F(StudyCli, SequencesAreRunsAsPathsAre) {
  const std::string samples = test::sourceDirectory() + "/samples/interlocked/";
  Json study = test::tinyStudy();
  study["scenarios"] = {samples + "group.json", samples + "two-hands.json"};
  study["strategies"] = {"sequence-greedy"};
  study["limits"] = {{"time_limit", 60}};
  study["rows"] = {{{"label", "interlocked"}}};
  study["seeds"] = {1};
  study.erase("quick");
  study["paper"] = {
      {{"key", "parts"}, {"title", "Parts"}, {"measure", "parts_removed"}, {"statistic", "median"}, {"over", "all"}}};
  use(study);
  for (const char* shard : {"1", "2"}) {
    ASSERT_EQ(shell(command("shard-" + std::string(shard), "--shard " + std::string(shard) + "/2")), 0) << said;
  }
  ASSERT_EQ(
      shell(kCli + " merge " + path("shard-1") + " " + path("shard-2") + " --out " + path("merged") + " --report"), 0)
      << said;
  const std::string runs = test::readWhole(path("merged") + "/runs.csv");
  EXPECT_THAT(runs, HasSubstr("solved"));
  EXPECT_THAT(runs, HasSubstr("no-path"));
  EXPECT_THAT(runs, HasSubstr("parts_removed"));
  EXPECT_THAT(test::readWhole(path("merged") + "/report.html"), HasSubstr("interlocked, group"));
  study["operators"] = {"expert"};
  use(study);
  EXPECT_EQ(shell(command("wrong")), 3) << said;
  EXPECT_THAT(said, HasSubstr("is a sequence with an operator"));
}

TEST_F(StudyCli, ASlurmTaskIsAShard) {
  const std::string script = test::sourceDirectory() + "/samples/studies/slurm.sh";
  const std::string common = "CLI=" + kCli + " STUDY=" + files.file + " OUT=" + path("array") + " ";
  for (const std::string task : {"1", "2", "3"}) {
    const std::string slurm = "SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=2 SLURM_ARRAY_TASK_ID=" + task + " ";
    ASSERT_EQ(shell(common + slurm + "sh " + script), 0) << said;
    EXPECT_EQ(finishedRuns("array/shard-" + task), 2U);
  }
  ASSERT_EQ(shell(kCli + " merge " + path("array") + "/shard-* --out " + path("all")), 0) << said;
  EXPECT_EQ(finishedRuns("all"), 6U);
  EXPECT_NE(shell("CLI=" + kCli + " STUDY=" + files.file + " sh " + script), 0) << "OUT is missing";
}

TEST_F(StudyCli, AKilledStudyGoesOnWhereItWas) {
  use(slidingStudy());
  ASSERT_EQ(shell(command("whole", "--jobs 2")), 0) << said;
  const int status = interruptAfter(5, SIGKILL, "killed");
  ASSERT_TRUE(WIFSIGNALED(status));
  const std::size_t before = finishedRuns("killed");
  ASSERT_LT(before, finishedRuns("whole")) << "it was over before it was killed";
  const auto oldest = fs::last_write_time(path("killed") + "/runs/cell1-seed1.json");
  ASSERT_EQ(shell(command("killed")), 0) << said;
  EXPECT_EQ(fs::last_write_time(path("killed") + "/runs/cell1-seed1.json"), oldest) << "it was run again";
  expectSameTables("whole", "killed");
}

TEST_F(StudyCli, AnInterruptedStudySaysSoAndGoesOn) {
  use(slidingStudy());
  ASSERT_EQ(shell(command("whole", "--jobs 2")), 0) << said;
  const int status = interruptAfter(3, SIGINT, "stopped");
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(fs::exists(path("stopped") + "/summary.csv")) << "what is known is in the tables";
  ASSERT_EQ(shell(command("stopped", "--dry-run")), 0);
  EXPECT_THAT(said, HasSubstr(std::to_string(finishedRuns("stopped")) + " of them done"));
  ASSERT_EQ(shell(command("stopped")), 0) << said;
  expectSameTables("whole", "stopped");
}

TEST_F(StudyCli, LimitsOfTimeAndMemoryAreRows) {
  Json study = test::tinyStudy();
  Json closed = Json::parse(test::tinyScenario());
  closed["bodies"][0]["geometry"]["box"] = {0.1, 9, 9};
  files.folder.write("closed.json", closed.dump());
  study["scenarios"] = {"closed.json"};
  study["seeds"] = {1};
  study["rows"] = {{{"label", "steps"}, {"limits", {{"max_steps", 50}}}},
                   {{"label", "time"}, {"limits", {{"max_steps", 0}, {"time_limit", 0.2}}}},
                   {{"label", "memory"}, {"limits", {{"memory_limit_mb", 90}, {"time_limit", 600}, {"max_steps", 0}}}}};
  study.erase("quick");
  use(study);
  ASSERT_EQ(shell(command("out")), 0) << said;
  const Json summary = Json::parse(test::readWhole(path("out") + "/summary.json"));
  EXPECT_EQ(summary["cells"][0]["statuses"]["limit-reached"], 1);
  EXPECT_EQ(summary["cells"][1]["statuses"]["time"], 1);
  if (!kMemoryCanBeLimited) return;
  EXPECT_EQ(summary["cells"][2]["statuses"]["memory"], 1) << test::readWhole(path("out") + "/runs.csv");
}

TEST_F(StudyCli, WrongUsageAndBadFilesGetOneClearMessage) {
  const auto expectRefused = [&](const std::string& command, int code, const std::string& mentions) {
    EXPECT_EQ(shell(command), code) << said;
    EXPECT_THAT(said, HasSubstr(mentions));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  };
  expectRefused(command("out", "--shard 3/2"), 2, "--shard");
  expectRefused(command("out", "--shard x"), 2, "--shard");
  expectRefused(kCli + " study " + files.file + " --out " + files.folder.path(), 2, "not a folder of study results");
  expectRefused(kCli + " study " + path("none.json") + " --out " + path("out"), 3, "none.json");
  expectRefused(kCli + " merge " + path("none") + " --out " + path("out"), 3, "plan.json");
  Json study = test::tinyStudy();
  study["strategies"] = {"warp"};
  use(study);
  expectRefused(command("out"), 3, "/strategies/0");
  EXPECT_FALSE(fs::exists(path("out"))) << "a bad study leaves nothing behind";
  EXPECT_EQ(shell(kCli + " study"), 2);
  expectRefused("GLISSADE_PYTHON=/nowhere " + kCli + " benchmark-page " + files.folder.path(), 3, "python3-matplotlib");
}

TEST_F(StudyCli, ADryRunWritesNothing) {
  ASSERT_EQ(shell(command("out", "--dry-run --quick")), 0) << said;
  EXPECT_THAT(said, HasSubstr("1 cell, 1 run"));
  EXPECT_THAT(said, HasSubstr("--max-steps 100"));
  EXPECT_FALSE(fs::exists(path("out")));
}

/// Every shipped study can be run, in both sizes.
TEST_F(StudyCli, ShippedStudiesAreSound) {
  for (const char* name : {"table-1", "table-2", "table-3", "table-4", "table-5", "figure-14", "figure-14-paper-like",
                           "automatic", "tuned"}) {
    const std::string study = test::sourceDirectory() + "/samples/studies/" + name + ".json";
    for (const char* size : {"", "--quick"}) {
      EXPECT_EQ(shell(kCli + " study " + study + " --out " + path("out") + " --dry-run " + size), 0) << said;
      EXPECT_THAT(said, HasSubstr("0 of them done"));
    }
  }
}

TEST_F(StudyCli, PublicProblemsAreSoundOrSaidToBeMissing) {
  const std::string study = test::sourceDirectory() + "/samples/studies/public-problems.json";
  const bool there = fs::exists(test::sourceDirectory() + "/../shared/problems/omplapp");
  EXPECT_EQ(shell(kCli + " study " + study + " --out " + path("out") + " --dry-run"), there ? 0 : 3) << said;
  EXPECT_THAT(said, HasSubstr(there ? "55 cells" : "Easy.cfg"));
}

/// A run of a peer is judged and timed like the project's own: a study with one box in the way.
TEST_F(StudyCli, PeersRunBesideOurs) {
  auto study = test::tinyStudy();
  study["strategies"] = {"auto", "peer-rrtconnect", "peer-rrt", "peer-trrt", "peer-bitrrt", "peer-bkpiece"};
  study["rows"] = {{{"label", "fine"}, {"parameters", {{"ompl_resolution", 0.002}}}},
                   {{"label", "coarse"}, {"parameters", {{"ompl_resolution", 0.5}, {"ompl_range", 1}}}}};
  study["seeds"] = {1};
  study.erase("quick");
  use(study);
  ASSERT_EQ(shell(command("out", "--jobs 2 --report")), 0) << said;
  const Json summary = Json::parse(test::readWhole(path("out") + "/summary.json"));
  ASSERT_EQ(summary["cells"].size(), 12U);
  std::size_t refused = 0;
  for (const Json& cell : summary["cells"]) {
    const Json& ended = cell["statuses"];
    EXPECT_EQ(ended["error"].get<int>() + ended["crashed"].get<int>(), 0) << cell["label"];
    if (cell["strategy"] == "auto") {
      EXPECT_EQ(ended["solved"], 1) << cell["label"];
    }
    refused += ended["not-certified"].get<std::size_t>();
  }
  EXPECT_GE(refused, 1U) << "an edge from start to goal passes through the wall, and nobody looks";
  EXPECT_THAT(test::readWhole(path("out") + "/timing.csv"), HasSubstr("planning_cpu_s"));
  EXPECT_THAT(test::readWhole(path("out") + "/report.html"), HasSubstr("fine, peer-bitrrt"));
}

/// The report of a study promises that its runs can be repeated.
TEST_F(StudyCli, ARunOfAPeerIsRepeatedRecordedAndReplayed) {
  const std::string record = path("run.json");
  const std::string scenario = path("scenario.json");
  EXPECT_EQ(shell(kCli + " plan " + scenario + " --strategy peer-rrtconnect --record " + record), 0) << said;
  EXPECT_EQ(shell(kCli + " replay " + record), 0) << said;
  EXPECT_THAT(said, HasSubstr("same roadmap"));
  EXPECT_EQ(shell(kCli + " plan " + scenario + " --operator replay:" + record), 0) << said;
  EXPECT_EQ(shell(kCli + " plan --help"), 0);
  EXPECT_THAT(said, testing::Not(HasSubstr("peer-")));
}

TEST_F(StudyCli, AQuickStudyOfThePaperHoldsItsNumbers) {
  const std::string study = test::sourceDirectory() + "/samples/studies/table-2.json";
  ASSERT_EQ(shell(kCli + " study " + study + " --out " + path("out") + " --quick --jobs 2 --shard 1/3"), 0) << said;
  const Json summary = Json::parse(test::readWhole(path("out") + "/summary.json"));
  ASSERT_EQ(summary["cells"].size(), 10U);
  for (const Json& cell : summary["cells"]) {
    EXPECT_EQ(cell["planned"], 3);
    EXPECT_EQ(cell["runs"], 1) << "shard 1 of 3 has one of three seeds";
    if (cell["operator"] != "expert") continue;
    EXPECT_EQ(cell["statuses"]["solved"], 1) << cell["label"];
    EXPECT_LT(cell["measures"]["nodes"]["solved"]["median"], 27600 / 10) << "any operator beats none by ten times";
  }
  EXPECT_EQ(summary["cells"][4]["paper"]["nodes"], 715);
}

}  // namespace
}  // namespace glissade
