#include "engine/import/step_answer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "engine/base/printable_text.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

using Kind = SurfaceFace::Kind;

/// Largest number of bytes of a name, or of the names on a path.
constexpr std::uint32_t kLongestName = 1U << 16;

bool isLength(double value) { return value >= 0.0 && value <= protocol::kLargestFace; }

/// True if the second size is within the limits of its kind.
bool isSecond(double value, Kind kind) {
  constexpr double kRightAngle = 1.5707963267948966;
  if (kind == Kind::Torus) return isLength(value);
  return kind == Kind::Cone ? value >= 0.0 && value < kRightAngle : value == 0.0;
}

/// The face in metres; nothing if a number is impossible for a face.
std::optional<SurfaceFace> faceOf(const protocol::Face& record) {
  if (record.kind > static_cast<std::uint32_t>(Kind::Torus)) return std::nullopt;
  SurfaceFace face{static_cast<Kind>(record.kind),
                   protocol::kMillimetre * Vector3(record.point[0], record.point[1], record.point[2]),
                   Vector3(record.axis[0], record.axis[1], record.axis[2]),
                   protocol::kMillimetre * record.radius,
                   record.second,
                   protocol::kMillimetre * record.deflection};
  if (face.kind == Kind::Torus) face.second *= protocol::kMillimetre;
  constexpr double kUnit = 1e-9;
  const bool sound = face.point.cwiseAbs().maxCoeff() <= protocol::kLargestFace && face.point.allFinite() &&
                     std::abs(face.axis.norm() - 1.0) <= kUnit && isLength(face.radius) &&
                     isSecond(face.second, face.kind) && isLength(face.deflection);
  return sound ? std::optional(face) : std::nullopt;
}

/// True for a plausible unit of length, metres.
bool isUnit(double metres) { return metres >= 1e-9 && metres <= 1e6; }

struct Shape {
  MeshPtr mesh;
  double deflection = 0.0;
  std::size_t facesWithoutMesh = 0;
};

/// Decodes the output of the importing program.
class StepDecoder {
 public:
  StepDecoder(const ImporterCall& call, ImporterAnswer& answer) : call_(call), answer_(answer) {}

  Result<StepAnswer> decode() {
    protocol::AssemblyCounts counts;
    if (!answer_.message.take(&counts, 1) || counts.parts > protocol::kMostParts || counts.shapes > counts.parts ||
        counts.externalParts > protocol::kMostOccurrences || !isUnit(counts.unit)) {
      return broken();
    }
    StepAnswer product;
    if (!takeName(counts.rootNameBytes, product.rootName)) return broken();
    for (std::uint32_t i = 0; i < counts.shapes; ++i) {
      if (const Outcome taken = takeShape(); !taken) return taken.error();
    }
    for (std::uint32_t i = 0; i < counts.parts; ++i) {
      auto part = takePart();
      if (!part) return part.error();
      part->unit = counts.unit;
      if (!part->mesh->empty()) product.parts.push_back(std::move(*part));
    }
    for (std::uint32_t i = 0; i < counts.externalParts; ++i) {
      auto external = takeExternal();
      if (!external) return external.error();
      product.externals.push_back(std::move(*external));
    }
    if (product.parts.empty() && product.externals.empty()) {
      return refusalOf(call_, GLISSADE_TEXT("has no face that could be tessellated"));
    }
    const std::string notes = answer_.message.rest();
    if (notes.size() != counts.noteBytes) return broken();
    if (!takeNotes(notes, product)) return broken();
    return product;
  }

 private:
  Diagnostic broken() const { return refusalOf(call_, GLISSADE_TEXT("the importer failed on it")); }

  /// One note a line. False if one has another form.
  bool takeNotes(const std::string& notes, StepAnswer& product) const {
    std::istringstream lines(notes);
    for (std::string line; std::getline(lines, line);) {
      const auto note = nlohmann::json::parse(line, nullptr, false);
      const auto kind = nameIn(note, "kind");
      const auto text = messageIn(note, "text");
      if (!kind || kind->size() != 1 || !text) return false;
      const bool isTaken = kind->front() == protocol::kMissingLine ? takeMissing(note, *text, product)
                                                                   : takeWarning(kind->front(), note, *text, product);
      if (!isTaken) return false;
    }
    return true;
  }

