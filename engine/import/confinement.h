#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/import/import_protocol.h"

namespace glissade {

/// Permanently gives up all rights that reading a file does not need: memory and processor time above the limits,
/// files, processes, threads, the network, capabilities, and every system call that is not listed in
/// system_call_filter.h. Creates namespaces if the kernel permits it. Precondition: an ImportOutput exists. Errors are
/// Internal: the process must then end without reading anything.
Outcome confine(const import_protocol::Limits& limits);

/// Size of standard input if it is a file; else 0. Precondition: confine() has not been called.
std::size_t sizeOfStandardInput();

/// All of standard input; empty if it is larger than `mostBytes`. `expected`: number of bytes; there may be more.
std::vector<char> readStandardInput(std::uint64_t mostBytes, std::size_t expected = 0);

/// JSON as one line of a message. Bytes that are not UTF-8 are replaced.
std::string lineOf(const nlohmann::json& json);

/// Output of an importing process: the former standard output (kOutputDescriptor). Text that libraries print to
/// standard output is dropped from construction on.
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
  /// Writes the message that the file cannot be read, and returns the exit code. `location` is in the file.
  int fail(const Message& reason, const Location& location = {}) const;
  /// Writes the message that this process cannot confine itself, and returns the exit code.
  int refuse(const Diagnostic& why) const;

 private:
  int writeText(std::uint32_t kind, const Location& location, const Message& reason) const;
};

}  // namespace glissade
