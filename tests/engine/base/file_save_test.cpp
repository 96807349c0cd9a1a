#include "engine/base/file_save.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

#include "engine/base/descriptor.h"
#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::readWhole;
using test::TemporaryFolder;
using testing::HasSubstr;

std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}

struct stat statusOf(const std::string& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
  return status;
}

void makeOld(const std::string& file, int seconds) {
  const timespec then{std::time(nullptr) - seconds, 0};
  const std::array<timespec, 2> times{then, then};
  ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times.data(), 0), 0);
}

/// Runs `work` in a child process, because limits and user ids cannot be restored. True if `work` returned true.
bool inChild(const std::function<bool()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

constexpr uid_t kNobody = 65534;
constexpr uid_t kSomebody = 65533;

bool becomeNobody() {
  return ::setresgid(kNobody, kNobody, kNobody) == 0 && ::setresuid(kNobody, kNobody, kNobody) == 0;
}

void expectFailed(const SaveResult& result, const std::string& file, const std::string& reason) {
  EXPECT_EQ(result.status, SaveStatus::Failed) << file;
  EXPECT_EQ(result.why.file, file);
  EXPECT_THAT(toString(result.why.reason), HasSubstr(reason));
  EXPECT_FALSE(result.why.advice.empty());
}

TEST(SaveFile, ReplacesOnlyWhatTheUserHasSeen) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "seen");
  const SaveResult first = saveFile(file, "mine", {sha256("seen"), 0, false});
  ASSERT_TRUE(first) << toString(first.why);
  EXPECT_EQ(first.sha256, sha256("mine"));
  EXPECT_TRUE(first.warnings.empty());
  folder.write("a.json", "theirs");
  const SaveResult second = saveFile(file, "mine again", {first.sha256, 5, false});
  EXPECT_EQ(second.status, SaveStatus::ChangedByOthers);
  EXPECT_EQ(second.why.file, file);
  EXPECT_FALSE(second.why.advice.empty());
  EXPECT_EQ(readWhole(file), "theirs");
  EXPECT_EQ(namesIn(folder.path()).size(), 1U);
  fs::remove(file);
  EXPECT_EQ(saveFile(file, "mine again", {first.sha256, 5, false}).status, SaveStatus::RemovedByOthers);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_TRUE(saveFile(file, "mine again"));
}

TEST(SaveFile, AContentThatWasOnlyTouchedIsTheSame) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "seen");
  makeOld(file, -3600);
  EXPECT_TRUE(saveFile(file, "mine", {sha256("seen"), 0, false}));
}

TEST(SaveFile, FollowsSymbolicLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/a.json", folder / "one.json");
  fs::create_symlink("one.json", folder / "two.json");
  ASSERT_TRUE(saveFile(folder / "two.json", "first"));  // the file to which the links lead does not exist yet
  ASSERT_TRUE(saveFile(folder / "two.json", "second", {std::nullopt, 5, false}));
  EXPECT_TRUE(fs::is_symlink(folder / "one.json"));
  EXPECT_TRUE(fs::is_symlink(folder / "two.json"));
  EXPECT_EQ(readWhole(folder / "there/a.json"), "second");
  EXPECT_EQ(earlierVersions(folder / "there/a.json").size(), 1U);
  fs::create_symlink("loop", folder / "loop");
  expectFailed(saveFile(folder / "loop", "x"), folder / "loop", "symbolic links");
}

TEST(SaveFile, RefusesWhatIsNoOrdinaryFile) {
  const TemporaryFolder folder;
  expectFailed(saveFile(folder.path(), "x"), folder.path(), "is a folder");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  expectFailed(saveFile(folder / "fifo", "x"), folder / "fifo", "is a pipe");
  expectFailed(saveFile("/dev/null", "x"), "/dev/null", "is a device");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  expectFailed(saveFile("", "x"), "", "no name");
  expectFailed(saveFile(folder / "missing/a.json", "x"), folder / "missing/a.json", "No such file");
}

TEST(SaveFile, RefusesReadOnlyFiles) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  expectFailed(saveFile(file, "new"), file, "read-only");
  EXPECT_EQ(readWhole(file), "old");
}

