#pragma once

#include <string>

#include "engine/base/json_reader.h"

namespace glissade {

/// The member "checksum" of a JSON object: "sha256:" and the SHA-256 of the object's compact text without that member
/// (no white space, the keys in their order, numbers in their shortest form). White space may change; values, keys and
/// their order may not. Private to readers and writers of files.

/// Adds the member as the last one.
void addChecksum(JsonCursor::Json& object);

enum class ChecksumState { Missing, Right, Wrong };
/// Removes the member and compares it.
ChecksumState takeChecksum(JsonCursor::Json& document);

/// Adds the member to the JSON schema of a document.
void addChecksumProperty(JsonCursor::Json& schema);

/// The error for a file with a wrong checksum.
Diagnostic wrongChecksum(const std::string& file, const Message& advice);

}  // namespace glissade
