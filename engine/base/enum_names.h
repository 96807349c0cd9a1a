#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// The names of the values of an enumeration, for files, scripts and reports. The values count from 0, in the order of
/// the names.
template <class Enum, std::size_t count>
struct EnumNames {
  std::array<const char*, count> names;

  constexpr const char* of(Enum value) const { return names[static_cast<std::size_t>(value)]; }
  /// Nothing where no value has the name.
  constexpr std::optional<Enum> find(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Enum>(found - names.begin());
  }
  /// All names with commas between them, for messages.
  std::string listed() const {
    std::string text;
    for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }
};

}  // namespace glissade
