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

std::string assetPathFrom(const std::string& folder, const std::string& file) {
  const fs::path from = withoutLinks(folder);
  const fs::path named = withoutLinks(file);
  return shareMoreThanTheRoot(named, from) ? named.lexically_relative(from).generic_string() : named.generic_string();
}

Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile) {
  const std::string from = folderOf(oldFile);
  const std::string to = folderOf(newFile);
  if (!oldFile.empty() && withoutLinks(from) == withoutLinks(to)) return scenario;
  for (Asset& asset : scenario.assets) asset.path = assetPathFrom(to, assetFile(asset, from));
  return scenario;
}

}  // namespace glissade
