#pragma once

#include <string>
#include <vector>

namespace glissade {

/// What went wrong, in the classes that the command line's exit codes distinguish.
enum class ErrorKind {
  NoPath,          ///< the question was well posed and the answer is no (path invalid, none found)
  Usage,           ///< wrong command-line usage or an argument out of range
  MalformedInput,  ///< a file is missing, unreadable or says something impossible
  InCollision,     ///< start or goal penetrates a body
  LimitReached,    ///< time, step or sample limit reached
  Interrupted,     ///< stopped by the user
  Unwritable,      ///< a file, a folder or a stream takes nothing: a full disk, a read-only folder, a pipe
  Internal         ///< a defect of the program
};

/// The documented process exit code of an error: 1 no path, 2 usage, 3 malformed input or unwritable,
/// 4 in collision, 5 limit reached, 130 interrupted, 70 internal.
int exitCode(ErrorKind kind);

/// One error or warning about something the user gave us. Every part is a sentence fragment in
/// plain English; `file` and `location` may be empty where there is none.
struct Diagnostic {
  ErrorKind kind = ErrorKind::Internal;
  std::string file;      ///< path as the user wrote it
  std::string location;  ///< line, JSON pointer, link name, ... inside the file
  std::string reason;    ///< what is wrong
  std::string advice;    ///< what to do about it
};

/// "file: location: reason. advice" with the empty parts left out.
std::string toString(const Diagnostic& diagnostic);

/// Warnings gathered beside a successful result.
using Warnings = std::vector<Diagnostic>;

}  // namespace glissade
