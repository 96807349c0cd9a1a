#include "tests/engine/support/mesh_files.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/number_text.h"

namespace glissade::test {
namespace {

std::string numbers(const Vector3& v) { return toText(v.x()) + " " + toText(v.y()) + " " + toText(v.z()); }

template <class T>
std::string raw(T value, bool bigEndian = false) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (bigEndian) std::reverse(bytes.begin(), bytes.end());
  return {bytes.data(), bytes.size()};
}

TriangleMesh joined(const std::vector<TriangleMesh>& solids) {
  TriangleMesh whole;
  for (const TriangleMesh& solid : solids) append(whole, solid);
  return whole;
}

std::string textStl(const std::vector<TriangleMesh>& solids) {
  std::string text;
  for (const TriangleMesh& solid : solids) {
    text += "solid part\n";
    for (const TriangleIndices& triangle : solid.triangles) {
      text += "  facet normal " + numbers(faceNormal(solid, triangle)) + "\n    outer loop\n";
      for (const std::uint32_t corner : triangle) text += "      vertex " + numbers(solid.vertices[corner]) + "\n";
      text += "    endloop\n  endfacet\n";
    }
    text += "endsolid part\n";
  }
  return text;
}

std::string binaryStl(const TriangleMesh& mesh) {
  std::string bytes = "solid is what some programs begin binary files with";
  bytes.resize(80, ' ');
  bytes += raw(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const TriangleIndices& triangle : mesh.triangles) {
    const Vector3 normal = faceNormal(mesh, triangle);
    for (const double value : normal) bytes += raw(static_cast<float>(value));
    for (const std::uint32_t corner : triangle) {
      for (const double value : mesh.vertices[corner]) bytes += raw(static_cast<float>(value));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string obj(const std::vector<TriangleMesh>& solids) {
  std::string text;
  std::size_t before = 0;
  for (const TriangleMesh& solid : solids) {
    text += "o part\n";
    for (const Vector3& v : solid.vertices) text += "v " + numbers(v) + "\n";
    for (const auto& [a, b, c] : solid.triangles) {
      text += "f " + std::to_string(before + a + 1) + " " + std::to_string(before + b + 1) + " " +
              std::to_string(before + c + 1) + "\n";
    }
    before += solid.vertices.size();
  }
  return text;
}

/// Two triangles (a b c), (a c d) one after the other become the quadrilateral a b c d.
std::string objPolygons(const std::vector<TriangleMesh>& solids) {
  std::string text = "# polygons\r\nmtllib none.mtl\r\n";
  for (const TriangleMesh& solid : solids) {
    for (const Vector3& v : solid.vertices) text += "v " + numbers(v) + "\r\n";
    const auto corner = [&](std::uint32_t vertex) {
      return " " + std::to_string(static_cast<long>(vertex) - static_cast<long>(solid.vertices.size())) + "//-1";
    };
    for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
      const auto& [a, b, c] = solid.triangles[i];
      const Vector3 normal = faceNormal(solid, solid.triangles[i]);
      text += "vn " + numbers(normal) + "\r\nf" + corner(a) + corner(b) + corner(c);
      const bool more = i + 1 < solid.triangles.size();
      if (more && solid.triangles[i + 1][0] == a && solid.triangles[i + 1][1] == c &&
          (faceNormal(solid, solid.triangles[i + 1]) - normal).norm() < 1e-9) {
        text += " \\\r\n" + corner(solid.triangles[++i][2]);
      }
      text += "\r\n";
    }
  }
  return text;
}

std::string ply(const TriangleMesh& mesh, MeshFormat format) {
  const bool big = format == MeshFormat::BigPly;
  const std::string number = format == MeshFormat::LittlePly ? "float" : "double";
  std::string bytes = std::string("ply\nformat ") +
                      (format == MeshFormat::TextPly ? "ascii"
                       : big                         ? "binary_big_endian"
                                                     : "binary_little_endian") +
                      " 1.0\ncomment made by a test\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty uchar red\nproperty " + number + " x\nproperty " + number + " y\nproperty " + number +
                      " z\nelement face " + std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nproperty int flags\nend_header\n";
  for (const Vector3& v : mesh.vertices) {
    if (format == MeshFormat::TextPly) bytes += "255 " + numbers(v) + "\n";
    if (format == MeshFormat::TextPly) continue;
    bytes += '\x7f';
    for (const double value : v) bytes += big ? raw(value, true) : raw(static_cast<float>(value));
  }
  for (const TriangleIndices& triangle : mesh.triangles) {
    if (format == MeshFormat::TextPly) {
      bytes += "3 " + std::to_string(triangle[0]) + " " + std::to_string(triangle[1]) + " " +
               std::to_string(triangle[2]) + " 7\n";
      continue;
    }
    bytes += '\x03';
    for (const std::uint32_t corner : triangle) bytes += raw(corner, big);
    bytes += raw(std::uint32_t{7}, big);
  }
  return bytes;
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[(group >> (18 - 6 * k)) & 63U];
  }
  return text;
}

/// A mesh and a node a solid.
std::string gltf(const std::vector<TriangleMesh>& solids, bool container) {
  nlohmann::ordered_json json{
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"extensionsRequired", {"KHR_materials_unlit"}}};
  std::string data;
  const auto view = [&](const std::string& bytes, int type, const char* shape, std::size_t count) {
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}});
    json["accessors"].push_back(
        {{"bufferView", json["bufferViews"].size() - 1}, {"componentType", type}, {"type", shape}, {"count", count}});
    data += bytes;
    return json["accessors"].size() - 1;
  };
  for (const TriangleMesh& solid : solids) {
    std::string positions;
    for (const Vector3& v : solid.vertices) {
      for (const double value : v) positions += raw(static_cast<float>(value));
    }
    std::string indices;
    for (const TriangleIndices& triangle : solid.triangles) {
      for (const std::uint32_t corner : triangle) indices += raw(corner);
    }
    const std::size_t position = view(positions, 5126, "VEC3", solid.vertices.size());
    const std::size_t index = view(indices, 5125, "SCALAR", 3 * solid.triangles.size());
    json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", index}}}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  }
  json["buffers"].push_back({{"byteLength", data.size()}});
  if (!container) {
    json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(data);
    return json.dump(1);
  }
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  data.resize((data.size() + 3) / 4 * 4, '\0');
  return "glTF" + raw(std::uint32_t{2}) + raw(static_cast<std::uint32_t>(28 + text.size() + data.size())) +
         raw(static_cast<std::uint32_t>(text.size())) + "JSON" + text + raw(static_cast<std::uint32_t>(data.size())) +
         std::string("BIN\0", 4) + data;
}

