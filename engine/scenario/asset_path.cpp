#include "engine/scenario/asset_path.h"

#include <filesystem>
#include <iterator>

#include "engine/base/file.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Absolute and without symbolic links: ".." of a linked folder is not the folder that holds the link.
fs::path withoutLinks(const fs::path& path) {
  std::error_code ignored;
  const fs::path found = fs::weakly_canonical(path, ignored);
  return found.empty() ? path : found;
}

bool shareMoreThanTheRoot(const fs::path& a, const fs::path& b) {
  const fs::path insideA = a.relative_path();
  const fs::path insideB = b.relative_path();
  return !insideA.empty() && !insideB.empty() && *insideA.begin() == *insideB.begin();
}

}  // namespace

std::string assetFile(const Asset& asset, const std::string& folder) {
  const fs::path named(asset.path);
  if (named.is_absolute()) return named.string();
  const fs::path inside = named.lexically_normal();
  if (!inside.empty() && *inside.begin() == "..") return (withoutLinks(folder) / named).string();
  return (fs::path(folder) / named).lexically_normal().string();
}

Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile) {
  const fs::path from = withoutLinks(folderOf(oldFile));
  const fs::path to = withoutLinks(folderOf(newFile));
  if (from == to) return scenario;
  for (Asset& asset : scenario.assets) {
    const fs::path file = withoutLinks(assetFile(asset, folderOf(oldFile)));
    asset.path = shareMoreThanTheRoot(file, to) ? file.lexically_relative(to).generic_string() : file.generic_string();
  }
  return scenario;
}

}  // namespace glissade
