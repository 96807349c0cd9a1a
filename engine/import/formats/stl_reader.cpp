#include "engine/import/formats/stl_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/base/reserve_filled.h"
#include "engine/geometry/vertex_welder.h"
#include "engine/import/formats/corner_mean.h"
#include "engine/import/formats/text_scanner.h"

namespace glissade {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kRecord = 50;
constexpr std::size_t kCountAt = 80;

using Facet = std::array<Vector3, 3>;

/// Collects the facets of a file.
class Facets {
 public:
  /// `expected`: number of facets of a closed surface, which has half as many vertices; larger numbers are accepted.
  explicit Facets(std::size_t expected = 0) : welder_(expected / 2 + 2) {
    reserveFilled(triangles_, expected);
    mean_.reserve(3 * expected);
  }

  void add(const Facet& corners, const CornerAttributes& attributes) {
    TriangleIndices triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i] = welder_.indexOf(corners[i]);
      mean_.add(triangle[i], corners[i], attributes);
    }
    triangles_.push_back(triangle);
  }

  MeshContent take() && {
    MeshContent content;
    content.mesh.triangles = std::move(triangles_);
    content.mesh.vertices = std::move(welder_).takeVertices();
    content.vertexMean = mean_.mean();
    return content;
  }

 private:
  VertexWelder welder_;
  CornerMean mean_;
  std::vector<TriangleIndices> triangles_;
};

/// Text STL, facet by facet.
class TextStl {
 public:
  explicit TextStl(std::string_view text) : scanner_(text) {}

  MeshContent read() && {
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      if (!isKeyword(word, "solid")) throw unexpected(word, "solid");
      readSolid();
    }
    return std::move(facets_).take();
  }

 private:
  void readSolid() {
    scanner_.nextLine();  // the name of the solid follows 'solid'
    for (std::string_view word = scanner_.word(); !isKeyword(word, "endsolid"); word = scanner_.word()) {
      if (!isKeyword(word, "facet")) throw unexpected(word, "endsolid");
      readFacet();
    }
    scanner_.nextLine();
  }

  void readFacet() {
    const CornerAttributes attributes = readNormal();
    expect("outer");
    expect("loop");
    Facet corners;
    for (Vector3& corner : corners) {
      expect("vertex");
      for (double& coordinate : corner)
        coordinate = scanner_.number(scanner_.wordInLine(), GLISSADE_TEXT("the coordinate"));
    }
    const std::string_view end = scanner_.word();
    if (isKeyword(end, "vertex")) throw scanner_.error(GLISSADE_TEXT("has a facet with more than three corners"));
    if (!isKeyword(end, "endloop")) throw unexpected(end, "endloop");
    expect("endfacet");
    facets_.add(corners, attributes);
  }

  /// The corners give the normal, so its numbers may be missing, as some programs write it.
  CornerAttributes readNormal() {
    CornerAttributes attributes;
    std::string_view word = scanner_.wordInLine();
    if (!isKeyword(word, "normal")) throw unexpected(word, "normal");
    for (int i = 0; i < 3; ++i) {
      word = scanner_.wordInLine();
      if (word.empty()) throw scanner_.error(GLISSADE_TEXT("has a facet normal with fewer than three numbers"));
      attributes.normal[i] = attributeNumber(word);
    }
    return attributes;
  }

  void expect(const char* keyword) {
    const std::string_view word = scanner_.word();
    if (!isKeyword(word, keyword)) throw unexpected(word, keyword);
  }

  FormatError unexpected(std::string_view word, const char* expected) {
    if (word.empty() || (scanner_.lastLineIsOpen() && scanner_.atEnd()))
      return scanner_.error(GLISSADE_TEXT("ends before 'endsolid'"));
    return scanner_.error({GLISSADE_TEXT("has %1 where '%2' is expected"), {inQuotes(word), expected}});
  }

  TextScanner scanner_;
  Facets facets_;
};

std::uint32_t claimedTriangles(std::string_view bytes) {
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, bytes.data() + kCountAt, sizeof claimed);
  return claimed;
}

/// Some programs begin binary files with the word 'solid': their length, or bytes that are no text, identifies them.
bool isText(std::string_view bytes) {
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kRecord * std::uint64_t{claimedTriangles(bytes)}) {
    return false;
  }
  return isKeyword(TextScanner(bytes).word(), "solid") && bytes.find('\0') == std::string_view::npos;
}

MeshContent readBinaryStl(std::string_view bytes) {
  if (bytes.size() < kHeader) throw FormatError{"", GLISSADE_TEXT("is too short for an STL file")};
  const std::uint32_t claimed = claimedTriangles(bytes);
  if ((bytes.size() - kHeader) / kRecord < claimed) {
    throw FormatError{"", {GLISSADE_TEXT("claims %1 triangles but is only %2 bytes long"), {claimed, bytes.size()}}};
  }
  const std::size_t end = kHeader + kRecord * claimed;
  const std::string_view rest = bytes.substr(end);
  if (!std::all_of(rest.begin(), rest.end(), [](char c) { return c == '\0' || c == ' ' || c == '\n' || c == '\r'; })) {
    throw FormatError{{GLISSADE_TEXT("byte %1"), {end}},
                      {GLISSADE_TEXT("goes on after the %1 triangles that it claims to have"), {claimed}}};
  }
  Facets facets(claimed);
  float largest = 0.0F;
  for (std::size_t at = kHeader; at < end; at += kRecord) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
    CornerAttributes attributes;
    attributes.normal = {numbers[0], numbers[1], numbers[2]};
    if (!attributes.normal.allFinite()) attributes.normal.setZero();
    Facet corners;
    for (std::size_t i = 0; i < 9; ++i) {
      const float coordinate = numbers[3 + i];
      if (!std::isfinite(coordinate)) {
        throw FormatError{{GLISSADE_TEXT("byte %1"), {at + 4 * (3 + i)}},
                          GLISSADE_TEXT("has a coordinate that is not a finite number")};
      }
      largest = std::max(largest, std::abs(coordinate));
      corners[i / 3][static_cast<Eigen::Index>(i % 3)] = coordinate;
    }
    facets.add(corners, attributes);
  }
  MeshContent content = std::move(facets).take();
  content.coordinateSpacing = floatSpacing(largest);
  return content;
}

}  // namespace

MeshContent readStl(std::string_view bytes) { return isText(bytes) ? TextStl(bytes).read() : readBinaryStl(bytes); }

}  // namespace glissade
