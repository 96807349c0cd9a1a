#include "engine/scenario/part_expansion.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/import/asset_path.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/step_import.h"
#include "engine/import/step_parts.h"
#include "engine/scenario/scenario_bodies.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// What of a STEP file is spoken for.
struct Claim {
  std::string path;
  std::string node;
};

std::vector<Claim> claimsOf(const Scenario& scenario, const std::string& scenarioFile) {
  std::vector<Claim> claims;
  const auto add = [&](const Geometry& geometry) {
    const auto* step = std::get_if<StepGeometry>(&geometry);
    const auto* mesh = std::get_if<MeshGeometry>(&geometry);
    if (step == nullptr && (mesh == nullptr || !mesh->groups)) return;
    for (const Asset& asset : scenario.assets) {
      if (asset.id != *assetOf(geometry)) continue;
      claims.push_back({assetFile(asset, folderOf(scenarioFile)), step != nullptr ? step->part : mesh->part});
    }
  };
  for (const BodyDescription* body : allBodiesOf(scenario)) add(body->geometry);
  return claims;
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code noneThere;
  return a == b || fs::equivalent(a, b, noneThere);
}

/// The entry, or somebody who says more exactly which part is meant.
bool isTaken(const std::string& name, const PartFile& by, const std::vector<Claim>& claims) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
    return claim.node.size() > by.part.size() && isWithin(name, claim.node) && isSameFile(claim.path, by.path);
  });
}

std::vector<TreePlace> placesOf(const LoadedGeometry& wholeFile) {
  std::vector<TreePlace> places;
  for (const Occurrence& part : wholeFile.parts) places.push_back({part.path, part.names});
  return places;
}

/// As of Occurrence, of the steps of a node.
std::vector<std::string> namesAt(const std::string& node, const std::vector<TreePlace>& places) {
  const auto below =
      std::find_if(places.begin(), places.end(), [&](const TreePlace& place) { return isWithin(place.path, node); });
  if (below == places.end() || below->names.empty()) return {};
  return {below->names.begin(), below->names.begin() + static_cast<std::ptrdiff_t>(stepsOf(node).size())};
}

}  // namespace

Result<std::vector<PartFile>> oneEntryEach(const std::vector<PartFile>& parts, const Scenario& scenario,
                                           const std::string& scenarioFile, GeometryCache& read,
                                           const StopToken& stop) {
  std::vector<PartFile> named = parts;
  std::vector<std::vector<TreePlace>> places(parts.size());
  std::vector<Claim> claims = claimsOf(scenario, scenarioFile);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!isStepFile(parts[i].path) && !parts[i].groups) continue;
    PartFile whole = parts[i];
    whole.part.clear();
    const auto geometry = readPart(whole, read, stop);
    if (!geometry) return geometry.error();
    places[i] = placesOf(**geometry);
    auto node = nodeNamed(parts[i].part, treeOf(**geometry), parts[i].path);
    if (!node) return node.error();
    named[i].part = *node;
    named[i].names = namesAt(*node, places[i]);
    claims.push_back({parts[i].path, *node});
  }
  std::vector<PartFile> entries;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (places[i].size() < 2 || named[i].role == PartRole::Moves) {
      entries.push_back(named[i]);
      continue;
    }
    for (const TreePlace& place : places[i]) {
      if (!isWithin(place.path, named[i].part) || isTaken(place.path, named[i], claims)) continue;
      entries.push_back(named[i]);
      entries.back().part = place.path;
      entries.back().names = place.names;
    }
  }
  return entries;
}

}  // namespace glissade
