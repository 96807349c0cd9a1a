// Attacks on saves: a failure at every system call, a kill at every system call, kills at random times. Each
// attack prints a row "name | tried | clean | defects | seconds | peak MB | seed". GLISSADE_SAVE_KILLS is the
// number of random kills, 100 where it is not set; GLISSADE_SAVE_SEED their seed.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <random>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/base/file_versions.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/engine/support/traced_child.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::CallFate;
using test::readWhole;
using test::runTraced;
using test::TemporaryFolder;
using test::TracedRun;

constexpr int kSaved = 10;
constexpr int kRefused = 11;
constexpr int kSavedWithWarning = 12;
constexpr int kOutOfMemory = 13;

/// One row of the table of attacks.
class AttackRow {
 public:
  explicit AttackRow(std::string name, unsigned seed = 0) : name_(std::move(name)), seed_(seed) {}
  ~AttackRow() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    std::printf("%s | %d | %d | %d | %.1f | %ld | %u\n", name_.c_str(), tried_, tried_ - defects_, defects_,
                spent.count(), usage.ru_maxrss / 1024, seed_);
  }
  AttackRow(const AttackRow&) = delete;
  AttackRow& operator=(const AttackRow&) = delete;

  /// Counts an attack; `defect` is empty where it did no harm.
  void count(const std::string& defect) {
    ++tried_;
    if (defect.empty()) return;
    ++defects_;
    ADD_FAILURE() << name_ << ": " << defect;
  }

 private:
  std::string name_;
  unsigned seed_;
  int tried_ = 0;
  int defects_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Puts temporary folders into memory where that is possible: hundreds of flushes to a disk take long, and the tests
/// simulate no power cut.
class SaveReliability : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::canTrace()) GTEST_SKIP() << "no child can be traced here";
    if (::access("/dev/shm", W_OK) == 0) ::setenv("TMPDIR", "/dev/shm", 1);
  }
  void TearDown() override { ::unsetenv("TMPDIR"); }
};

/// A file behind a link, with an earlier version, that is saved with all options of a save.
class AttackedFile {
 public:
  AttackedFile() {
    (void)folder_.write("there/a.json", "oldest");
    fs::create_symlink("there/a.json", link());
    EXPECT_TRUE(saveFile(link(), kOld, {std::nullopt, kKeptVersions, true}));
  }

  std::string link() const { return folder_ / "a.json"; }
  std::string file() const { return folder_ / "there/a.json"; }

  int save() const {
    try {
      const SaveResult result = saveFile(link(), kNew, {sha256(kOld), kKeptVersions, false});
      if (!result) return kRefused;
      return result.warnings.empty() ? kSaved : kSavedWithWarning;
    } catch (const std::bad_alloc&) {
      return kOutOfMemory;
    }
  }

  /// The defect after a save that was attacked; empty: none.
  std::string defect(const TracedRun& run) const {
    const std::string content = readWhole(file());
    if (!fs::is_symlink(link())) return "the link is gone";
    if (content != kOld && content != kNew) return "the file holds neither the old nor the new content";
    const bool saved = run.exitCode == kSaved || run.exitCode == kSavedWithWarning;
    if (run.exited && saved && content != kNew) return "a false success";
    if (run.exited && run.exitCode == kRefused && content != kOld) return "a false failure";
    const auto versions = earlierVersions(file());
    for (const FileVersion& version : versions) {
      const std::string kept = readWhole(version.path);
      if (kept != kOld && kept != "oldest") return "an earlier version is damaged";
    }
    if (versions.empty()) return "the earlier versions are gone";
    // The next save is not affected.
    if (!saveFile(link(), "next", {sha256(content), kKeptVersions, true})) return "the next save fails";
    return readWhole(file()) == "next" ? "" : "the next save lies";
  }

 private:
  static constexpr const char* kOld = "the old content";
  inline static const std::string kNew = std::string(20000, 'n');

  TemporaryFolder folder_;
};

