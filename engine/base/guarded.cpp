#include "engine/base/guarded.h"

#include <exception>
#include <new>
#include <string>

namespace glissade {
namespace {

Diagnostic outOfMemory(const Message& doing, const std::string& text) {
  return {ErrorKind::LimitReached,
          "",
          "",
          {GLISSADE_TEXT("there was not enough memory while %1 (%2)"), {doing, text}},
          GLISSADE_TEXT("Close other programs or use coarser parts, then try again.")};
}

Diagnostic internalError(const Message& doing, const Message& text) {
  return {ErrorKind::Internal,
          "",
          "",
          {GLISSADE_TEXT("an error occurred while %1: %2"), {doing, text}},
          GLISSADE_TEXT("Try again. If it happens again, report it with the scenario and the seed.")};
}

Diagnostic describe(const Message& doing) {
  try {
    throw;
  } catch (const std::bad_alloc& error) {
    return outOfMemory(doing, error.what());
  } catch (const OutsideFault& fault) {
    return {ErrorKind::Usage, "", "", Message(fault.what()), {}};
  } catch (const std::exception& error) {  // includes the exceptions of OMPL, JSON and CLI11
    return internalError(doing, Message(error.what()));
  } catch (...) {
    return internalError(doing, GLISSADE_TEXT("of an unknown kind"));
  }
}

}  // namespace

Diagnostic withoutMemory() noexcept { return {ErrorKind::LimitReached, "", {}, GLISSADE_TEXT("out of memory"), {}}; }

Diagnostic currentExceptionAsDiagnostic(const Message& doing) noexcept {
  try {
    return describe(doing);
  } catch (...) {
    return withoutMemory();
  }
}

Diagnostic currentExceptionAsDiagnostic(CatalogueText doing) noexcept {
  try {
    return describe(doing);
  } catch (...) {
    return withoutMemory();
  }
}

}  // namespace glissade
