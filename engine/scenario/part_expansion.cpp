#include "engine/scenario/part_expansion.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/import/asset_path.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/part_solids.h"
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

/// A part of several solids of which one is named is taken as its solids.
bool isOpen(const std::string& part, const PartFile& by, const std::vector<Claim>& claims) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
    return claim.node.size() > part.size() && isWithin(claim.node, part) && isSameFile(claim.path, by.path);
  });
}

/// As of Occurrence, of the steps of a node.
std::vector<NodeNames> namesAt(const std::string& node, const std::vector<Occurrence>& places) {
  const auto below =
      std::find_if(places.begin(), places.end(), [&](const Occurrence& place) { return isWithin(place.path, node); });
  if (below == places.end() || below->names.empty()) return {};
  return {below->names.begin(), below->names.begin() + static_cast<std::ptrdiff_t>(stepsOf(node).size())};
}

/// One entry for each part of the file that lies within the one that is named.
std::vector<PartFile> entriesOf(const PartFile& named, const std::vector<Occurrence>& places,
                                const std::vector<Claim>& claims) {
  std::vector<PartFile> entries;
  for (const Occurrence& place : places) {
    const std::string whole = partPathOf(place);
    PartFile entry = named;
    entry.asOne = place.isSolidOfPart && !isOpen(whole, named, claims);
    entry.part = entry.asOne ? whole : place.path;
    const bool isKnown = entry.asOne && !entries.empty() && entries.back().part == whole;
    if (isKnown || !isWithin(entry.part, named.part) || isTaken(entry.part, named, claims)) continue;
    entry.names = namesAt(entry.part, places);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Whether the file is several parts.
bool hasSeveral(const PartFile& named, const std::vector<Occurrence>& places, const std::vector<Claim>& claims) {
  return std::any_of(places.begin(), places.end(), [&](const Occurrence& place) {
    const std::string whole = partPathOf(place);
    return whole != partPathOf(places.front()) || (place.isSolidOfPart && isOpen(whole, named, claims));
  });
}

}  // namespace

Result<std::vector<PartFile>> oneEntryEach(const std::vector<PartFile>& parts, const Scenario& scenario,
                                           const std::string& scenarioFile, GeometryCache& read,
                                           const StopToken& stop) {
  std::vector<PartFile> named = parts;
  std::vector<std::vector<Occurrence>> places(parts.size());
  std::vector<Claim> claims = claimsOf(scenario, scenarioFile);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!isCadFile(parts[i].path) && !parts[i].groups) continue;
    PartFile whole = parts[i];
    whole.part.clear();
    whole.asOne = false;
    const auto geometry = readPart(whole, read, stop);
    if (!geometry) return geometry.error();
    places[i] = (*geometry)->parts;
    auto node = nodeNamed(parts[i].part, treeOf(**geometry), parts[i].path);
    if (!node) return node.error();
    named[i].part = *node;
    named[i].names = namesAt(*node, places[i]);
    named[i].asOne = std::any_of(places[i].begin(), places[i].end(), [&](const Occurrence& place) {
      return place.isSolidOfPart && isWithin(partPathOf(place), *node);
    });
    claims.push_back({parts[i].path, *node});
  }
  std::vector<PartFile> entries;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i].role == PartRole::Moves || !hasSeveral(named[i], places[i], claims)) {
      entries.push_back(named[i]);
      continue;
    }
    for (PartFile& entry : entriesOf(named[i], places[i], claims)) entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace glissade