std::string collada(const TriangleMesh& mesh) {
  std::string positions;
  for (const Vector3& v : mesh.vertices) positions += numbers(v) + " ";
  std::string indices;
  for (const auto& [a, b, c] : mesh.triangles) {
    indices += std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " ";
  }
  const std::string count = std::to_string(mesh.vertices.size());
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count=")" +
         std::to_string(3 * mesh.vertices.size()) + "\">" + positions +
         R"(</float_array><technique_common><accessor source="#a" count=")" + count +
         R"(" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count=")" +
         std::to_string(mesh.triangles.size()) + R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)" + indices +
         R"(</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// The number that follows a text.
std::size_t numberAfter(const std::string& content, const std::string& text) {
  return std::stoul(content.substr(content.find(text) + text.size(), 20));
}

std::size_t countInGltf(const std::string& json) {
  const auto document = nlohmann::json::parse(json);
  std::size_t corners = 0;
  for (const auto& mesh : document["meshes"]) {
    corners += document["accessors"][mesh["primitives"][0]["indices"].get<std::size_t>()]["count"].get<std::size_t>();
  }
  return corners / 3;
}

/// A face of n corners is n - 2 triangles.
std::size_t countInObj(const std::string& content) {
  std::string unfolded = content;
  for (std::size_t at; (at = unfolded.find("\\\r\n")) != std::string::npos;) unfolded.erase(at, 3);
  std::istringstream lines(unfolded);
  std::size_t triangles = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word != "f") continue;
    std::size_t corners = 0;
    while (words >> word) ++corners;
    triangles += corners - 2;
  }
  return triangles;
}

}  // namespace

std::string endingOf(MeshFormat format) {
  switch (format) {
    case MeshFormat::TextStl:
    case MeshFormat::BinaryStl: return "stl";
    case MeshFormat::Obj:
    case MeshFormat::ObjPolygons: return "obj";
    case MeshFormat::TextPly:
    case MeshFormat::LittlePly:
    case MeshFormat::BigPly: return "ply";
    case MeshFormat::Gltf: return "gltf";
    case MeshFormat::Glb: return "glb";
    case MeshFormat::Collada: return "dae";
  }
  return "";
}

bool isExact(MeshFormat format) {
  return format == MeshFormat::TextStl || format == MeshFormat::Obj || format == MeshFormat::ObjPolygons ||
         format == MeshFormat::TextPly || format == MeshFormat::BigPly;
}

std::string meshFile(MeshFormat format, const std::vector<TriangleMesh>& solids) {
  switch (format) {
    case MeshFormat::TextStl: return textStl(solids);
    case MeshFormat::BinaryStl: return binaryStl(joined(solids));
    case MeshFormat::Obj: return obj(solids);
    case MeshFormat::ObjPolygons: return objPolygons(solids);
    case MeshFormat::TextPly:
    case MeshFormat::LittlePly:
    case MeshFormat::BigPly: return ply(joined(solids), format);
    case MeshFormat::Gltf: return gltf(solids, false);
    case MeshFormat::Glb: return gltf(solids, true);
    case MeshFormat::Collada: return collada(joined(solids));
  }
  return "";
}

std::size_t countTriangles(MeshFormat format, const std::string& content) {
  switch (format) {
    case MeshFormat::TextStl: {
      std::size_t count = 0;
      for (std::size_t at = 0; (at = content.find("endfacet", at)) != std::string::npos; ++at) ++count;
      return count;
    }
    case MeshFormat::BinaryStl: return (content.size() - 84) / 50;
    case MeshFormat::Obj:
    case MeshFormat::ObjPolygons: return countInObj(content);
    case MeshFormat::TextPly:
    case MeshFormat::LittlePly:
    case MeshFormat::BigPly: return numberAfter(content, "element face ");
    case MeshFormat::Gltf: return countInGltf(content);
    case MeshFormat::Glb: return countInGltf(content.substr(20, content.find(std::string("BIN\0", 4)) - 24));
    case MeshFormat::Collada: return numberAfter(content, "<triangles count=\"");
  }
  return 0;
}

}  // namespace glissade::test
