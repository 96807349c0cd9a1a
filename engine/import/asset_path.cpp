#include "engine/import/asset_path.h"

#include <filesystem>

namespace glissade {
namespace {

namespace fs = std::filesystem;

bool shareMoreThanTheRoot(const fs::path& a, const fs::path& b) {
  const fs::path insideA = a.relative_path();
  const fs::path insideB = b.relative_path();
  return !insideA.empty() && !insideB.empty() && *insideA.begin() == *insideB.begin();
}

}  // namespace

std::string withoutLinks(const std::string& path) {
  std::error_code ignored;
  const fs::path found = fs::weakly_canonical(path, ignored);
  return found.empty() ? path : found.string();
}

std::string assetFile(const Asset& asset, const std::string& folder) {
  const fs::path named(asset.path);
  if (named.is_absolute()) return named.string();
  const fs::path inside = named.lexically_normal();
  if (!inside.empty() && *inside.begin() == "..") return (fs::path(withoutLinks(folder)) / named).string();
  return (fs::path(folder) / named).lexically_normal().string();
}

std::string assetPathFrom(const std::string& folder, const std::string& file) {
  const fs::path from = withoutLinks(folder);
  const fs::path named = withoutLinks(file);
  return shareMoreThanTheRoot(named, from) ? named.lexically_relative(from).generic_string() : named.generic_string();
}

}  // namespace glissade
