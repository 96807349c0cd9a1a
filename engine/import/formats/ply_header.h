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
  PlyType type = PlyType::Float;  ///< of a list: of its items
  bool isList = false;
  PlyType countType = PlyType::UInt8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as the header claims
  std::vector<PlyProperty> properties;

  /// The least number of bytes that one of them takes: a digit and a separator a number in a text.
  std::size_t leastBytes(PlyEncoding encoding) const;
  /// Index of the property; -1 where there is none of that name.
  int find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< of the header itself
  std::size_t lines = 0;
};

/// Reads the header and compares its counts with what the file can hold. Throws FormatError.
PlyHeader readPlyHeader(std::string_view bytes);

}  // namespace glissade
