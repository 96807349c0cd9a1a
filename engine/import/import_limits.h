#pragma once

#include <cstdint>
#include <string>

#include "engine/base/message.h"
#include "engine/import/import_protocol.h"

namespace glissade {

/// Memory that programs could use now without swapping, bytes (MemAvailable of Linux); 2 GiB if it is unknown.
std::uint64_t availableMemory();

/// Largest file of geometry that is read: a sixteenth of the available memory, between 200 MiB and 4 GiB.
std::uint64_t mostFileBytes(std::uint64_t available = availableMemory());

/// Limits of the importing process for a mesh file of this size. Memory: 450 MiB and 16 times the file, at most half of
/// the available memory. A small file therefore cannot use much memory, whatever its claims.
import_protocol::Limits meshLimits(std::uint64_t fileBytes, std::uint64_t available = availableMemory());

/// "312 MiB", for people.
Message sizeInWords(std::uint64_t bytes);

}  // namespace glissade
