#include "engine/files/swept_volume_file.h"

#include <glissade/version.h>

#include <array>
#include <bit>
#include <cstring>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/files/glb_scene.h"

namespace glissade {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is little-endian");

constexpr double kMillimetres = 1e3;
constexpr double kSweepOpacity = 0.5;

void appendBytes(std::string& bytes, const void* from, std::size_t count) {
  bytes.append(static_cast<const char*>(from), count);
}

void appendVector(std::string& bytes, const Vector3& v) {
  const Eigen::Vector3f rounded = v.cast<float>();
  appendBytes(bytes, rounded.data(), 3 * sizeof(float));
}

std::string asStl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const std::string title = "Swept volume, millimetres, by Glissade";
  bytes.replace(0, title.size(), title);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  appendBytes(bytes, &count, sizeof count);
  constexpr std::array<char, 2> kNoAttribute{0, 0};
  for (const TriangleIndices& triangle : mesh.triangles) {
    appendVector(bytes, faceNormal(mesh, triangle));
    for (const std::uint32_t vertex : triangle) appendVector(bytes, kMillimetres * mesh.vertices[vertex]);
    bytes.append(kNoAttribute.data(), kNoAttribute.size());
  }
  return bytes;
}

Result<std::string> asGlb(const SweptVolume& sweep, const std::string& name, const Colour& colour) {
  GlbBuilder glb(std::string("Glissade ") + kVersion);
  glb.json()["scene"] = 0;
  glb.json()["scenes"] =
      GlbBuilder::Json::array({{{"name", name},
                                {"nodes", GlbBuilder::Json::array({0})},
                                {"extras", {{"bound_m", sweep.bound}, {"volume_m3", sweep.volume}}}}});
  RigidBody body;
  body.id = BodyId(name);
  body.name = name;
  body.mesh = std::make_shared<const TriangleMesh>(sweep.surface_W);
  body.colour = colour;
  addGlbBody(glb, addGlbWorld(glb), body, kSweepOpacity);
  return glb.bytes();
}

}  // namespace

Outcome saveSweptVolume(const SweptVolume& sweep, const std::string& name, const Colour& colour,
                        const std::string& file, Warnings& warnings) {
  const std::string ending = endingOf(file);
  if (ending != "stl" && ending != "glb") {
    return Diagnostic{ErrorKind::Usage, file, "", GLISSADE_TEXT("a swept volume is written as .stl or .glb"),
                      GLISSADE_TEXT("Give a file name with one of these endings.")};
  }
  const Result<std::string> content =
      ending == "stl" ? Result<std::string>(asStl(sweep.surface_W)) : asGlb(sweep, name, colour);
  if (!content) return content.error();
  return saveFile(file, *content, warnings);
}

}  // namespace glissade
