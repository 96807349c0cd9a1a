#include "engine/scenario/part_expansion.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/import/asset_path.h"
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
    if (step == nullptr) return;
    for (const Asset& asset : scenario.assets) {
      if (asset.id == step->asset) claims.push_back({assetFile(asset, folderOf(scenarioFile)), step->part});
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

}  // namespace

Result<std::vector<PartFile>> oneEntryEach(const std::vector<PartFile>& parts, const Scenario& scenario,
                                           const std::string& scenarioFile, GeometryCache& read,
                                           const StopToken& stop) {
  std::vector<PartFile> named = parts;
  std::vector<std::vector<std::string>> names(parts.size());
  std::vector<Claim> claims = claimsOf(scenario, scenarioFile);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!isStepFile(parts[i].path)) continue;
    PartFile whole = parts[i];
    whole.part.clear();
    const auto geometry = readPart(whole, read, stop);
    if (!geometry) return geometry.error();
    names[i] = namesOf(**geometry);
    auto node = nodeNamed(parts[i].part, names[i], parts[i].path);
    if (!node) return node.error();
    named[i].part = *node;
    claims.push_back({parts[i].path, *node});
  }
  std::vector<PartFile> entries;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (names[i].size() < 2 || named[i].role == PartRole::Moves) {
      entries.push_back(named[i]);
      continue;
    }
    for (const std::string& name : names[i]) {
      if (!isWithin(name, named[i].part) || isTaken(name, named[i], claims)) continue;
      entries.push_back(named[i]);
      entries.back().part = name;
    }
  }
  return entries;
}

}  // namespace glissade
