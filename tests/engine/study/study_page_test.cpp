// The page of a study from the engine's side: the tables come first, and every failure is one clear error. What the
// page holds is tested by tests/studies.
#include "engine/study/study_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/engine/study/study_fixture.h"

namespace glissade {
namespace {

using testing::HasSubstr;

class StudyPage : public testing::Test {
 protected:
  StudyPage() {
    const auto plan = planStudy(files.file, false, warnings);
    folder = std::make_unique<StudyFolder>(*StudyFolder::begin(files.folder / "out", *plan, "{}"));
    for (const StudyRun& run : runsOf(plan->study, {})) {
      RunOutcome outcome;
      outcome.result.status = RunStatus::Solved;
      EXPECT_TRUE(folder->save(run, outcome).ok());
    }
  }
  ~StudyPage() override { unsetenv("GLISSADE_PYTHON"); }

  /// Uses a shell script in the place of Python.
  void usePython(const std::string& script) {
    const std::string file = files.folder.write("python", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("GLISSADE_PYTHON", file.c_str(), 1);
  }
  Diagnostic failure() {
    const auto page = writeStudyPage(*folder, {}, warnings);
    EXPECT_FALSE(page.ok());
    return page ? Diagnostic() : page.error();
  }

  test::StudyFiles files;
  Warnings warnings;
  std::unique_ptr<StudyFolder> folder;
};

TEST_F(StudyPage, TheScriptGetsTablesOptionsAndItsWarningsAreTold) {
  usePython("echo \"warning: a word of $6\" >&2; echo \"other\" >&2; echo \"$3 $5\"");
  const PageOptions options{files.folder / "elsewhere", "", Language::French};
  const auto page = writeStudyPage(*folder, options, warnings);
  ASSERT_TRUE(page.ok()) << toString(page.error());
  EXPECT_EQ(*page, "fr " + options.out);
  EXPECT_TRUE(std::filesystem::exists(options.out + "/summary.json"));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(toString(warnings.front()), HasSubstr("a word of --"));
}

TEST_F(StudyPage, EveryFailureIsOneError) {
  setenv("GLISSADE_PYTHON", "/nowhere/python3", 1);
  EXPECT_THAT(toString(failure()), HasSubstr("apt install python3-matplotlib"));
  usePython("echo 'matplotlib (apt install python3-matplotlib)' >&2; exit 69");
  EXPECT_THAT(toString(failure()), HasSubstr("not installed: matplotlib"));
  EXPECT_EQ(exitCode(failure().kind), 3);
  usePython("echo 'out/summary.json: is malformed' >&2; exit 3");
  EXPECT_EQ(toString(failure()), "out/summary.json: is malformed");
  usePython("echo 'Traceback' >&2; echo 'ValueError: x' >&2; exit 1");
  EXPECT_THAT(toString(failure()), HasSubstr("has failed: ValueError: x"));
}

TEST_F(StudyPage, ASlowScriptCanBeStopped) {
  usePython("sleep 60");
  StopSource source;
  source.requestStop();
  const auto page = writeStudyPage(*folder, {}, warnings, source.token());
  ASSERT_FALSE(page.ok());
  EXPECT_EQ(page.error().kind, ErrorKind::Interrupted);
}

}  // namespace
}  // namespace glissade
