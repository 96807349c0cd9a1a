#pragma once

namespace glissade {

/// Classes of errors, which determine the command line's exit codes.
enum class ErrorKind {
  NoPath,          ///< the problem is valid and the answer is no (path invalid, none found)
  Usage,           ///< wrong command-line usage or an argument out of range
  MalformedInput,  ///< a file is missing, unreadable or has invalid content
  InCollision,     ///< start or goal penetrates a body
  LimitReached,    ///< time, step or sample limit reached
  Interrupted,     ///< stopped by the user
  Unwritable,      ///< a file, a folder or a stream cannot be written: a full disk, a read-only folder, a closed pipe
  Internal         ///< a defect of the program
};

}  // namespace glissade
