#include "engine/base/guarded.h"

#include <exception>
#include <new>
#include <string>

namespace glissade {
namespace {

Diagnostic outOfMemory(const std::string& doing, const std::string& text) {
  return {ErrorKind::LimitReached, "", "", "there was not enough memory while " + doing + " (" + text + ")",
          "Close other programs or use coarser parts, then try again."};
}

Diagnostic internalError(const std::string& doing, const std::string& text) {
  return {ErrorKind::Internal, "", "", "an error occurred while " + doing + ": " + text,
          "Try again. If it happens again, report it with the scenario and the seed."};
}

Diagnostic describe(const std::string& doing) {
  try {
    throw;
  } catch (const std::bad_alloc& error) {
    return outOfMemory(doing, error.what());
  } catch (const std::exception& error) {  // includes the exceptions of OMPL, JSON and CLI11
    return internalError(doing, error.what());
  } catch (...) {
    return internalError(doing, "of an unknown kind");
  }
}

}  // namespace

Diagnostic withoutMemory() noexcept { return {ErrorKind::LimitReached, "", "", "out of memory", ""}; }

Diagnostic currentExceptionAsDiagnostic(std::string_view doing) noexcept {
  try {
    return describe(std::string(doing));
  } catch (...) {
    return withoutMemory();
  }
}

}  // namespace glissade
