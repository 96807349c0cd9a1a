#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/scenario/part_files.h"

namespace glissade {

/// Adds files and bodies to a scenario that is saved as `file`, or nowhere yet.
class PartAdder {
 public:
  PartAdder(Scenario& scenario, const std::string& file);

  void addBody(const PartFile& part);
  /// To what moves. The reference point is still to be chosen.
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
  std::multimap<std::string, std::size_t> assetsOfFiles_;  ///< by the file without links
  std::set<std::string> ids_;                              ///< of bodies, and of nodes of which something is said
  std::set<std::string> assemblyIds_;                      ///< of all assemblies
  /// The same, by asset and path: files may have assemblies of one name.
  std::map<std::pair<std::string, std::string>, std::string> assemblies_;
};

}  // namespace glissade
