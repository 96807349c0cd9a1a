#pragma once

#include <cstdint>
#include <string>

#include "engine/import/import_protocol.h"

namespace glissade {

/// Memory that programs could have now without swapping, bytes (MemAvailable of Linux); 2 GiB where it is unknown.
std::uint64_t availableMemory();

/// Largest file of geometry that is read: a sixteenth of the available memory, from 200 MiB to 4 GiB.
std::uint64_t mostFileBytes(std::uint64_t available = availableMemory());

/// What the importing process may use for a mesh file of this size. Memory: 450 MiB and 16 times the file, at most
/// half of what is available; a small file cannot take much, whatever it claims.
import_protocol::Limits meshLimits(std::uint64_t fileBytes, std::uint64_t available = availableMemory());

/// "312 MiB", for people.
std::string sizeInWords(std::uint64_t bytes);

}  // namespace glissade
