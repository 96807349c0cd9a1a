// Writes valid messages of the STEP importer by engine/import/import_protocol.h: the corpus of step-protocol. usage:
// write_step_messages FOLDER
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "engine/geometry/surface_face.h"
#include "engine/import/import_protocol.h"

namespace {

namespace protocol = glissade::import_protocol;
using Kind = glissade::SurfaceFace::Kind;
using Kinds = std::array<Kind, 2>;

constexpr std::array<std::array<double, 3>, 4> kCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::array<std::uint32_t, 3>, 4> kTriangles{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// Appends records to a message.
class Answer {
 public:
  template <class Record>
  Answer& add(const Record& record) {
    static_assert(std::is_trivially_copyable_v<Record>);
    bytes_.append(reinterpret_cast<const char*>(&record), sizeof(record));
    return *this;
  }
  Answer& addText(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

struct NamedPart {
  std::string path;
  std::string names{};
  std::uint32_t shape = 0;
  std::string formerPath{};
  bool isSolidOfPart = false;
};

struct ExternalUse {
  std::string path;
  std::string names;
  std::string file;
};

std::uint32_t sizeOf(const std::string& text) { return static_cast<std::uint32_t>(text.size()); }

protocol::Face faceOf(Kind kind, std::uint32_t triangles) {
  protocol::Face face;
  face.kind = static_cast<std::uint32_t>(kind);
  face.triangles = triangles;
  face.deflection = 0.01;
  if (kind == Kind::Cone || kind == Kind::Torus) {
    face.radius = 2.0;
    face.second = 0.5;
  }
  return face;
}

/// Adds a tetrahedron with `kinds` for its faces, which have two triangles each.
void addShape(Answer& message, const Kinds& kinds) {
  message.add(protocol::Shape{kCorners.size(), kTriangles.size(), std::tuple_size_v<Kinds>, 0})
      .add(kCorners)
      .add(kTriangles);
  for (const Kind kind : kinds) message.add(faceOf(kind, 2));
}

std::string messageOf(const std::vector<Kinds>& shapes, const std::vector<NamedPart>& parts,
                      const std::vector<ExternalUse>& externals, const std::string& notes,
                      const std::string& rootName) {
  Answer message;
  const auto count = static_cast<std::uint32_t>(shapes.size() * kCorners.size());
  message.add(protocol::Header{protocol::kMagic, protocol::kAssembly, count, count});
  message.add(protocol::AssemblyCounts{static_cast<std::uint32_t>(shapes.size()),
                                       static_cast<std::uint32_t>(parts.size()), sizeOf(notes),
                                       static_cast<std::uint32_t>(externals.size()), sizeOf(rootName), 0, 0.0254});
  message.addText(rootName);
  for (const auto& kinds : shapes) addShape(message, kinds);
  for (const NamedPart& part : parts) {
    protocol::Part record;
    record.shape = part.shape;
    record.hasColour = part.shape;
    record.position[0] = 1.0;
    record.colour[1] = 0.2;
    record.pathBytes = sizeOf(part.path);
    record.namesBytes = sizeOf(part.names);
    record.formerPathBytes = sizeOf(part.formerPath);
    record.isSolidOfPart = part.isSolidOfPart ? 1 : 0;
    message.add(record).addText(part.path).addText(part.names).addText(part.formerPath);
  }
  for (const ExternalUse& use : externals) {
    protocol::ExternalPart record;
    record.position[0] = 5.0;
    record.pathBytes = sizeOf(use.path);
    record.namesBytes = sizeOf(use.names);
    record.fileBytes = sizeOf(use.file);
    message.add(record).addText(use.path).addText(use.names).addText(use.file);
  }
  return message.addText(notes).bytes();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_step_messages FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder(argv[1]);
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  write("one-part", messageOf({{Kind::Free, Kind::Plane}}, {{"L\u00e4ufer"}}, {}, "", ""));
  write("notes", messageOf({{Kind::Free, Kind::Free}}, {{"L\u00e4ufer"}}, {},
                           R"({"kind": "L", "place": {"text": "#12"}, "text": {"text": "a face"}})"
                           "\n"
                           R"({"kind": "H", "place": {"text": "part '%1'", "arguments": ["L\u00e4ufer"]},)"
                           R"( "text": {"text": "a %1, %2 off", "arguments": [{"text": "cone"}, {"length": 1e-5}]}})"
                           "\n"
                           R"({"kind": "M", "product": "pin", "entity": "#14", "shape": "CSG_SOLID",)"
                           R"( "text": {"text": "its kind is not read"}})"
                           "\n",
                           ""));
  write("two-parts", messageOf({{Kind::Free, Kind::Cylinder}, {Kind::Cone, Kind::Torus}},
                               {{"pump/rotor", "pump\t\t\nrotor/left\tupper rotor\t\n"},
                                {"pin", "", 1, "stift"},
                                {"pin#2", "pin\t\tX1\n", 1},
                                {"frame/solid", "", 0, "", true},
                                {"frame/solid#2", "", 1, "", true}},
                               {}, "", ""));
  write("external-part",
        messageOf({{Kind::Plane, Kind::Plane}}, {{"L\u00e4ufer"}}, {{"foot", "foot\t\t\n", "foot.stp"}}, "", "unit"));
  return 0;
}
