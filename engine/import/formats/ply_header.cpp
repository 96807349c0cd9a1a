#include "engine/import/formats/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/import/formats/text_scanner.h"

namespace glissade {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> kTypes{{{"char", PlyType::Int8},
                                           {"int8", PlyType::Int8},
                                           {"uchar", PlyType::UInt8},
                                           {"uint8", PlyType::UInt8},
                                           {"short", PlyType::Int16},
                                           {"int16", PlyType::Int16},
                                           {"ushort", PlyType::UInt16},
                                           {"uint16", PlyType::UInt16},
                                           {"int", PlyType::Int32},
                                           {"int32", PlyType::Int32},
                                           {"uint", PlyType::UInt32},
                                           {"uint32", PlyType::UInt32},
                                           {"float", PlyType::Float},
                                           {"float32", PlyType::Float},
                                           {"double", PlyType::Double},
                                           {"float64", PlyType::Double}}};

PlyType typeNamed(std::string_view name, const TextScanner& scanner) {
  const auto found =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& entry) { return entry.name == name; });
  if (found == kTypes.end())
    throw scanner.error({GLISSADE_TEXT("has %1 where a type of numbers is expected"), {inQuotes(name)}});
  return found->type;
}

PlyEncoding encodingNamed(std::string_view name, const TextScanner& scanner) {
  if (name == "ascii") return PlyEncoding::Text;
  if (name == "binary_little_endian") return PlyEncoding::LittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::BigEndian;
  throw scanner.error({GLISSADE_TEXT("has the unknown format %1"), {inQuotes(name)}});
}

PlyElement readElement(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.wordInLine();
  const std::string_view count = scanner.wordInLine();
  const auto [end, fault] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (fault != std::errc() || end != count.data() + count.size()) {
    throw scanner.error({GLISSADE_TEXT("has %1 where a number of elements is expected"), {inQuotes(count)}});
  }
  return element;
}

PlyProperty readProperty(TextScanner& scanner) {
  PlyProperty property;
  std::string_view type = scanner.wordInLine();
  property.isList = type == "list";
  if (property.isList) {
    property.countType = typeNamed(scanner.wordInLine(), scanner);
    type = scanner.wordInLine();
  }
  property.type = typeNamed(type, scanner);
  property.name = scanner.wordInLine();
  if (property.name.empty()) throw scanner.error(GLISSADE_TEXT("has a property without a name"));
  return property;
}

/// Checks the counts before memory is allocated.
void checkCounts(const PlyHeader& header, std::size_t fileBytes) {
  std::uint64_t left = fileBytes - header.bytes;
  for (const PlyElement& element : header.elements) {
    const std::uint64_t least = std::max<std::uint64_t>(1, element.leastBytes(header.encoding));
    // The last number of a text needs no separator.
    if (element.count > (left + 1) / least) {
      throw FormatError{"",
                        {GLISSADE_TEXT("claims %1 of %2 but is only %3 bytes long"),
                         {element.count, inQuotes(element.name), fileBytes}}};
    }
    left -= std::min(left, element.count * least);
  }
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8: return 1;
    case PlyType::Int16:
    case PlyType::UInt16: return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float: return 4;
    case PlyType::Double: return 8;
  }
  return 1;
}

std::size_t PlyElement::leastBytes(PlyEncoding encoding) const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) {
    const PlyType first = property.isList ? property.countType : property.type;
    bytes += encoding == PlyEncoding::Text ? 2 : sizeOf(first);
  }
  return bytes;
}

int PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& entry) { return entry.name == property; });
  return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

PlyHeader readPlyHeader(std::string_view bytes) {
  TextScanner scanner(bytes);
  if (scanner.wordInLine() != "ply") throw scanner.error(GLISSADE_TEXT("does not begin with 'ply'"));
  PlyHeader header;
  bool formatKnown = false;
  while (scanner.nextLine()) {
    const std::string_view keyword = scanner.wordInLine();
    if (keyword == "format") {
      header.encoding = encodingNamed(scanner.wordInLine(), scanner);
      formatKnown = true;
    } else if (keyword == "element") {
      header.elements.push_back(readElement(scanner));
    } else if (keyword == "property") {
      if (header.elements.empty()) throw scanner.error(GLISSADE_TEXT("has a property before any element"));
      header.elements.back().properties.push_back(readProperty(scanner));
    } else if (keyword == "end_header") {
      if (!formatKnown) throw scanner.error(GLISSADE_TEXT("does not say its format before 'end_header'"));
      if (!scanner.nextLine()) throw scanner.error(GLISSADE_TEXT("ends after its header"));
      header.bytes = scanner.position();
      header.lines = scanner.line() - 1;
      checkCounts(header, bytes.size());
      return header;
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      throw scanner.error({GLISSADE_TEXT("has %1 in its header"), {inQuotes(keyword)}});
    }
  }
  throw scanner.error(GLISSADE_TEXT("ends before 'end_header'"));
}

}  // namespace glissade