  static bool takeMissing(const nlohmann::json& note, const Message& reason, StepAnswer& product) {
    const auto name = nameIn(note, "product");
    const auto entity = nameIn(note, "entity");
    const auto shape = nameIn(note, "shape");
    if (!name || !entity || !shape) return false;
    product.missing.push_back({"", *name, *entity, *shape, reason});
    return true;
  }

  bool takeWarning(char kind, const nlohmann::json& note, const Message& text, StepAnswer& product) const {
    const auto place = messageIn(note, "place");
    if (!place) return false;
    product.warnings.push_back(warningOf(kind, *place, text));
    return true;
  }

  /// A printable text on one line; nothing if there is none.
  static std::optional<std::string> nameIn(const nlohmann::json& note, const char* key) {
    if (!note.is_object() || !note.contains(key) || !note[key].is_string()) return std::nullopt;
    auto name = note[key].get<std::string>();
    return isLine(name) ? std::optional(std::move(name)) : std::nullopt;
  }

  /// A message whose text is printable on one line; nothing if there is none.
  static std::optional<Message> messageIn(const nlohmann::json& note, const char* key) {
    if (!note.is_object() || !note.contains(key)) return std::nullopt;
    auto message = messageOfProgram(note[key]);
    return message && isLine(toString(*message)) ? message : std::nullopt;
  }