TEST(SaveFile, SaysThatAFolderIsReadOnly) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  EXPECT_TRUE(inChild([&] {
    if (::geteuid() == 0 && !becomeNobody()) return false;
    const SaveResult result = saveFile(file, "new");
    return result.status == SaveStatus::Failed &&
           toString(result.why.reason).find("Permission denied") != std::string::npos &&
           toString(result.why.advice).find("folder") != std::string::npos;
  }));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_EQ(readWhole(file), "old");
}

TEST(SaveFile, TakesNamesOfTheGreatestLengthAndRefusesLongerOnes) {
  const TemporaryFolder folder;
  const std::string file = folder / (std::string(250, 'n') + ".json");
  ASSERT_TRUE(saveFile(file, "first"));
  const SaveResult second = saveFile(file, "second", {sha256("first"), 5, false});
  ASSERT_TRUE(second) << toString(second.why);
  EXPECT_TRUE(second.warnings.empty());
  EXPECT_EQ(earlierVersions(file).size(), 1U);
  const std::string longer = folder / std::string(256, 'n');
  expectFailed(saveFile(longer, "x"), longer, "name too long");
  EXPECT_THAT(toString(saveFile(longer, "x").why.advice), HasSubstr("shorter"));
}

TEST(SaveFile, ANewFileHasThePermissionsThatTheUserWants) {
  const TemporaryFolder folder;
  EXPECT_TRUE(inChild([&] {
    ::umask(077);
    return bool(saveFile(folder / "private", "x"));
  }));
  EXPECT_EQ(statusOf(folder / "private").st_mode & 0777, 0600U);
  EXPECT_TRUE(inChild([&] {
    ::umask(002);
    return bool(saveFile(folder / "shared", "x"));
  }));
  EXPECT_EQ(statusOf(folder / "shared").st_mode & 0777, 0664U);
}

TEST(SaveFile, KeepsTheOwnerWhereItMayAndSaysWhereItMayNot) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs a user who may change owners";
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  const std::string file = folder.write("a.json", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  ASSERT_EQ(::chown(file.c_str(), kSomebody, kSomebody), 0);
  const SaveResult kept = saveFile(file, "as root");
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept.warnings.empty());
  EXPECT_EQ(statusOf(file).st_uid, kSomebody);
  EXPECT_TRUE(inChild([&] {
    if (!becomeNobody()) return false;
    const SaveResult lost = saveFile(file, "as nobody");
    return lost && lost.warnings.size() == 1 &&
           toString(lost.warnings[0].reason).find("owner and group") != std::string::npos;
  }));
  EXPECT_EQ(statusOf(file).st_uid, kNobody);
  EXPECT_EQ(statusOf(file).st_mode & 0777, 0666U);
}

TEST(SaveFile, SaysThatOtherNamesKeepTheOldContent) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  fs::create_hard_link(file, folder / "b.json");
  const SaveResult result = saveFile(file, "new");
  ASSERT_TRUE(result);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_THAT(toString(result.warnings[0].reason), HasSubstr("1 more name (hard link)"));
  EXPECT_EQ(readWhole(folder / "b.json"), "old");
}

TEST(SaveFile, TellsTheTruthWhenTheFileMayNotGrow) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  EXPECT_TRUE(inChild([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    const SaveResult result = saveFile(file, std::string(5000, 'x'));
    return result.status == SaveStatus::Failed &&
           toString(result.why.reason).find("File too large") != std::string::npos;
  }));
  EXPECT_EQ(readWhole(file), "old");
  EXPECT_EQ(namesIn(folder.path()).size(), 1U);
}

