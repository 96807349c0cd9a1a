#include "engine/files/default_colour.h"

#include <gtest/gtest.h>

#include <set>

namespace glissade {
namespace {

TEST(DefaultColour, BodiesOfOnePartHaveOneColour) {
  EXPECT_EQ(defaultColour("pump-1"), defaultColour("pump-27"));
  EXPECT_EQ(defaultColour("nut"), defaultColour("nut#2"));
  EXPECT_EQ(defaultColour("12"), defaultColour("12"));
}

TEST(DefaultColour, PartsDiffer) {
  std::set<Colour> colours;
  for (const char* name : {"plate", "nut", "bolt", "rod", "bracket", "frame", "pump", "cover"}) {
    colours.insert(defaultColour(name));
  }
  EXPECT_GE(colours.size(), 5U);
}

}  // namespace
}  // namespace glissade
