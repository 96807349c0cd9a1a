#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/files/part_files.h"

namespace glissade {

/// Adds files and bodies to a scenario that is saved as `file`; empty: not saved yet.
class PartAdder {
 public:
  PartAdder(Scenario& scenario, const std::string& file);

  void addBody(const PartFile& part);
  /// Adds a part to the object. The caller chooses the reference point afterwards.
  void addToObject(const PartFile& part);

 private:
  BodyDescription bodyOf(const PartFile& part);
  Geometry geometryOf(const PartFile& part);
  std::string assetOf(const PartFile& part);
  void noteAssets();
  void noteNodes();
  void notePlace(const PartFile& part, const BodyDescription& body);
  std::string assemblyOf(const PartFile& part, const std::string& asset, std::size_t steps);
  void addNode(const NodeDescription& node);
  std::string freeAssemblyId(const std::string& id) const;

  Scenario& scenario_;
  std::string folder_;
  bool saved_;
  bool hasObject_ = false;
  std::set<std::string> assetIds_;
  std::multimap<std::string, std::size_t> assetsOfFiles_;  ///< indices of assets, by the file without links
  std::set<std::string> ids_;                              ///< ids of bodies, and of described nodes
  std::set<std::string> assemblyIds_;                      ///< ids of all assemblies
  /// Ids of assemblies by asset and path, because files may have assemblies of the same name.
  std::map<std::pair<std::string, std::string>, std::string> assemblies_;
};

}  // namespace glissade
