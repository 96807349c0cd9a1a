#pragma once

#include <memory>
#include <string>

#include "engine/sequence/fits_store.h"

namespace glissade {

/// The fits of products in a folder of the user's cache, one file for each product and limits. A file's name is the
/// hash of all that the fits depend on: the bodies with their meshes, names and poses, the person's statements, the
/// limits, the version of the program and its compiler. A damaged file is not read. The files that were used least
/// recently are removed when the folder has more than `mostBytes`.
class FitsCache : public FitsStore {
 public:
  static constexpr std::size_t kMostBytes = 512U << 20U;

  FitsCache(std::string folder, std::string version, std::size_t mostBytes = kMostBytes);

  std::string keyOf(const AssembledProduct& product, const ContactLimits& limits) const override;
  std::optional<std::vector<ObjectFits>> find(const std::string& key) const override;
  void keep(const std::string& key, const std::vector<ObjectFits>& objects) override;

 private:
  std::string fileOf(const std::string& key) const;

  std::string folder_;
  std::string version_;
  std::size_t mostBytes_;
};

/// The cache in $XDG_CACHE_HOME/glissade/fits, else in ~/.cache/glissade/fits. Null where neither folder is known, and
/// for a program that is built from changed sources ("-dirty" in `version`), whose version says nothing about its
/// results. `version`: versionText().
std::unique_ptr<FitsStore> usersFitsCache(const std::string& version);

}  // namespace glissade
