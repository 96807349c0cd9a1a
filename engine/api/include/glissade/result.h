#pragma once

#include <glissade/error_kind.h>
#include <glissade/export.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace glissade::api {

/// An error or a warning, in English. Each text may be empty.
///
/// The engine's own diagnostics hold texts as data for translation. Their layout changes with the engine, so that the
/// public one has plain texts.
struct GLISSADE_EXPORT Diagnostic {
  ErrorKind kind = ErrorKind::Internal;  ///< class of the error
  std::string file{};                    ///< file as the caller named it
  std::string place{};                   ///< place in the file, or the name of an argument
  std::string reason{};                  ///< the fault
  std::string advice{};                  ///< the remedy

  /// "file: place: reason. advice" without the empty parts.
  std::string text() const;
};

/// Warnings beside a result.
using Warnings = std::vector<Diagnostic>;

/// Either a value or the diagnostic that states why there is none. Functions of the library throw no exceptions.
template <class T>
class [[nodiscard]] Result {
 public:
  /// A result with a value.
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  /// A result without a value.
  Result(Diagnostic why) : content_(std::in_place_index<1>, std::move(why)) {}  // NOLINT(google-explicit-constructor)

  /// True if there is a value.
  bool ok() const { return content_.index() == 0; }
  /// ok()
  explicit operator bool() const { return ok(); }

  /// The value. Throws std::bad_variant_access where there is none.
  const T& value() const { return std::get<0>(content_); }
  /// value()
  const T& operator*() const { return value(); }
  /// value()
  const T* operator->() const { return &value(); }

  /// The reason. Throws std::bad_variant_access where there is a value.
  const Diagnostic& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Diagnostic> content_;
};

/// The value of a function without a result.
struct Done {};
/// The result of a function without a value.
using Outcome = Result<Done>;

}  // namespace glissade::api
