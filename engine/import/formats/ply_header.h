#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

enum class PlyEncoding { Text, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/// Bytes of a number in a binary file.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float;  ///< for a list, the type of its items
  bool isList = false;
  PlyType countType = PlyType::UInt8;  ///< type of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< number of elements that the header claims
  std::vector<PlyProperty> properties;

  /// Least number of bytes of one element; in a text, a digit and a separator for each number.
  std::size_t leastBytes(PlyEncoding encoding) const;
  /// Index of the property; -1 if there is none of that name.
  int find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< size of the header
  std::size_t lines = 0;
};

/// Reads the header and checks its counts against the size of the file. Throws FormatError.
PlyHeader readPlyHeader(std::string_view bytes);

}  // namespace glissade
