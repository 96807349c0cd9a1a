#pragma once

#include <ompl/util/Exception.h>

#include <new>

#include "engine/base/diagnostic.h"

namespace glissade::test {

/// An exception that code of ours or of a library may throw, and the kind of diagnostic that becomes of it.
struct Thrown {
  const char* name;
  void (*raise)();
  ErrorKind kind;
};

inline const Thrown kThrown[] = {
    {"BadAlloc", [] { throw std::bad_alloc(); }, ErrorKind::LimitReached},
    {"Ompl", [] { throw ompl::Exception("no space information"); }, ErrorKind::Internal},
    {"Integer", [] { throw 7; }, ErrorKind::Internal},
};

}  // namespace glissade::test
