// Attacks that a captured importing process would try.
#include "engine/import/confinement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "engine/base/child_process.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/import/confined_child.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::ChildReport;
using test::reportOf;
using test::say;
using test::TemporaryFolder;

/// A call with the arguments of an attack.
struct Attack {
  const char* name;
  long number;
  std::array<long, 6> arguments;
  bool harmless = false;  ///< it succeeds without the filter, and has no lasting effect
};

template <class T>
long address(const T* pointer) {
  return reinterpret_cast<long>(pointer);
}

/// `file` exists, `other` does not, `page` is the address of a page of data.
std::vector<Attack> attacksOn(pid_t parent, const char* file, const char* other, long page) {
  static std::array<char, 512> buffer{};
  static const iovec local{buffer.data(), 8};
  static const iovec remote{buffer.data(), 8};
  static const char* arguments[] = {"/bin/true", nullptr};
  static const rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
  const long b = address(buffer.data());
  const long f = address(file);
  const long o = address(other);
  constexpr long kData = PROT_READ | PROT_WRITE;
  constexpr long kMemory = MAP_PRIVATE | MAP_ANONYMOUS;
  return {
      {"open", SYS_open, {f, O_RDONLY}, true},
      {"open for writing", SYS_open, {f, O_RDWR}, true},
      {"openat", SYS_openat, {AT_FDCWD, f, O_RDONLY}, true},
      {"openat2", SYS_openat2, {AT_FDCWD, f, b, 24}, true},
      {"creat", SYS_creat, {o, 0600}},
      {"open_by_handle_at", SYS_open_by_handle_at, {AT_FDCWD, b, 0}},
      {"stat", SYS_stat, {f, b}, true},
      {"access", SYS_access, {f, 0}, true},
      {"getdents64", SYS_getdents64, {0, b, 512}},
      {"readlink", SYS_readlink, {address("/proc/self/exe"), b, 512}, true},
      {"unlink", SYS_unlink, {f}},
      {"unlinkat", SYS_unlinkat, {AT_FDCWD, f, 0}},
      {"rename", SYS_rename, {f, o}},
      {"renameat2", SYS_renameat2, {AT_FDCWD, f, AT_FDCWD, o, 0}},
      {"link", SYS_link, {f, o}},
      {"symlink", SYS_symlink, {f, o}},
      {"mkdir", SYS_mkdir, {o, 0700}},
      {"mknod", SYS_mknod, {o, S_IFIFO | 0600, 0}},
      {"truncate", SYS_truncate, {f, 0}},
      {"chmod", SYS_chmod, {f, 0777}},
      {"fchmodat", SYS_fchmodat, {AT_FDCWD, f, 0777, 0}},
      {"chown", SYS_chown, {f, 1, 1}},
      {"utimensat", SYS_utimensat, {AT_FDCWD, f, 0, 0}},
      {"setxattr", SYS_setxattr, {f, address("user.a"), b, 1, 0}},
      {"mount", SYS_mount, {f, f, 0, MS_ASYNC, 0}},
      {"chroot", SYS_chroot, {address("/")}},
      {"socket", SYS_socket, {AF_INET, SOCK_STREAM, 0}, true},
      {"socket (unix)", SYS_socket, {AF_UNIX, SOCK_STREAM, 0}, true},
      {"socketpair", SYS_socketpair, {AF_UNIX, SOCK_STREAM, 0, b}, true},
      {"connect", SYS_connect, {0, b, 16}},
      {"sendto", SYS_sendto, {0, b, 1, 0, 0, 0}},
      {"io_uring_setup", SYS_io_uring_setup, {1, b}},
      {"io_uring_enter", SYS_io_uring_enter, {0, 1, 0, 0, 0}},
      {"io_setup", SYS_io_setup, {1, b}},
      {"execve", SYS_execve, {address("/bin/true"), address(&arguments[0]), 0}},
      {"execveat", SYS_execveat, {AT_FDCWD, address("/bin/true"), address(&arguments[0]), 0, 0}},
      {"fork", SYS_fork, {}},
      {"vfork", SYS_vfork, {}},
      {"clone", SYS_clone, {SIGCHLD}},
      {"clone3", SYS_clone3, {b, 64}},
      {"unshare", SYS_unshare, {CLONE_FILES}, true},
      {"setns", SYS_setns, {0, 0}},
      {"ptrace", SYS_ptrace, {PTRACE_SEIZE, parent, 0, 0}},
      {"process_vm_readv", SYS_process_vm_readv, {parent, address(&local), 1, address(&remote), 1, 0}},
      {"process_vm_writev", SYS_process_vm_writev, {parent, address(&local), 1, address(&remote), 1, 0}},
      {"kill", SYS_kill, {parent, 0}, true},
      {"tgkill", SYS_tgkill, {parent, parent, 0}, true},
      {"pidfd_open", SYS_pidfd_open, {parent, 0}, true},
      {"prlimit64 of the parent", SYS_prlimit64, {parent, RLIMIT_NOFILE, 0, b}, true},
      {"prlimit64", SYS_prlimit64, {0, RLIMIT_AS, address(&unlimited), 0}},
      {"setpriority", SYS_setpriority, {PRIO_PROCESS, parent, 0}},
      {"memfd_create", SYS_memfd_create, {address("x"), 0}, true},
      {"memfd_secret", SYS_memfd_secret, {0}},
      {"shmget", SYS_shmget, {0, 4096, 0600}},
      {"mmap writable and executable", SYS_mmap, {0, 4096, kData | PROT_EXEC, kMemory, -1, 0}, true},
      {"mmap executable", SYS_mmap, {0, 4096, PROT_READ | PROT_EXEC, kMemory, -1, 0}, true},
      {"mprotect executable", SYS_mprotect, {page, 4096, PROT_READ | PROT_EXEC}, true},
      {"pkey_mprotect executable", SYS_pkey_mprotect, {page, 4096, PROT_READ | PROT_EXEC, -1}},
      {"bpf", SYS_bpf, {0, b, 64}},
      {"perf_event_open", SYS_perf_event_open, {b, 0, -1, -1, 0}},
      {"userfaultfd", SYS_userfaultfd, {0}},
      {"add_key", SYS_add_key, {address("user"), address("x"), b, 1, -3}},
      {"keyctl", SYS_keyctl, {0, -3, 0}},
      {"prctl", SYS_prctl, {PR_GET_DUMPABLE}, true},
      {"seccomp", SYS_seccomp, {SECCOMP_GET_ACTION_AVAIL, 0, b}},
      {"rt_sigaction", SYS_rt_sigaction, {SIGUSR1, 0, 0, 8}, true},
      {"setuid", SYS_setuid, {0}},
      {"fcntl", SYS_fcntl, {0, F_GETFL}, true},
      {"ioctl", SYS_ioctl, {0, 0x5412, b}},
      {"dup", SYS_dup, {0}, true},
      {"pipe2", SYS_pipe2, {b, 0}, true},
      {"eventfd2", SYS_eventfd2, {0, 0}, true},
      {"inotify_init1", SYS_inotify_init1, {0}, true},
      {"timer_create", SYS_timer_create, {0, 0, b}},
      {"mq_open", SYS_mq_open, {address("x"), O_RDWR | O_CREAT, 0600, 0}},
      {"splice", SYS_splice, {0, 0, 3, 0, 1, 0}},
      {"sendfile", SYS_sendfile, {3, 0, 0, 1}},
      {"reboot", SYS_reboot, {0, 0, 0, 0}},
  };
}

