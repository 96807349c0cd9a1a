#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/planning/path.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// A format that paths are written in. Registered by explicit calls.
struct PathExporter {
  std::string id;
  std::vector<std::string> endings;  ///< of its files, lower case, without dot; the usual one first
  std::string label;                 ///< for people
  bool needsScenario = true;         ///< false: `scenario` may be an empty one
  /// By how much a coordinate that readPath takes back may differ; nothing where it takes none.
  std::optional<double> readBackError;
  /// The whole content of a file. The path has a configuration; the same input gives the same bytes.
  std::function<Result<std::string>(const Path&, const LoadedScenario&, const PathProvenance&)> content;

  /// Saves a path atomically. Errors name the file: a path without any configuration, one that the
  /// format cannot hold, or a file that cannot be written; what was in the file then stays there.
  SaveResult write(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                   const std::string& file) const;
};

class PathExporterRegistry {
 public:
  void add(PathExporter exporter) { entries_.push_back(std::move(exporter)); }
  /// Null where the id is unknown.
  const PathExporter* find(std::string_view id) const;
  const std::vector<PathExporter>& entries() const { return entries_; }

 private:
  std::vector<PathExporter> entries_;
};

/// csv, json, ompl, glb.
PathExporterRegistry makePathExporterRegistry();

/// The exporter that a file's ending stands for, in upper case, too. An unknown ending is an error of
/// usage that lists those that there are.
Result<PathExporter> pathExporterFor(const std::string& file);

/// Saves a path in the format of the file's ending.
SaveResult writePath(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                     const std::string& file);

/// For help and errors, as "Table (.csv), OMPL columns (.path)".
std::string writablePathFormats();
/// Those that readPath takes.
std::string readablePathFormats();

}  // namespace glissade
