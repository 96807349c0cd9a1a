#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/import/import_protocol.h"

namespace glissade {

/// Gives up for good what reading a file does not need: memory and processor time above the limits,
/// files, processes, threads, the network, capabilities, and every system call that is not listed in
/// system_call_filter.h. Makes namespaces of its own where the kernel permits it. An ImportOutput must
/// exist before. Errors are Internal: the process must then read nothing and end.
Outcome confine(const import_protocol::Limits& limits);

/// Of standard input, where that is a file; else 0. To be asked before confine().
std::size_t sizeOfStandardInput();

/// All of standard input; empty where it is larger than `mostBytes`. `expected`: bytes; there may be more.
std::vector<char> readStandardInput(std::uint64_t mostBytes, std::size_t expected = 0);

/// Where an importing process writes its message: what was standard output when this was made
/// (kOutputDescriptor). What libraries print to standard output is dropped from then on.
class ImportOutput {
 public:
  ImportOutput();
  ImportOutput(const ImportOutput&) = delete;
  ImportOutput& operator=(const ImportOutput&) = delete;

  void write(const void* data, std::size_t size) const;
  template <class T>
  void write(const std::vector<T>& values) const {
    write(values.data(), values.size() * sizeof(T));
  }
  /// The message that the file cannot be read, and the exit code that goes with it. `location` is in the file.
  int fail(const std::string& reason, const std::string& location = {}) const;
  /// The message that this process cannot confine itself, and the exit code that goes with it.
  int refuse(const Diagnostic& why) const;

 private:
  int writeText(std::uint32_t kind, const std::string& location, const std::string& reason) const;
};

}  // namespace glissade
