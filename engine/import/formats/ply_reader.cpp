#include "engine/import/formats/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/geometry/vertex_welder.h"
#include "engine/import/formats/index_text.h"
#include "engine/import/formats/ply_header.h"
#include "engine/import/formats/polygon_triangulation.h"
#include "engine/import/formats/text_scanner.h"

namespace glissade {
namespace {

/// The numbers of a text PLY.
class TextNumbers {
 public:
  TextNumbers(std::string_view bytes, const PlyHeader& header)
      : scanner_(bytes.substr(header.bytes), header.lines + 1) {}

  double next(PlyType) { return scanner_.number(scanner_.word(), GLISSADE_TEXT("the number")); }
  bool atEnd() { return scanner_.atEnd(); }
  FormatError error(const Message& reason) const { return scanner_.error(reason); }

 private:
  TextScanner scanner_;
};

/// The numbers of a binary PLY.
class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes),
        at_(header.bytes),
        swap_((header.encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big)) {}

  double next(PlyType type) {
    switch (type) {
      case PlyType::Int8: return take<std::int8_t>();
      case PlyType::UInt8: return take<std::uint8_t>();
      case PlyType::Int16: return take<std::int16_t>();
      case PlyType::UInt16: return take<std::uint16_t>();
      case PlyType::Int32: return take<std::int32_t>();
      case PlyType::UInt32: return take<std::uint32_t>();
      case PlyType::Float: return finite(take<float>());
      case PlyType::Double: return finite(take<double>());
    }
    return 0.0;
  }
  bool atEnd() const {
    const std::string_view rest = bytes_.substr(at_);
    return std::all_of(rest.begin(), rest.end(), [](char c) { return c == '\0' || c == '\n' || c == '\r'; });
  }
  FormatError error(const Message& reason) const { return {{GLISSADE_TEXT("byte %1"), {at_}}, reason}; }

 private:
  template <class T>
  T take() {
    if (bytes_.size() - at_ < sizeof(T)) throw error(GLISSADE_TEXT("ends before its last element"));
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  double finite(double value) const {
    if (!std::isfinite(value)) throw error(GLISSADE_TEXT("has a number that is not finite"));
    return value;
  }

  std::string_view bytes_;
  std::size_t at_;
  bool swap_;
};

/// Reads the elements of a file in the order of its header.
template <class Numbers>
class Ply {
 public:
  Ply(const PlyHeader& header, Numbers numbers) : header_(header), numbers_(std::move(numbers)) {}

  MeshContent read() && {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face") {
        readFaces(element);
      } else if (element.name == "tristrips") {
        throw FormatError{"", GLISSADE_TEXT("holds triangle strips, which are not read")};
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) readRow(element);
      }
    }
    if (!numbers_.atEnd()) throw numbers_.error(GLISSADE_TEXT("goes on after the elements that its header claims"));
    content_.mesh.vertices = std::move(welder_).takeVertices();
    content_.vertexMean = meanOfVertices();
    return std::move(content_);
  }

 private:
  /// Reads the values of one element: a number for each property into `row_`, and the items of the property `kept` into
  /// `list_`.
  void readRow(const PlyElement& element, int kept = -1) {
    row_.clear();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const double value = numbers_.next(property.isList ? property.countType : property.type);
      row_.push_back(value);
      if (property.isList) readList(property, value, static_cast<int>(i) == kept);
    }
  }

  void readList(const PlyProperty& property, double count, bool keep) {
    if (!(count >= 0.0) || count != std::floor(count))
      throw numbers_.error(GLISSADE_TEXT("has a list of an impossible length"));
    if (keep) list_.clear();
    for (double i = 0; i < count; ++i) {
      const double item = numbers_.next(property.type);
      if (keep) list_.push_back(item);
    }
  }

  void readVertices(const PlyElement& element) {
    const std::array<int, 3> axes{element.find("x"), element.find("y"), element.find("z")};
    double largest = 0.0;
    bool single = false;
    for (const int axis : axes) {
      if (axis < 0 || element.properties[static_cast<std::size_t>(axis)].isList) {
        throw FormatError{"", GLISSADE_TEXT("has vertices without x, y and z")};
      }
      single = single || element.properties[static_cast<std::size_t>(axis)].type == PlyType::Float;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      readRow(element);
      const Vector3 position(row_[static_cast<std::size_t>(axes[0])], row_[static_cast<std::size_t>(axes[1])],
                             row_[static_cast<std::size_t>(axes[2])]);
      positions_.push_back(position);
      largest = std::max(largest, position.cwiseAbs().maxCoeff());
    }
    if (single && header_.encoding != PlyEncoding::Text) content_.coordinateSpacing = floatSpacing(largest);
  }

  void readFaces(const PlyElement& element) {
    if (positions_.empty() && element.count > 0) throw FormatError{"", GLISSADE_TEXT("has faces before its vertices")};
    int corners = element.find("vertex_indices");
    if (corners < 0) corners = element.find("vertex_index");
    if (corners < 0 || !element.properties[static_cast<std::size_t>(corners)].isList) {
      throw FormatError{"", GLISSADE_TEXT("has faces without a list 'vertex_indices'")};
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      readRow(element, corners);
      addFace();
    }
  }

  void addFace() {
    if (list_.size() < 3) throw numbers_.error({GLISSADE_TEXT("has a face of %1 corners"), {list_.size()}});
    corners_.clear();
    for (const double index : list_) {
      if (!(index >= 0.0 && index < static_cast<double>(positions_.size())) || index != std::floor(index)) {
        throw numbers_.error(
            {GLISSADE_TEXT("has a face with vertex %1, but the file has %2"), {indexText(index), positions_.size()}});
      }
      corners_.push_back(positions_[static_cast<std::size_t>(index)]);
    }
    const auto triangles = triangulatePolygon(corners_);
    if (!triangles) throw numbers_.error(GLISSADE_TEXT("has a face whose outline crosses itself"));
    for (const auto& [a, b, c] : *triangles) {
      const std::uint32_t first = welder_.indexOf(corners_[a]);
      const std::uint32_t second = welder_.indexOf(corners_[b]);
      const std::uint32_t third = welder_.indexOf(corners_[c]);
      content_.mesh.triangles.push_back({first, second, third});
    }
  }

  Vector3 meanOfVertices() const {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& vertex : content_.mesh.vertices) sum += vertex;
    return content_.mesh.vertices.empty() ? sum : Vector3(sum / static_cast<double>(content_.mesh.vertices.size()));
  }

  const PlyHeader& header_;
  Numbers numbers_;
  std::vector<double> row_;
  std::vector<double> list_;
  std::vector<Vector3> positions_;  ///< positions of the file's vertices, by number
  std::vector<Vector3> corners_;    ///< corners of the face that is being read
  VertexWelder welder_;
  MeshContent content_;
};

}  // namespace

MeshContent readPly(std::string_view bytes) {
  const PlyHeader header = readPlyHeader(bytes);
  if (header.encoding == PlyEncoding::Text) return Ply(header, TextNumbers(bytes, header)).read();
  return Ply(header, BinaryNumbers(bytes, header)).read();
}

}  // namespace glissade
