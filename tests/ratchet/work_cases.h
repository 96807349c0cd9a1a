#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "tests/ratchet/work.h"

namespace glissade::ratchet {

/// A command line whose work is counted.
struct WorkCase {
  std::string family;
  std::string name;
  std::string command;  ///< as a line of cases.txt has it
};

/// Folders that the command lines name.
struct WorkFolders {
  std::string programs;  ///< of glissade-cli and the importers
  std::string samples;
  std::string steps;    ///< files of tests/step_files
  std::string made;     ///< problems of generate-made-problems
  std::string open;     ///< public problems; they are left out where the folder is absent
  std::string scratch;  ///< for what cases write
  std::string counter;  ///< the library heap_count
};

/// The cases of a file. Errors: MalformedInput with the line.
Result<std::vector<WorkCase>> readCases(const std::string& file);

/// Whether the case's files are there: public problems may be absent.
bool isThere(const WorkCase& each, const WorkFolders& folders);

/// Carries the case out. Errors: Internal with what the program has said where it does not do its work.
Result<WorkRow> measured(const WorkCase& each, std::uint64_t seed, const WorkFolders& folders);

}  // namespace glissade::ratchet
