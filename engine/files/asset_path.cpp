#include "engine/files/asset_path.h"

#include "engine/base/file.h"

namespace glissade {

Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile) {
  const std::string from = folderOf(oldFile);
  const std::string to = folderOf(newFile);
  if (!oldFile.empty() && withoutLinks(from) == withoutLinks(to)) return scenario;
  for (Asset& asset : scenario.assets) asset.path = assetPathFrom(to, assetFile(asset, from));
  return scenario;
}

}  // namespace glissade