  Diagnostic warningOf(char kind, const Location& where, const Message& what) const {
    if (kind == protocol::kHealedLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what,
              GLISSADE_TEXT("The deviation counts in every certificate; export the part as a mesh if it is too much.")};
    }
    const CatalogueText doubt = GLISSADE_TEXT("Do not trust paths near it; export it again, or as a mesh.");
    if (kind == protocol::kVolumeLine) return {ErrorKind::MalformedInput, call_.file, where, what, doubt};
    if (kind == protocol::kShapeLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what,
              GLISSADE_TEXT(
                  "It is an obstacle that can be inside of others. Export it as a solid, or exclude it (--without).")};
    }
    if (kind == protocol::kCurveLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what, GLISSADE_TEXT("Give them faces if they are parts.")};
    }
    if (kind == protocol::kOrphanLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what,
              GLISSADE_TEXT("Exclude it if it is no part (--without).")};
    }
    if (kind == protocol::kSecondLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what,
              GLISSADE_TEXT("Export solids and triangles as two products if they are two parts.")};
    }
    if (kind == protocol::kForeignNamesLine || kind == protocol::kDoubtfulNamesLine) {
      return {ErrorKind::MalformedInput, call_.file, where, what,
              GLISSADE_TEXT(
                  "Where that is wrong, export it with names in UTF-8, or name its parts by their numbers (#2).")};
    }
    return {
        ErrorKind::MalformedInput,
        call_.file,
        where,
        {GLISSADE_TEXT("%1: the part is not closed there; certificates take what is missing as free space"), {what}},
        doubt};
  }

  Outcome takeShape() {
    protocol::Shape record;
    if (!answer_.message.take(&record, 1) || record.vertices > answer_.header.vertices ||
        record.triangles > answer_.header.triangles || record.faces > protocol::kMostFaces - faces_) {
      return broken();
    }
    std::vector<double> coordinates(std::size_t{3} * record.vertices);
    TriangleMesh mesh;
    mesh.triangles.resize(record.triangles);
    if (!answer_.message.take(coordinates.data(), coordinates.size()) ||
        !answer_.message.take(mesh.triangles.data(), mesh.triangles.size())) {
      return broken();
    }
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      mesh.vertices.emplace_back(protocol::kMillimetre *
                                 Vector3(coordinates[i], coordinates[i + 1], coordinates[i + 2]));
    }
    if (const auto fault = faultOf(mesh)) return refusalOf(call_, *fault);
    if (record.faces > 0 && !takeFaces(record.faces, mesh)) return broken();
    double deflection = 0.0;
    for (const SurfaceFace& face : mesh.faces) deflection = std::max(deflection, face.deflection);
    shapes_.push_back({std::make_shared<const TriangleMesh>(welded(mesh)), deflection, record.facesWithoutMesh});
    return Done{};
  }

  /// Takes the faces; each triangle belongs to one, and each has a triangle.
  bool takeFaces(std::uint32_t count, TriangleMesh& mesh) {
    faces_ += count;
    std::vector<protocol::Face> records(count);
    if (!answer_.message.take(records.data(), records.size())) return false;
    for (const protocol::Face& record : records) {
      const auto face = faceOf(record);
      if (!face || record.triangles == 0 || record.triangles > mesh.triangles.size() - mesh.faceOf.size()) return false;
      mesh.faceOf.insert(mesh.faceOf.end(), record.triangles, static_cast<std::uint32_t>(mesh.faces.size()));
      mesh.faces.push_back(*face);
    }
    return mesh.faceOf.size() == mesh.triangles.size();
  }

  bool takeName(std::uint32_t bytes, std::string& name) {
    if (bytes > kLongestName) return false;
    name.resize(bytes);
    return answer_.message.take(name.data(), name.size()) && name == printableLine(name);
  }

  /// Takes one line for each step of the path, or none.
  bool takeNames(std::uint32_t bytes, const std::string& path, std::vector<NodeNames>& names) {
    if (bytes > kLongestName) return false;
    std::string text(bytes, ' ');
    if (!answer_.message.take(text.data(), text.size())) return false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t first = line.find('\t');
      const std::size_t second = first == std::string::npos ? first : line.find('\t', first + 1);
      if (second == std::string::npos) return false;
      names.push_back({line.substr(0, first), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
    }
    const bool printable = std::all_of(names.begin(), names.end(), [](const NodeNames& each) {
      return isLine(each.product) && isLine(each.occurrence) && isLine(each.designator);
    });
    return printable && (bytes == 0 || (text.back() == '\n' && names.size() == stepsOf(path).size()));
  }

  static bool isLine(const std::string& name) { return name == printableLine(name); }

  /// Takes a path, which has to be unique.
  bool takePath(std::uint32_t bytes, std::string& path) { return takeName(bytes, path) && paths_.insert(path).second; }

  template <class Record>
  Result<Pose> placeOf(const Record& record) const {
    Pose X_FP;
    X_FP.position = protocol::kMillimetre * Vector3(record.position[0], record.position[1], record.position[2]);
    const auto& [x, y, z, w] = record.orientation;
    X_FP.orientation = Quaternion(w, x, y, z).normalized();
    if (!isValid(X_FP)) return refusalOf(call_, GLISSADE_TEXT("has a part that is at no place in space"));
    return X_FP;
  }

  Result<StepExternal> takeExternal() {
    protocol::ExternalPart record;
    StepExternal external;
    if (!answer_.message.take(&record, 1) || !takePath(record.pathBytes, external.path) ||
        !takeNames(record.namesBytes, external.path, external.names) || !takeName(record.fileBytes, external.file) ||
        external.file.empty()) {
      return broken();
    }
    const auto place = placeOf(record);
    if (!place) return place.error();
    external.X_FP = *place;
    return external;
  }

  Result<Occurrence> takePart() {
    protocol::Part record;
    if (!answer_.message.take(&record, 1) || record.shape >= shapes_.size()) return broken();
    const Shape& shape = shapes_[record.shape];
    Occurrence part{"", shape.mesh, {}, {}, shape.deflection, shape.facesWithoutMesh};
    if (!takePath(record.pathBytes, part.path) || !takeNames(record.namesBytes, part.path, part.names) ||
        !takeName(record.formerPathBytes, part.formerPath)) {
      return broken();
    }
    part.isSolidOfPart = record.isSolidOfPart != 0 && !part.path.empty();
    const auto place = placeOf(record);
    if (!place) return place.error();
    part.X_FP = *place;
    if (record.hasColour != 0) {
      if (!std::all_of(record.colour, record.colour + 3, [](double value) { return std::isfinite(value); })) {
        return broken();
      }
      part.colour.emplace();
      std::transform(record.colour, record.colour + 3, part.colour->begin(),
                     [](double value) { return std::clamp(value, 0.0, 1.0); });
    }
    return part;
  }

  const ImporterCall& call_;
  ImporterAnswer& answer_;
  std::vector<Shape> shapes_;
  std::uint32_t faces_ = 0;
  std::set<std::string> paths_;
};

}  // namespace

Result<StepAnswer> decodeStepAnswer(const ImporterCall& call, ImporterAnswer& answer) {
  return StepDecoder(call, answer).decode();
}

}  // namespace glissade
