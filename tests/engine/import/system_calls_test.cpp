// Tests every number of a system call: the filter of the importing processes permits only the listed ones.
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <iostream>
#include <set>
#include <sstream>

#include "engine/base/child_process.h"
#include "tests/engine/import/confined_child.h"

namespace glissade {
namespace {

using test::ChildReport;
using test::reportOf;
using test::say;

/// Above the last number of kernel 6.x, with room.
constexpr long kNumbers = 1024;
/// uretprobe and uprobe: the kernel (6.11 and later) lets them pass every filter, because only its probes use them, and
/// ends a process that makes them elsewhere with SIGILL.
bool passesEveryFilter(long number) { return number == 335 || number == 336; }

/// The last argument of a call that must not run.
constexpr std::uint32_t kCookie = 0x5AFEC411;

using Arguments = std::array<long, 5>;

/// From this call on no call with the cookie runs: the kernel answers ENOSYS unless a later filter refuses the call
/// (SECCOMP_RET_TRACE without a tracer). A permitted call therefore has no effect.
void preventCallsWithCookie() {
  std::array<sock_filter, 4> program{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[5])),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kCookie, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRACE),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  }};
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) test::end(10);
}

bool isPermitted(long number, const Arguments& a) {
  errno = 0;
  ::syscall(number, a[0], a[1], a[2], a[3], a[4], kCookie);
  if (errno != EPERM && errno != ENOSYS) test::end(11);
  return errno == ENOSYS;
}

/// The numbers that a child prints after it has loaded the filter.
template <class Work>
std::set<long> numbersFrom(const Work& work, bool filtered = true) {
  const ChildReport report = reportOf([&] {
    preventCallsWithCookie();
    if (filtered && !loadSystemCallFilter()) test::end(12);
    work();
  });
  EXPECT_TRUE(report.exited()) << report.status;
  std::istringstream text(report.text);
  std::set<long> numbers;
  for (long number = 0; text >> number;) numbers.insert(number);
  return numbers;
}

void sayPermittedNumbers() {
  constexpr long kData = PROT_READ | PROT_WRITE;
  constexpr long kMemory = MAP_PRIVATE | MAP_ANONYMOUS;
  for (long number = 0; number < kNumbers; ++number) {
    if (passesEveryFilter(number)) continue;
    bool permitted = false;
    for (const Arguments& arguments : {Arguments{0, 4096, kData, kMemory, -1}, Arguments{1, 4096, kData, kMemory, -1},
                                       Arguments{2, 4096, kData, kMemory, -1}, Arguments{3, 4096, kData, kMemory, -1},
                                       Arguments{0, 0, 0, 0, 0}, Arguments{-1, -1, -1, -1, -1}}) {
      permitted = permitted || isPermitted(number, arguments);
    }
    if (permitted) say(std::to_string(number) + "\n");
  }
}

class SystemCalls : public testing::Test {
 protected:
  void SetUp() override {
    if (!kMemoryCanBeLimited) GTEST_SKIP() << "the sanitizers need more system calls";
  }
};

TEST_F(SystemCalls, OnlyTheListIsPermitted) {
  const std::set<long> list{SYS_read,         SYS_write,        SYS_mmap,         SYS_mprotect, SYS_munmap,
                            SYS_mremap,       SYS_madvise,      SYS_brk,          SYS_futex,    SYS_clock_gettime,
                            SYS_clock_getres, SYS_gettimeofday, SYS_rt_sigreturn, SYS_exit,     SYS_exit_group};
  const std::set<long> permitted = numbersFrom(sayPermittedNumbers);
  EXPECT_EQ(permitted, list);
  const long wrong = std::count_if(permitted.begin(), permitted.end(), [&](long n) { return list.count(n) == 0; });
  std::cout << "ROW system calls of an importer, of which " << permitted.size() << " are permitted | " << kNumbers - 2
            << " | " << kNumbers - 2 - wrong << " | " << wrong << " | - | - | -\n";
}

TEST_F(SystemCalls, WithoutTheFilterAllArePermitted) {
  EXPECT_EQ(numbersFrom(sayPermittedNumbers, false).size(), static_cast<std::size_t>(kNumbers) - 2);
}

TEST_F(SystemCalls, OnlyTheInputIsReadAndOnlyTheOutputIsWritten) {
  const auto descriptorsOf = [](long number) {
    return numbersFrom([=] {
      for (long fd = -2; fd < 200; ++fd) {
        if (isPermitted(number, {fd, 0, 0, 0, 0})) say(std::to_string(fd) + "\n");
        if (isPermitted(number, {fd + (1L << 32), 0, 0, 0, 0})) say("999\n");
      }
    });
  };
  EXPECT_EQ(descriptorsOf(SYS_read), std::set<long>{kInputDescriptor});
  EXPECT_EQ(descriptorsOf(SYS_write), std::set<long>{kOutputDescriptor});
}

TEST_F(SystemCalls, NoMemoryCanHoldNewCode) {
  const std::set<long> data{PROT_NONE, PROT_READ, PROT_WRITE, PROT_READ | PROT_WRITE};
  const auto protectionsOf = [](long number, long flags) {
    return numbersFrom([=] {
      for (long protection = 0; protection < 64; ++protection) {
        if (isPermitted(number, {0, 4096, protection, flags, -1})) say(std::to_string(protection) + "\n");
        if (isPermitted(number, {0, 4096, protection | (1L << 40), flags, -1})) say("999\n");
      }
    });
  };
  EXPECT_EQ(protectionsOf(SYS_mmap, MAP_PRIVATE | MAP_ANONYMOUS), data);
  EXPECT_EQ(protectionsOf(SYS_mmap, MAP_PRIVATE), std::set<long>{});  // mapping of a file
  EXPECT_EQ(protectionsOf(SYS_mprotect, 0), data);
  EXPECT_EQ(protectionsOf(SYS_pkey_mprotect, 0), std::set<long>{});
}

#if defined(__x86_64__)
int signalOf(void (*call)(long), long number) {
  return reportOf([=] {
           if (!loadSystemCallFilter()) test::end(12);
           call(number);
         })
      .signal();
}

TEST_F(SystemCalls, ProbeCallsAreRefusedOrEndTheProcess) {
  for (const long number : {335L, 336L}) {
    const ChildReport report = reportOf([=] {
      if (!loadSystemCallFilter()) test::end(12);
      say(::syscall(number, 0, 0, 0, 0, 0, 0) < 0 ? "refused" : "permitted");
    });
    EXPECT_TRUE(report.signal() == SIGILL || report.text == "refused") << number;
  }
}

TEST_F(SystemCalls, EveryCallOfX32EndsTheProcess) {
  constexpr long kX32 = 0x40000000;
  for (long number = 0; number < 560; ++number) {
    EXPECT_EQ(signalOf([](long n) { ::syscall(n, 0, 0, 0, 0, 0, 0); }, kX32 + number), SIGSYS) << number;
  }
}

TEST_F(SystemCalls, CallsOf32BitEndTheProcess) {
  for (long number = 0; number < 470; number += 5) {
    const int signal =
        signalOf([](long n) { asm volatile("int $0x80"
                                           : "+a"(n)
                                           : "b"(0L), "c"(0L), "d"(0L)); }, number);
    EXPECT_TRUE(signal == SIGSYS || signal == SIGSEGV) << number;  // SIGSEGV: the kernel has no such ABI
  }
}
#endif

}  // namespace
}  // namespace glissade
