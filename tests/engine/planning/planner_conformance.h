#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "engine/planning/planner.h"

namespace glissade {

/// An entry of a registry that planner_conformance_test.cpp holds to the contract.
struct PlannerUnderTest {
  PlannerRegistry (*registry)();
  std::string registryName;
  std::string id;
  int slots = 1;
  bool isDeterministic = false;  ///< draws no random numbers

  friend std::ostream& operator<<(std::ostream& stream, const PlannerUnderTest& entry) {
    return stream << entry.registryName << ' ' << entry.id << ' ' << entry.slots;
  }
};

/// The entries to test. Every test program with the suite defines this function.
std::vector<PlannerUnderTest> plannersUnderTest();

}  // namespace glissade
