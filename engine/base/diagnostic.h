#pragma once

#include <glissade/error_kind.h>

#include <string>
#include <utility>
#include <vector>

#include "engine/base/message.h"

namespace glissade {

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
