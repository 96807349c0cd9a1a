#pragma once

#include <string>
#include <vector>

namespace glissade::reliability {

/// A well-formed file, and how `glissade-cli` is asked to read it.
struct GoodFile {
  std::string format;   ///< as the table names it
  std::string name;     ///< of the file, in the campaign's folder
  std::string content;  ///< malformed variants are made of it
  /// Arguments of glissade-cli; they name the file by what `name` says.
  std::vector<std::string> command;
  bool mesh = false;  ///< its triangles are counted
};

/// Writes what the files refer to (scenarios) into the folder. `cli` makes the paths and the run record, STEP
/// files come from the folder `stepFiles` (empty: none).
std::vector<GoodFile> makeGoodFiles(const std::string& folder, const std::string& cli, const std::string& stepFiles);

/// How many triangles a reader would count that takes a cut-off mesh file for what is there: facets begun in
/// text, facets claimed in binary.
std::size_t trianglesBegun(const GoodFile& file, const std::string& content);

}  // namespace glissade::reliability
