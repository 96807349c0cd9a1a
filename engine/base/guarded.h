#pragma once

#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The fault of a function from outside of the library. It ends the work that called the function, and is a Usage error
/// whose reason is its text.
class OutsideFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The exception that is being handled, as a diagnostic. `doing` completes "an error occurred while ...", for
/// example "planning". Exhausted memory is LimitReached, an OutsideFault is Usage,
/// everything else is Internal. Call it in a catch block only.
Diagnostic currentExceptionAsDiagnostic(CatalogueText doing) noexcept;
Diagnostic currentExceptionAsDiagnostic(const Message& doing) noexcept;

/// The diagnostic for exhausted memory. Allocates nothing: texts of this length are stored within the string.
Diagnostic withoutMemory() noexcept;

/// Calls `work`. Returns nothing where it ends normally, else the diagnostic of the exception that leaves it. Each
/// thread turns exceptions into diagnostics with this function.
template <class Doing, class Work>
[[nodiscard]] std::optional<Diagnostic> guarded(const Doing& doing, Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return std::nullopt;
  } catch (...) {
    return currentExceptionAsDiagnostic(doing);
  }
}

}  // namespace glissade