constexpr import_protocol::Limits kLimits{450ULL << 20U, 4, 1ULL << 20U, std::chrono::milliseconds(4500)};

void confineOrEnd() {
  if (const Outcome confined = confine(kLimits); !confined) {
    say(toString(confined.error().reason));
    test::end(12);
  }
}

std::string outcomeOf(const Attack& attack) {
  const std::array<long, 6>& a = attack.arguments;
  const long result = ::syscall(attack.number, a[0], a[1], a[2], a[3], a[4], a[5]);
  return result >= 0 ? "succeeds" : errno == EPERM ? "refused" : std::strerror(errno);
}

class Confinement : public testing::Test {
 protected:
  /// Tries every attack, or every harmless one, in a child; returns the names of those with another outcome than
  /// expected.
  std::string attacksThatAreNot(const std::string& expected, bool confined) const {
    const pid_t parent = ::getpid();
    const ChildReport report = reportOf([&] {
      void* page = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (confined) confineOrEnd();
      for (const Attack& attack : attacksOn(parent, file_.c_str(), other_.c_str(), reinterpret_cast<long>(page))) {
        if (!confined && !attack.harmless) continue;
        const std::string outcome = outcomeOf(attack);
        if (outcome != expected) say(std::string(attack.name) + " " + outcome + "\n");
      }
    });
    EXPECT_TRUE(report.exited()) << report.status;
    return report.text;
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.write("file", "content");
  std::string other_ = folder_ / "other";
};

TEST_F(Confinement, RefusesEveryAttack) { EXPECT_EQ(attacksThatAreNot("refused", true), ""); }

TEST_F(Confinement, TheHarmlessAttacksSucceedWithoutIt) { EXPECT_EQ(attacksThatAreNot("succeeds", false), ""); }

TEST_F(Confinement, PermitsWhatAnImportNeeds) {
  const ChildReport report = reportOf([] {
    confineOrEnd();
    std::vector<char> large(200U << 20U, 'x');
    std::vector<std::unique_ptr<std::string>> small;
    for (int i = 0; i < 10000; ++i) small.push_back(std::make_unique<std::string>(100, 'y'));
    try {
      throw std::runtime_error("thrown");
    } catch (const std::exception& error) {
      say(error.what());
    }
    const auto now = std::chrono::steady_clock::now();
    say(readStandardInput(100).empty() && large.back() == 'x' && now.time_since_epoch().count() > 0 ? " read" : "");
  });
  EXPECT_TRUE(report.exited()) << report.status;
  EXPECT_EQ(report.text, "thrown read");
}

TEST_F(Confinement, MoreMemoryThanTheLimitIsRefused) {
  if (!kMemoryCanBeLimited) GTEST_SKIP() << "not under this sanitizer";
  const ChildReport report = reportOf([] {
    confineOrEnd();
    say(::malloc(kLimits.memory) == nullptr ? "refused" : "given");
  });
  EXPECT_EQ(report.text, "refused");
}

/// The content of /proc/PID/NAME of a confined child that waits.
std::string procFileOfConfined(const std::string& name) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) return "";
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(pipe[1], kOutputDescriptor);
    confineOrEnd();
    say("x");
    while (true) {
    }
  }
  char ready = 0;
  [[maybe_unused]] const ssize_t count = ::read(pipe[0], &ready, 1);
  std::string content = test::readWhole("/proc/" + std::to_string(pid) + "/" + name);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
  ::close(pipe[0]);
  ::close(pipe[1]);
  return content;
}

