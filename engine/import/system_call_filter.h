#pragma once

#include "engine/base/result.h"

namespace glissade {

/// Descriptors that an importing process may use after the filter is loaded.
inline constexpr int kInputDescriptor = 0;   ///< bytes of the file, read only
inline constexpr int kOutputDescriptor = 3;  ///< message of the protocol, write only

/// Loads a seccomp filter that permits a list of system calls to all threads of this process and refuses every other
/// one with EPERM. A call of another ABI (32 bit, x32) kills the process. Sets no_new_privs. The list is in
/// engine/import/README.md. Errors are Internal.
Outcome loadSystemCallFilter();

}  // namespace glissade
