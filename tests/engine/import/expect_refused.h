#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/import/mesh_import.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade::test {

/// Expects that a mesh file with this name and content is refused as malformed, with its name, this reason and advice.
/// Returns the place in the file that the error names.
inline std::string placeOfRefusal(const std::string& name, const std::string& content, const std::string& reason) {
  const TemporaryFolder folder;
  const std::string file = folder.write(name, content);
  const Result<ImportedMesh> imported = importMesh(file);
  if (imported.ok()) {
    ADD_FAILURE() << "is read";
    return {};
  }
  EXPECT_EQ(imported.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(imported.error().file, file);
  EXPECT_NE(reason, "");
  EXPECT_THAT(toString(imported.error().reason), testing::HasSubstr(reason));
  EXPECT_FALSE(imported.error().advice.empty());
  return toString(imported.error().location);
}

}  // namespace glissade::test
