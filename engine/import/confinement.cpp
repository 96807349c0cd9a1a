#include "engine/import/confinement.h"

#include <linux/capability.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/base/child_process.h"
#include "engine/base/message_json.h"
#include "engine/base/reserve_filled.h"
#include "engine/import/system_call_filter.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

Diagnostic failed(CatalogueText what) {
  return {ErrorKind::Internal, "", "", {GLISSADE_TEXT("%1: %2"), {what, std::strerror(errno)}}, {}};
}

/// Never raises a lower limit.
bool setLimit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0) return false;
  limit.rlim_max = std::min(limit.rlim_max, hard);
  limit.rlim_cur = std::min({limit.rlim_cur, limit.rlim_max, soft});
  return ::setrlimit(resource, &limit) == 0;
}

Outcome limitResources(const protocol::Limits& limits) {
  for (const __rlimit_resource resource :
       {RLIMIT_CORE, RLIMIT_FSIZE, RLIMIT_NOFILE, RLIMIT_NPROC, RLIMIT_MEMLOCK, RLIMIT_MSGQUEUE}) {
    if (!setLimit(resource, 0, 0)) return failed(GLISSADE_TEXT("a limit cannot be set"));
  }
  // SIGXCPU at the first limit tells why the process ended; SIGKILL at the second one cannot be ignored.
  if (!setLimit(RLIMIT_CPU, limits.seconds, limits.seconds + 1)) {
    return failed(GLISSADE_TEXT("the time cannot be limited"));
  }
  if (kMemoryCanBeLimited && !setLimit(RLIMIT_AS, limits.memory, limits.memory)) {
    return failed(GLISSADE_TEXT("the memory cannot be limited"));
  }
  return Done{};
}

/// Best effort: many kernels and containers do not permit it, and the filter does not depend on it.
void leaveNamespaces() {
  constexpr int kNamespaces = CLONE_NEWNET | CLONE_NEWNS | CLONE_NEWIPC | CLONE_NEWPID | CLONE_NEWUTS;
  if (::unshare(CLONE_NEWUSER | kNamespaces) != 0) ::unshare(kNamespaces);
}

Outcome dropCapabilities() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  if (::syscall(SYS_capset, &header, none.data()) != 0) {
    return failed(GLISSADE_TEXT("the capabilities cannot be given up"));
  }
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
    return failed(GLISSADE_TEXT("new privileges cannot be given up"));
  }
  return Done{};
}

}  // namespace

Outcome confine(const protocol::Limits& limits) {
  leaveNamespaces();
  if (const Outcome limited = limitResources(limits); !limited) return limited;
  if (const Outcome dropped = dropCapabilities(); !dropped) return dropped;
  return loadSystemCallFilter();
}

std::size_t sizeOfStandardInput() {
  struct stat status {};
  const bool file = ::fstat(kInputDescriptor, &status) == 0 && S_ISREG(status.st_mode);
  return file ? static_cast<std::size_t>(status.st_size) : 0;
}

std::vector<char> readStandardInput(std::uint64_t mostBytes, std::size_t expected) {
  std::vector<char> content;
  reserveFilled(content, std::min<std::uint64_t>(expected, mostBytes));
  std::array<char, 65536> buffer{};
  ssize_t count = 0;
  while ((count = ::read(kInputDescriptor, buffer.data(), buffer.size())) > 0) {
    content.insert(content.end(), buffer.begin(), buffer.begin() + count);
    if (content.size() > mostBytes) return {};
  }
  return content;
}

std::string lineOf(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ImportOutput::ImportOutput() {
  ::dup2(STDOUT_FILENO, kOutputDescriptor);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

void ImportOutput::write(const void* data, std::size_t size) const {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = ::write(kOutputDescriptor, bytes, size);
    if (count <= 0) return;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

int ImportOutput::fail(const Message& reason, const Location& location) const {
  return writeText(protocol::kError, location, reason);
}

int ImportOutput::refuse(const Diagnostic& why) const { return writeText(protocol::kNotConfined, {}, why.reason); }

int ImportOutput::writeText(std::uint32_t kind, const Location& location, const Message& reason) const {
  const std::string text = lineOf({{"location", toJson(location)}, {"reason", toJson(reason)}});
  protocol::Header header;
  header.kind = kind;
  header.vertices = static_cast<std::uint32_t>(text.size());
  write(&header, sizeof header);
  write(text.data(), text.size());
  return 1;
}

}  // namespace glissade
