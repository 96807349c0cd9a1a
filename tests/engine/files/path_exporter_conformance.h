#pragma once

#include <string>
#include <vector>

#include "engine/files/path_exporter.h"

namespace glissade {

/// A registry, and the ids of its exporters that path_exporter_conformance_test.cpp holds to the contract.
struct PathExportersUnderTest {
  PathExporterRegistry registry;
  std::vector<std::string> ids;
};

/// The exporters to test. Every test program with the suite defines this function.
PathExportersUnderTest pathExportersUnderTest();

}  // namespace glissade
