#include "tests/oracle/scene_file.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/oracle/triangle_files.h"

namespace glissade::oracle {
namespace {

using Json = nlohmann::json;

Placement placementOf(const Json& json) {
  return {json.at("position").get<Point>(), json.at("orientation").get<Rotation>()};
}

}  // namespace

Scene readScene(const std::string& file) {
  std::ifstream stream(file);
  const Json json = Json::parse(stream);
  std::map<std::string, Triangles> assets;
  for (const Json& asset : json.at("assets")) {
    if (asset.value("up_axis", "z") != "z") throw std::runtime_error(file + ": an asset is not Z-up");
    const auto path = std::filesystem::path(file).parent_path() / asset.at("path").get<std::string>();
    Triangles triangles = readTriangles(path.string());
    const double unit = asset.value("unit", 1.0);
    for (Triangle& triangle : triangles) {
      for (Point& p : triangle) p = unit * p;
    }
    assets[asset.at("id").get<std::string>()] = std::move(triangles);
  }
  const auto meshOf = [&](const Json& body) { return assets.at(body.at("geometry").at("mesh").get<std::string>()); };
  Scene scene;
  scene.object = meshOf(json.at("object"));
  for (const Json& body : json.at("bodies")) {
    const Triangles triangles = meshOf(body);
    scene.bodies.push_back(body.contains("pose") ? placed(placementOf(body.at("pose")), triangles) : triangles);
  }
  return scene;
}

std::vector<Placement> readPath(const std::string& file) {
  std::ifstream stream(file);
  std::vector<Placement> path;
  std::string line;
  std::getline(stream, line);  // skips the names of the columns
  while (std::getline(stream, line)) {
    std::vector<double> numbers;
    std::istringstream cells(line);
    for (std::string cell; numbers.size() < 9 && std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    if (numbers.size() < 9) throw std::runtime_error(file + ": a line has fewer than nine columns");
    path.push_back({{numbers[2], numbers[3], numbers[4]}, {numbers[5], numbers[6], numbers[7], numbers[8]}});
  }
  return path;
}

Placement between(const Placement& a, const Placement& b, double t) {
  const Rotation& p = a.orientation;
  Rotation q = b.orientation;
  double cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
  if (cosine < 0.0) {
    for (double& component : q) component = -component;
    cosine = -cosine;
  }
  Rotation across;  // q without its part along p
  for (std::size_t i = 0; i < 4; ++i) across[i] = q[i] - cosine * p[i];
  const double sine =
      std::sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2] + across[3] * across[3]);
  const double angle = std::atan2(sine, cosine);
  Placement result;
  result.position = a.position + t * (b.position - a.position);
  for (std::size_t i = 0; i < 4; ++i) {
    result.orientation[i] = std::cos(t * angle) * p[i] + (sine > 0.0 ? std::sin(t * angle) / sine * across[i] : 0.0);
  }
  return result;
}

}  // namespace glissade::oracle
