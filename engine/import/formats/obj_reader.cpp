#include "engine/import/formats/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/geometry/vertex_welder.h"
#include "engine/import/formats/corner_mean.h"
#include "engine/import/formats/polygon_triangulation.h"
#include "engine/import/formats/text_scanner.h"

namespace glissade {
namespace {

/// Statements that do not affect the surface.
constexpr std::array kSkipped{"o",  "g",   "s",  "usemtl", "mtllib",   "l",        "p",          "usemap",    "maplib",
                              "mg", "lod", "vp", "bevel",  "c_interp", "d_interp", "shadow_obj", "trace_obj", "call"};
constexpr std::array kFreeForm{"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                               "parm",   "trim", "hole", "scrv", "sp",   "end",   "con"};

bool isOneOf(const auto& keywords, std::string_view word) {
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

/// A corner of a face: position, texture coordinates and normal, counted from 0.
struct Corner {
  std::uint32_t vertex = 0;
  std::optional<std::uint32_t> texture;
  std::optional<std::uint32_t> normal;
};

/// The words of one statement; a backslash at the end of a line continues it.
class Statement {
 public:
  explicit Statement(TextScanner& scanner) : scanner_(scanner) {}

  std::string_view word() {
    std::string_view found = scanner_.wordInLine();
    while (found.empty() && continued_ && scanner_.nextLine()) found = scanner_.wordInLine();
    continued_ = !found.empty() && found.back() == '\\';
    if (continued_) found.remove_suffix(1);
    if (continued_ && found.empty()) return word();
    return found.empty() || found.front() == '#' ? std::string_view() : found;
  }

 private:
  TextScanner& scanner_;
  bool continued_ = false;
};

/// Reads the text twice: first all vertices, because faces may come before them, then the faces.
class Obj {
 public:
  explicit Obj(std::string_view text) : text_(text) {}

  MeshContent read() && {
    readVertices();
    readFaces();
    content_.mesh.vertices = std::move(welder_).takeVertices();
    content_.vertexMean = mean_.mean();
    return std::move(content_);
  }

 private:
  void readVertices() {
    TextScanner scanner(text_);
    do {
      Statement statement(scanner);
      const std::string_view keyword = statement.word();
      if (keyword == "v") {
        indices_.push_back(welder_.indexOf(readPosition(scanner, statement)));
      } else if (keyword == "vn") {
        normals_.push_back(readAttribute<3>(statement));
      } else if (keyword == "vt") {
        textures_.push_back(readAttribute<2>(statement));
      } else {
        checkKeyword(scanner, keyword);
      }
    } while (skipContinued(scanner));
    if (scanner.lastLineIsOpen()) {
      content_.warnings.push_back(
          {GLISSADE_TEXT("line %1: the last line has no end; the file may be cut off"), {scanner.line()}});
    }
  }

  /// Skips to the beginning of the next statement.
  static bool skipContinued(TextScanner& scanner) {
    Statement rest(scanner);
    while (!rest.word().empty()) {
    }
    return scanner.nextLine();
  }

  static void checkKeyword(const TextScanner& scanner, std::string_view keyword) {
    if (keyword.empty() || keyword == "f" || isOneOf(kSkipped, keyword)) return;
    if (isOneOf(kFreeForm, keyword)) {
      throw scanner.error(
          {GLISSADE_TEXT("has a free-form curve or surface (%1), which is not read"), {inQuotes(keyword)}});
    }
    throw scanner.error(
        {GLISSADE_TEXT("begins with %1, which is not a statement of an OBJ file"), {inQuotes(keyword)}});
  }

  /// Reads x y z and an optional weight of 1 or colour.
  static Vector3 readPosition(const TextScanner& scanner, Statement& statement) {
    Vector3 position;
    for (double& coordinate : position) coordinate = scanner.number(statement.word(), GLISSADE_TEXT("the coordinate"));
    const std::string_view weight = statement.word();
    if (weight.empty() || !statement.word().empty()) return position;
    if (scanner.number(weight, GLISSADE_TEXT("the weight")) != 1.0) {
      throw scanner.error(GLISSADE_TEXT("has a vertex with a weight other than 1"));
    }
    return position;
  }

  /// Reads a normal or texture coordinates; missing numbers are zero.
  template <int kCount>
  static Eigen::Matrix<float, kCount, 1> readAttribute(Statement& statement) {
    Eigen::Matrix<float, kCount, 1> numbers;
    for (float& value : numbers) value = attributeNumber(statement.word());
    return numbers;
  }

  void readFaces() {
    TextScanner scanner(text_);
    do {
      Statement statement(scanner);
      const std::string_view keyword = statement.word();
      if (keyword == "f") {
        readFace(scanner, statement);
      } else if (keyword == "v") {
        ++verticesSoFar_;
      } else if (keyword == "vn") {
        ++normalsSoFar_;
      } else if (keyword == "vt") {
        ++texturesSoFar_;
      } else if (keyword == "o" || keyword == "g" || keyword == "usemtl") {
        mean_.startSection();
        if (keyword != "usemtl") content_.groups.push_back({restOf(statement), 0});
      }
    } while (skipContinued(scanner));
  }

  /// The words of the statement, with one blank between them.
  static std::string restOf(Statement& statement) {
    std::string text;
    for (std::string_view word = statement.word(); !word.empty(); word = statement.word()) {
      text += (text.empty() ? "" : " ") + std::string(word);
    }
    return text;
  }

  void readFace(const TextScanner& scanner, Statement& statement) {
    corners_.clear();
    for (std::string_view word = statement.word(); !word.empty(); word = statement.word()) {
      corners_.push_back(readCorner(scanner, word));
    }
    if (corners_.size() == 1) throw scanner.error(GLISSADE_TEXT("has a face of 1 corner"));
    if (corners_.size() < 3) throw scanner.error({GLISSADE_TEXT("has a face of %1 corners"), {corners_.size()}});
    positions_.clear();
    for (const Corner& corner : corners_) positions_.push_back(positionOf(corner));
    const auto triangles = triangulatePolygon(positions_);
    if (!triangles) throw scanner.error(GLISSADE_TEXT("has a face whose outline crosses itself"));
    for (const auto& [a, b, c] : *triangles) {
      content_.mesh.triangles.push_back({indexOf(corners_[a]), indexOf(corners_[b]), indexOf(corners_[c])});
    }
    if (content_.groups.empty()) content_.groups.emplace_back();
    content_.groups.back().triangles += static_cast<std::uint32_t>(triangles->size());
    const Eigen::Vector3f flat = faceNormal(triangles->back());
    for (std::size_t i = 0; i < corners_.size(); ++i)
      mean_.add(indexOf(corners_[i]), positions_[i], attributesOf(corners_[i], flat));
  }

  /// "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal".
  Corner readCorner(const TextScanner& scanner, std::string_view word) const {
    std::array<std::string_view, 3> parts;
    std::string_view rest = word;
    for (std::string_view& part : parts) {
      const std::size_t slash = rest.find('/');
      part = rest.substr(0, slash);
      rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
    }
    if (!rest.empty()) {
      throw scanner.error({GLISSADE_TEXT("has the corner %1, which is not of the form a/b/c"), {inQuotes(word)}});
    }
    Corner corner;
    corner.vertex = readIndex(scanner, parts[0], verticesSoFar_, indices_.size(), GLISSADE_TEXT("vertex"));
    if (!parts[1].empty()) {
      corner.texture =
          readIndex(scanner, parts[1], texturesSoFar_, textures_.size(), GLISSADE_TEXT("texture coordinate"));
    }
    if (!parts[2].empty()) {
      corner.normal = readIndex(scanner, parts[2], normalsSoFar_, normals_.size(), GLISSADE_TEXT("normal"));
    }
    return corner;
  }

  /// Indices count from 1, or backwards from the latest element.
  static std::uint32_t readIndex(const TextScanner& scanner, std::string_view word, std::size_t soFar,
                                 std::size_t count, CatalogueText what) {
    std::int64_t index = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (fault != std::errc() || end != word.data() + word.size()) {
      throw scanner.error({GLISSADE_TEXT("has %1 where the number of a %2 is expected"), {inQuotes(word), what}});
    }
    const std::int64_t position = index > 0 ? index - 1 : index + static_cast<std::int64_t>(soFar);
    if (index == 0 || position < 0 || position >= static_cast<std::int64_t>(count)) {
      throw scanner.error({GLISSADE_TEXT("has a face with %1 %2, but the file has %3"), {what, index, count}});
    }
    return static_cast<std::uint32_t>(position);
  }

  std::uint32_t indexOf(const Corner& corner) const { return indices_[corner.vertex]; }
  const Vector3& positionOf(const Corner& corner) const { return welder_.vertices()[indexOf(corner)]; }

  Eigen::Vector3f faceNormal(const TriangleIndices& triangle) const {
    const Eigen::Vector3f a = positions_[triangle[0]].cast<float>();
    const Eigen::Vector3f b = positions_[triangle[1]].cast<float>();
    const Eigen::Vector3f c = positions_[triangle[2]].cast<float>();
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    const float length = normal.norm();
    return length > 0.0F ? Eigen::Vector3f(normal / length) : normal;
  }

  CornerAttributes attributesOf(const Corner& corner, const Eigen::Vector3f& flat) const {
    CornerAttributes attributes;
    attributes.normal = corner.normal ? normals_[*corner.normal] : flat;
    if (corner.texture) attributes.texture = textures_[*corner.texture];
    return attributes;
  }

  std::string_view text_;
  VertexWelder welder_;
  std::vector<std::uint32_t> indices_;  ///< for each vertex of the file, the index of the welded vertex
  std::vector<Eigen::Vector3f> normals_;
  std::vector<Eigen::Vector2f> textures_;
  std::size_t verticesSoFar_ = 0;
  std::size_t texturesSoFar_ = 0;
  std::size_t normalsSoFar_ = 0;
  std::vector<Corner> corners_;  ///< corners of the face that is being read
  std::vector<Vector3> positions_;
  CornerMean mean_;
  MeshContent content_;
};

}  // namespace

MeshContent readObj(std::string_view text) { return Obj(text).read(); }

}  // namespace glissade