TEST(SaveFile, TellsTheTruthOnAFullDisk) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "disk");
  if (::mount("none", (folder / "disk").c_str(), "tmpfs", 0, "size=64k") != 0) GTEST_SKIP() << "may not mount";
  const std::string file = folder.write("disk/a.json", std::string(20000, 'o'));
  std::vector<SaveResult> results;
  for (const std::size_t size : {1000U, 40000U, 500000U}) {
    results.push_back(saveFile(file, std::string(size, 'n'), {std::nullopt, 5, true}));
    const std::string now = readWhole(file);
    EXPECT_TRUE(now == std::string(size, 'n') || !results.back()) << size;
    EXPECT_TRUE(now == std::string(20000, 'o') || now == std::string(1000, 'n')) << size;
  }
  EXPECT_TRUE(results[0]);
  EXPECT_FALSE(results[1]);
  EXPECT_THAT(toString(results[2].why.reason), HasSubstr("No space left"));
  EXPECT_THAT(toString(results[2].why.advice), HasSubstr("Free some space"));
  EXPECT_EQ(namesIn(folder / "disk").size(), 2U);  // the file and its earlier versions
  ASSERT_EQ(::umount((folder / "disk").c_str()), 0);
}

TEST(SaveFile, RemovesWhatKilledSavesHaveLeft) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  for (const char* name : {".glissade-saving-abcdef", "a.json.saving-ABCdef"}) folder.write(name, "x");
  const Descriptor goesOn(::open(folder.write(".glissade-saving-held22", "x").c_str(), O_RDONLY));
  ASSERT_EQ(::flock(goesOn.get(), LOCK_EX), 0);
  folder.write(".glissade-saving-not-ours", "x");
  folder.write("b.json.saving-ABCdef", "x");
  ASSERT_TRUE(saveFile(file, "new"));
  EXPECT_THAT(namesIn(folder.path()),
              testing::UnorderedElementsAre("a.json", ".glissade-saving-held22", ".glissade-saving-not-ours",
                                            "b.json.saving-ABCdef"));
}

/// A save never takes the new file of another save for one that a killed program has left.
TEST(SaveFile, SavesOfOneFolderAtOnceDoNotDisturbEachOther) {
  const TemporaryFolder folder;
  constexpr int kSaves = 200;
  std::atomic<int> failed{0};
  const auto saveOften = [&](const std::string& name) {
    for (int i = 0; i < kSaves; ++i) failed += saveFile(folder / name, std::to_string(i)) ? 0 : 1;
  };
  std::thread other(saveOften, "a.json");
  saveOften("b.json");
  other.join();
  EXPECT_EQ(failed, 0);
  EXPECT_THAT(namesIn(folder.path()), testing::UnorderedElementsAre("a.json", "b.json"));
  EXPECT_EQ(readWhole(folder / "a.json"), std::to_string(kSaves - 1));
}

TEST(SaveFile, KeepsTheLastEarlierVersions) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.json";
  for (int i = 0; i < 9; ++i) ASSERT_TRUE(saveFile(file, "content " + std::to_string(i), {std::nullopt, 5, true}));
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  makeOld(file, 100000);
  const time_t saved = statusOf(file).st_mtim.tv_sec;
  ASSERT_TRUE(saveFile(file, "content 9", {std::nullopt, 5, true}));
  ASSERT_TRUE(saveFile(file, "content 9", {std::nullopt, 5, true}));  // the same content is no new version
  const std::vector<FileVersion> versions = earlierVersions(file);
  ASSERT_EQ(versions.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(versions[static_cast<std::size_t>(i)].number, 9 - i);
    EXPECT_EQ(readWhole(versions[static_cast<std::size_t>(i)].path), "content " + std::to_string(8 - i));
  }
  EXPECT_EQ(versions[0].time, saved);
  EXPECT_EQ(statusOf(versions[0].path).st_mode & 0777, 0640U);
  EXPECT_EQ(endingOf(versions[0].path), "json");
  EXPECT_THAT(namesIn(folder.path()), testing::UnorderedElementsAre("a.json", ".earlier-versions"));
}

TEST(SaveFile, SaysThatNoEarlierVersionWasKept) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  folder.write(".earlier-versions", "in the way");
  expectFailed(saveFile(file, "new", {std::nullopt, 5, true}), file, "earlier versions cannot be made");
  EXPECT_EQ(readWhole(file), "old");
  const SaveResult result = saveFile(file, "new", {std::nullopt, 5, false});
  ASSERT_TRUE(result);
  EXPECT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(earlierVersions(file).empty());
}

}  // namespace
}  // namespace glissade