std::size_t callsOfASave() {
  const AttackedFile file;
  const TracedRun run = runTraced([&] { return file.save(); }, [](std::size_t) { return CallFate(); });
  EXPECT_EQ(run.exitCode, kSaved);
  return run.calls.size();
}

void attackEveryCall(const CallFate& fate, AttackRow& row) {
  const std::size_t calls = callsOfASave();
  ASSERT_GT(calls, 30U);
  for (std::size_t at = 0; at < calls; ++at) {
    const AttackedFile file;
    const TracedRun run =
        runTraced([&] { return file.save(); }, [&](std::size_t call) { return call == at ? fate : CallFate(); });
    std::string defect = file.defect(run);
    const bool flushFailed = fate.kind == CallFate::Kind::Fails && run.calls[at] == SYS_fsync;
    if (flushFailed && run.exitCode == kSaved) defect = "a failed flush is not told";
    row.count(defect.empty() ? "" : "call " + std::to_string(at) + ", " + std::strerror(fate.error) + ": " + defect);
  }
}

TEST_F(SaveReliability, SurvivesAFailureOfEverySystemCall) {
  AttackRow row("save: a system call fails");
  for (const int error : {EIO, ENOSPC, EACCES, EINTR, ENOMEM}) {
    attackEveryCall({CallFate::Kind::Fails, error}, row);
  }
}

TEST_F(SaveReliability, SurvivesAKillAtEverySystemCall) {
  AttackRow row("save: killed at a system call");
  attackEveryCall({CallFate::Kind::Kills, 0}, row);
}

/// Content number n, with its own length; the content shows whether it is complete.
std::string numbered(int number) {
  return std::to_string(number) + "\n" + std::string(static_cast<std::size_t>(number * 7919 % 60000), 'x') + "end";
}

int numberIn(const std::string& content) {
  const int number = std::atoi(content.c_str());
  return content == numbered(number) ? number : -1;
}

/// Saves for ever, and reports the saved content's number after each save.
[[noreturn]] void saveForEver(const std::string& file, int first, int told) {
  for (int number = first;; ++number) {
    const SaveResult result = saveFile(file, numbered(number), {std::nullopt, kKeptVersions, true});
    if (!result) ::_exit(1);
    if (::write(told, &number, sizeof number) != sizeof number) ::_exit(1);
  }
}

/// The last number that was reported.
int lastNumberFrom(int told) {
  int number = -1;
  for (int next = 0; ::read(told, &next, sizeof next) == static_cast<ssize_t>(sizeof next);) number = next;
  return number;
}

std::string defectAfterKill(const std::string& file, int told, int before) {
  const int number = numberIn(readWhole(file));
  if (number < 0) return "the file is damaged";
  if (number < std::max(told, before)) return "a save that was told is lost";
  for (const FileVersion& version : earlierVersions(file)) {
    if (numberIn(readWhole(version.path)) < 0) return "an earlier version is damaged";
  }
  return "";
}

unsigned numberFromEnvironment(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::atoi(text));
}

TEST(SaveKills, LoseNothing) {
  const unsigned kills = numberFromEnvironment("GLISSADE_SAVE_KILLS", 100);
  const unsigned seed = numberFromEnvironment("GLISSADE_SAVE_SEED", 1);
  AttackRow row("save: kill -9 at random", seed);
  std::mt19937 random(seed);
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", numbered(1));
  for (unsigned kill = 0; kill < kills; ++kill) {
    const int before = std::max(1, numberIn(readWhole(file)));
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) saveForEver(file, before + 1, pipe[1]);
    ::close(pipe[1]);
    ::usleep(std::uniform_int_distribution<useconds_t>(500, 30000)(random));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    const int told = lastNumberFrom(pipe[0]);
    ::close(pipe[0]);
    row.count(WIFEXITED(status) ? "a save failed without any attack" : defectAfterKill(file, told, before));
  }
}

}  // namespace
}  // namespace glissade
