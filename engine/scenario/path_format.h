#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/planning/roadmap.h"

/// Private to this room: what path files have in common for reading and writing.
namespace glissade::path_format {

inline constexpr const char* kName = "glissade-path";
inline constexpr std::uint64_t kVersion = 1;
inline constexpr std::string_view kCsvHeader = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author";
/// In the order of Author.
inline constexpr std::array<std::string_view, 3> kAuthors{"computer", "operator", "contact"};

constexpr std::string_view nameOf(Author author) { return kAuthors[static_cast<std::size_t>(author)]; }

}  // namespace glissade::path_format
