#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The exception that is being handled, as a diagnostic. `doing` completes "an error occurred while ...", for
/// example "planning". Exhausted memory is LimitReached, everything else is Internal. Call it in a catch block only.
Diagnostic currentExceptionAsDiagnostic(std::string_view doing) noexcept;

/// What is said where no memory is left for more. Allocates nothing: texts of this length are stored within the string.
Diagnostic withoutMemory() noexcept;

/// Calls `work`. Returns nothing where it ends, and the diagnostic of the exception that leaves it otherwise.
/// This is how each thread turns exceptions into diagnostics.
template <class Work>
[[nodiscard]] std::optional<Diagnostic> guarded(std::string_view doing, Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return std::nullopt;
  } catch (...) {
    return currentExceptionAsDiagnostic(doing);
  }
}

}  // namespace glissade
