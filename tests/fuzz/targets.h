#pragma once

#include <string>
#include <vector>

namespace glissade::fuzz {

/// One format that Glissade reads. `run` gives any bytes to the reader of that format, in this process. It returns the
/// reader's error, empty where the bytes are accepted, and aborts where the result breaks the contract: an error
/// without a reason, a text that cannot be displayed, a value beyond the limits, a scenario that is not written as it
/// was read.
struct Target {
  std::string name;  ///< name of the target and of its corpus folder
  std::string (*run)(const std::string& bytes);
  std::vector<std::string> words;  ///< words that mutations insert
};

const std::vector<Target>& targets();

/// The target with this name; null where there is none.
const Target* findTarget(const std::string& name);

}  // namespace glissade::fuzz