TEST_F(Confinement, HasNoPrivilegeAndItsLimits) {
  using testing::ContainsRegex;
  const std::string status = procFileOfConfined("status");
  EXPECT_THAT(status, ContainsRegex("NoNewPrivs:\t1\n"));
  EXPECT_THAT(status, ContainsRegex("Seccomp:\t2\n"));
  EXPECT_THAT(status, ContainsRegex("CapEff:\t0000000000000000\n"));
  EXPECT_THAT(status, ContainsRegex("CapPrm:\t0000000000000000\n"));
  const std::string limits = procFileOfConfined("limits");
  for (const char* none : {"Max file size", "Max core file size", "Max processes", "Max open files"}) {
    EXPECT_THAT(limits, ContainsRegex(std::string(none) + " +0 +0 ")) << limits;
  }
  EXPECT_THAT(limits, ContainsRegex("Max cpu time +4 +5 "));
}

/// Namespaces, limits and capabilities must not undo the signal at the parent's death.
TEST_F(Confinement, DiesWithItsParent) {
  // The pipe is at its end when every process that can write to it is gone.
  const ChildReport report = reportOf([] {
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) test::end(1);
      confineOrEnd();
      say("confined");
      while (true) {
      }
    }
    ::usleep(200'000);
  });
  EXPECT_EQ(report.text, "confined");
}

/// From this call on the kernel refuses `call` with EPERM, as in a container that does not permit it.
void refuse(int call, std::initializer_list<scmp_arg_cmp> conditions = {}) {
  scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ALLOW);
  const std::vector<scmp_arg_cmp> list(conditions);
  ::seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), call, static_cast<unsigned>(list.size()), list.data());
  ::seccomp_load(filter);
  ::seccomp_release(filter);
}

/// The condition that the first argument of a call has this value. The macro of libseccomp is C.
scmp_arg_cmp firstIs(scmp_datum_t value) { return {0, SCMP_CMP_EQ, value, 0}; }

void refuseFilters() {
  refuse(SCMP_SYS(prctl), {firstIs(PR_SET_SECCOMP)});
  refuse(SCMP_SYS(seccomp));
}

TEST_F(Confinement, IsAnErrorWhereAStepIsRefused) {
  const std::vector<std::pair<const char*, void (*)()>> steps{
      {"filter of system calls", refuseFilters},
      {"a limit", [] { refuse(SCMP_SYS(prlimit64)); }},
      {"capabilities", [] { refuse(SCMP_SYS(capset)); }},
      {"new privileges", [] { refuse(SCMP_SYS(prctl), {firstIs(PR_SET_NO_NEW_PRIVS)}); }},
  };
  for (const auto& [what, refuseStep] : steps) {
    const ChildReport report = reportOf([step = refuseStep] {
      step();
      confineOrEnd();
    });
    EXPECT_THAT(report.text, testing::HasSubstr(what));
    EXPECT_EQ(WEXITSTATUS(report.status), 12);
  }
}

TEST_F(Confinement, WhereItIsRefusedNothingIsImported) {
  const std::string mesh = folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(importMesh(mesh).ok());
  const ChildReport report = reportOf([&] {
    refuseFilters();
    const auto imported = importMesh(mesh);
    say(imported ? "imported" : toString(imported.error()));
  });
  EXPECT_THAT(report.text, testing::HasSubstr("a.obj: was not read: the importing process cannot give up its rights"));
}

}  // namespace
}  // namespace glissade
