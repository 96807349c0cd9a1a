#pragma once

#include <utility>
#include <variant>

#include "engine/base/diagnostic.h"

namespace glissade {

/// Either a value or the diagnostic that states why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}                     // NOLINT(google-explicit-constructor)
  Result(Diagnostic diagnostic) : content_(std::move(diagnostic)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  /// Precondition: ok().
  const T& value() const& { return std::get<T>(content_); }
  T& value() & { return std::get<T>(content_); }
  T&& value() && { return std::get<T>(std::move(content_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  /// Precondition: !ok().
  const Diagnostic& error() const { return std::get<Diagnostic>(content_); }

 private:
  std::variant<T, Diagnostic> content_;
};

/// The value of an operation without a result.
struct Done {};
using Outcome = Result<Done>;

}  // namespace glissade
