#include "tests/oracle/triangle_files.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace glissade::oracle {
namespace {

std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class T>
T valueAt(const std::string& bytes, std::size_t offset) {
  if (offset + sizeof(T) > bytes.size()) throw std::runtime_error("ends too early");
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

Point floatsAt(const std::string& bytes, std::size_t offset) {
  return {double{valueAt<float>(bytes, offset)}, double{valueAt<float>(bytes, offset + 4)},
          double{valueAt<float>(bytes, offset + 8)}};
}

Triangles binaryStl(const std::string& bytes) {
  Triangles triangles;
  const auto count = valueAt<std::uint32_t>(bytes, 80);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 84 + 50 * i + 12;
    triangles.push_back({floatsAt(bytes, at), floatsAt(bytes, at + 12), floatsAt(bytes, at + 24)});
  }
  return triangles;
}

/// Reads every three lines "vertex x y z" as a triangle.
Triangles textStl(const std::string& text) {
  std::istringstream words(text);
  std::vector<Point> corners;
  for (std::string word; words >> word;) {
    if (word != "vertex") continue;
    Point p;
    for (double& coordinate : p) {
      words >> word;
      coordinate = std::stod(word);
    }
    corners.push_back(p);
  }
  if (corners.size() % 3 != 0) throw std::runtime_error("its vertices are no triangles");
  Triangles triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return triangles;
}

/// Reads polygons as fans about their first corner.
Triangles obj(const std::string& text) {
  std::istringstream lines(text);
  std::vector<Point> vertices;
  Triangles triangles;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Point p;
      for (double& coordinate : p) {
        words >> word;
        coordinate = std::stod(word);
      }
      vertices.push_back(p);
    } else if (word == "f") {
      std::vector<Point> corners;
      while (words >> word) {
        const long index = std::stol(word);
        corners.push_back(vertices.at(static_cast<std::size_t>(index > 0 ? index - 1 : std::ssize(vertices) + index)));
      }
      for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return triangles;
}

Triangles glb(const std::string& bytes) {
  const auto jsonLength = valueAt<std::uint32_t>(bytes, 12);
  const auto json = nlohmann::json::parse(bytes.substr(20, jsonLength));
  const std::size_t buffer = 20 + jsonLength + 8;
  const auto startOf = [&](const nlohmann::json& accessor) {
    const auto& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    return buffer + view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
  };
  Triangles triangles;
  for (const auto& mesh : json.at("meshes")) {
    for (const auto& primitive : mesh.at("primitives")) {
      const auto& accessors = json.at("accessors");
      const auto& indices = accessors.at(primitive.at("indices").get<std::size_t>());
      const std::size_t positions = startOf(accessors.at(primitive.at("attributes").at("POSITION").get<std::size_t>()));
      const bool wide = indices.at("componentType").get<int>() == 5125;
      const auto corner = [&](std::size_t i) {
        const std::size_t at = startOf(indices);
        const std::size_t index =
            wide ? valueAt<std::uint32_t>(bytes, at + 4 * i) : valueAt<std::uint16_t>(bytes, at + 2 * i);
        return floatsAt(bytes, positions + 12 * index);
      };
      const auto count = indices.at("count").get<std::size_t>();
      for (std::size_t i = 0; i + 2 < count; i += 3) triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
    }
  }
  return triangles;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

Triangles readTriangles(const std::string& file) {
  const std::string content = contentOf(file);
  try {
    if (endsWith(file, ".obj")) return obj(content);
    if (endsWith(file, ".glb")) return glb(content);
    if (!endsWith(file, ".stl")) throw std::runtime_error("has an ending that the oracle does not read");
    const bool binary =
        content.size() >= 84 && content.size() == 84 + 50 * std::size_t{valueAt<std::uint32_t>(content, 80)};
    return binary ? binaryStl(content) : textStl(content);
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

}  // namespace glissade::oracle
