#include "engine/import/confinement.h"

#include <seccomp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace glissade {
namespace {

namespace protocol = import_protocol;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // its shadow memory needs terabytes of address space
#else
constexpr bool kSanitized = false;
#endif

void limitResources(const protocol::Limits& limits) {
  // At the first of the two a signal says why, at the second there is no way out.
  const rlimit seconds{limits.seconds, limits.seconds + 1};
  setrlimit(RLIMIT_CPU, &seconds);
  const rlimit memory{limits.memory, limits.memory};
  if (!kSanitized) setrlimit(RLIMIT_AS, &memory);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

/// No file, no process, no network from here on.
void forbidFiles() {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (filter == nullptr) return;
  const std::array<int, 10> forbidden{SCMP_SYS(open),   SCMP_SYS(openat),   SCMP_SYS(openat2), SCMP_SYS(creat),
                                      SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(fork),    SCMP_SYS(socket),
                                      SCMP_SYS(unlink), SCMP_SYS(rename)};
  for (const int call : forbidden) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), call, 0);
  seccomp_load(filter);
  seccomp_release(filter);
}

}  // namespace

void confine(const protocol::Limits& limits) {
  limitResources(limits);
  forbidFiles();
}

std::vector<char> readStandardInput(std::uint64_t mostBytes) {
  std::vector<char> content;
  std::array<char, 65536> buffer{};
  ssize_t count = 0;
  while ((count = ::read(STDIN_FILENO, buffer.data(), buffer.size())) > 0) {
    content.insert(content.end(), buffer.begin(), buffer.begin() + count);
    if (content.size() > mostBytes) return {};
  }
  return content;
}

ImportOutput::ImportOutput() : descriptor_(::dup(STDOUT_FILENO)) { ::dup2(STDERR_FILENO, STDOUT_FILENO); }

void ImportOutput::write(const void* data, std::size_t size) const {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = ::write(descriptor_, bytes, size);
    if (count <= 0) return;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

int ImportOutput::fail(const std::string& reason) const {
  protocol::Header header;
  header.kind = protocol::kError;
  header.vertices = static_cast<std::uint32_t>(reason.size());
  write(&header, sizeof header);
  write(reason.data(), reason.size());
  return 1;
}

}  // namespace glissade
