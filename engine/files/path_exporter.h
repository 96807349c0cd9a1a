#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/base/message.h"
#include "engine/files/scenario.h"
#include "engine/planning/path.h"

namespace glissade {

/// A format for writing paths. Registered by explicit calls.
struct PathExporter {
  std::string id;
  std::vector<std::string> endings;  ///< file endings, lower case, without dot; the default first
  CatalogueText label;               ///< name for people
  bool needsScenario = true;         ///< false: `scenario` may be empty
  /// Largest error of a coordinate that readPath reads back; nothing where readPath does not read the format.
  std::optional<double> readBackError;
  /// Makes the whole content of a file. Precondition: the path has a configuration. The same input gives the same
  /// bytes.
  std::function<Result<std::string>(const Path&, const LoadedScenario&, const PathProvenance&)> content;

  /// Saves a path atomically. Errors name the file: a path without any configuration, one that the format cannot hold,
  /// or a file that cannot be written. An existing file is unchanged after an error.
  SaveResult write(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                   const std::string& file) const;
};

class PathExporterRegistry {
 public:
  void add(PathExporter exporter) { entries_.push_back(std::move(exporter)); }
  /// The exporter of an id; null where it is unknown.
  const PathExporter* find(std::string_view id) const;
  const std::vector<PathExporter>& entries() const { return entries_; }
  /// The exporter for a file's ending, in lower or upper case. An unknown ending is an error of usage that lists the
  /// known endings.
  Result<PathExporter> forFile(const std::string& file) const;
  /// The formats for help and errors, for example "Table (.csv), OMPL columns (.path)".
  Message formats() const;
  /// The formats that readPath reads.
  Message readableFormats() const;

 private:
  std::vector<PathExporter> entries_;
};

/// The formats csv, json, ompl, glb.
PathExporterRegistry makePathExporterRegistry();

/// The product's exporter for a file: PathExporterRegistry::forFile().
Result<PathExporter> pathExporterFor(const std::string& file);

/// Saves a path in the format of the file's ending.
SaveResult writePath(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                     const std::string& file);

/// The product's formats for help and errors.
Message writablePathFormats();
Message readablePathFormats();

}  // namespace glissade
