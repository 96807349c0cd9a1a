#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/base/message.h"

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

/// The documented process exit code of an error: 1 no path, 2 usage, 3 malformed input or unwritable,
/// 4 in collision, 5 limit reached, 130 interrupted, 70 internal.
int exitCode(ErrorKind kind);

/// A place in a file or in a command: a JSON pointer or an option as it is, or a message ("line 3").
struct Location : Message {
  using Message::Message;
  Location(Message message) : Message(std::move(message)) {}
  Location(std::string text) : Message(std::move(text)) {}
  Location(const char* text) : Message(text) {}
};

/// One error or warning about the user's input. Every part is a sentence fragment; `file` and `location` may be empty.
struct Diagnostic {
  ErrorKind kind = ErrorKind::Internal;
  std::string file;   ///< path as the user wrote it
  Location location;  ///< line, JSON pointer, link name, ... inside the file
  Message reason;     ///< the fault
  Message advice;     ///< the remedy
};

/// The text "file: location: reason. advice" without the empty parts.
std::string toString(const Diagnostic& diagnostic, const MessageStyle& style = {});

/// Warnings gathered beside a successful result.
using Warnings = std::vector<Diagnostic>;

}  // namespace glissade
