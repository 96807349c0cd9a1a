#pragma once

#include <string>
#include <vector>

namespace glissade::fuzz {

/// One format that Glissade reads. `run` gives any bytes to the reader of that format, in this process. It returns the
/// reader's error, empty where the bytes are accepted, and aborts where the answer breaks a promise: an error without a
/// reason, a text that cannot be shown, a value beyond the limits, a scenario that is written differently from what was
/// read.
struct Target {
  std::string name;  ///< also the folder of its corpus
  std::string (*run)(const std::string& bytes);
  std::vector<std::string> words;  ///< that mutations insert
};

const std::vector<Target>& targets();

/// Null where there is none of that name.
const Target* findTarget(const std::string& name);

}  // namespace glissade::fuzz
