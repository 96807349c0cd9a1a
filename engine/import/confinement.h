#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/import/import_protocol.h"

namespace glissade {

/// Gives up for good what reading a file from standard input does not need: memory and processor time
/// above the limits, files, processes, the network. Where the kernel refuses the filter the limits hold.
void confine(const import_protocol::Limits& limits);

/// All of standard input; empty where it is larger than `mostBytes`.
std::vector<char> readStandardInput(std::uint64_t mostBytes);

/// Where an importing process writes its message: what was standard output when this was made. What
/// libraries print there from then on goes to standard error.
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
  /// The message that there is nothing, and the exit code that goes with it.
  int fail(const std::string& reason) const;

 private:
  int descriptor_;
};

}  // namespace glissade
