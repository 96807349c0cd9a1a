#include "engine/import/import_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

/// A nameless file in memory.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  bool write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::lseek(descriptor_, 0, SEEK_SET) == 0;
  }

  std::string content() const {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    std::string result(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    std::size_t done = 0;
    while (done < result.size()) {
      const ssize_t got = ::pread(descriptor_, result.data() + done, result.size() - done, static_cast<off_t>(done));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      done += static_cast<std::size_t>(got);
    }
    result.resize(done);
    return result;
  }

 private:
  int descriptor_;
};

Diagnostic cannotStart(const std::string& program, int error) {
  return {ErrorKind::Internal, program, "",
          "the importing program cannot be started (" + std::string(std::strerror(error)) + ")",
          "Install it beside the program that runs."};
}

std::string programPath() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (self.parent_path() / kImportProgram).string();
}

/// Starts the program with the two files as standard input and output and nothing else open.
int spawn(const std::string& program, const std::string& ending, const MemoryFile& in, const MemoryFile& out,
          pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  std::string name = program;
  std::string argument = ending;
  const std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

/// Waits for the end of the child; kills it at the deadline. Returns whether it ended by itself.
bool waitUntil(pid_t child, Clock::time_point deadline) {
  while (true) {
    const pid_t ended = ::waitpid(child, nullptr, WNOHANG);
    const bool stillRunning = ended == 0 || (ended < 0 && errno == EINTR);
    if (!stillRunning) return true;
    if (Clock::now() >= deadline) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ::kill(child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  return false;
}

}  // namespace

Result<std::string> runImportProcess(std::string_view content, const std::string& ending) {
  const std::string program = programPath();
  MemoryFile in("glissade-import-in");
  const MemoryFile out("glissade-import-out");
  if (in.descriptor() < 0 || out.descriptor() < 0 || !in.write(content)) return cannotStart(program, errno);

  pid_t child = 0;
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(kImportSeconds);
  if (const int error = spawn(program, ending, in, out, child)) return cannotStart(program, error);
  if (!waitUntil(child, deadline)) {
    return Diagnostic{ErrorKind::MalformedInput, "", "",
                      "the import took more than " + std::to_string(kImportSeconds) + " s",
                      "The file is damaged, or too large: reduce its triangles and export it again."};
  }
  return out.content();
}

}  // namespace glissade
