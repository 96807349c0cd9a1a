#include "tests/oracle/mesh_writer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace glissade::oracle {
namespace {

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

void appendFloats(std::string& bytes, const Point& p) {
  for (const double coordinate : p) append(bytes, static_cast<float>(coordinate));
}

/// Triangles with shared vertices: equal corners are one vertex.
struct Indexed {
  std::vector<Point> vertices;
  std::vector<std::uint32_t> indices;

  explicit Indexed(const Triangles& triangles) {
    std::map<Point, std::uint32_t> known;
    for (const Triangle& triangle : triangles) {
      for (const Point& p : triangle) {
        const auto [at, isNew] = known.try_emplace(p, static_cast<std::uint32_t>(vertices.size()));
        if (isNew) vertices.push_back(p);
        indices.push_back(at->second);
      }
    }
  }
};

std::ostringstream textStream() {
  std::ostringstream stream;
  stream.precision(17);
  return stream;
}

std::string textStl(const Triangles& triangles) {
  std::ostringstream text = textStream();
  text << "solid part\n";
  for (const Triangle& triangle : triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const auto& [x, y, z] : triangle) text << "vertex " << x << " " << y << " " << z << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid part\n";
  return text.str();
}

std::string binaryStl(const Triangles& triangles) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    appendFloats(bytes, {0, 0, 0});
    for (const Point& p : triangle) appendFloats(bytes, p);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj(const Triangles& triangles) {
  const Indexed mesh(triangles);
  std::ostringstream text = textStream();
  for (const auto& [x, y, z] : mesh.vertices) text << "v " << x << " " << y << " " << z << "\n";
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    text << "f " << mesh.indices[i] + 1 << " " << mesh.indices[i + 1] + 1 << " " << mesh.indices[i + 2] + 1 << "\n";
  }
  return text.str();
}

std::string glb(const Triangles& triangles) {
  using Json = nlohmann::json;
  const Indexed mesh(triangles);
  std::string data;
  for (const std::uint32_t index : mesh.indices) append(data, index);
  const std::size_t positions = data.size();
  std::array<std::vector<float>, 2> bounds{std::vector<float>(3, 3e38F), std::vector<float>(3, -3e38F)};
  for (const Point& p : mesh.vertices) {
    appendFloats(data, p);
    for (std::size_t i = 0; i < 3; ++i) {
      bounds[0][i] = std::min(bounds[0][i], static_cast<float>(p[i]));
      bounds[1][i] = std::max(bounds[1][i], static_cast<float>(p[i]));
    }
  }
  const Json json{{"asset", {{"version", "2.0"}}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", {0}}}}},
                  {"nodes", {{{"mesh", 0}}}},
                  {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 1}}}, {"indices", 0}}}}}}},
                  {"accessors",
                   {{{"bufferView", 0}, {"componentType", 5125}, {"count", mesh.indices.size()}, {"type", "SCALAR"}},
                    {{"bufferView", 1},
                     {"componentType", 5126},
                     {"count", mesh.vertices.size()},
                     {"type", "VEC3"},
                     {"min", bounds[0]},
                     {"max", bounds[1]}}}},
                  {"bufferViews",
                   {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions}},
                    {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", data.size() - positions}}}},
                  {"buffers", {{{"byteLength", data.size()}}}}};
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(28 + text.size() + data.size()));
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  append(bytes, static_cast<std::uint32_t>(data.size()));
  bytes.append("BIN\0", 4);
  return bytes + data;
}

}  // namespace

std::string endingOf(MeshFormat format) {
  switch (format) {
    case MeshFormat::TextStl:
    case MeshFormat::BinaryStl: return ".stl";
    case MeshFormat::Obj: return ".obj";
    case MeshFormat::Glb: return ".glb";
  }
  return "";
}

std::string meshFile(const Triangles& triangles, MeshFormat format) {
  switch (format) {
    case MeshFormat::TextStl: return textStl(triangles);
    case MeshFormat::BinaryStl: return binaryStl(triangles);
    case MeshFormat::Obj: return obj(triangles);
    case MeshFormat::Glb: return glb(triangles);
  }
  return "";
}

}  // namespace glissade::oracle
