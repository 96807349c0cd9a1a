#include "engine/model/node_names.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(NodeNames, NumbersKeysAndTheNameOfTheProductNameNoOccurrence) {
  // Names as CATIA, Creo, Inventor, NX, Onshape, OpenCASCADE, SolidWorks and others write them.
  for (const char* name : {"",
                           " ",
                           "1",
                           "0042",
                           "=>[0:1:1:2]",
                           "NAUO1",
                           "nauo 17",
                           "NEXT_ASSEMBLY_USAGE_OCCURRENCE",
                           "Next assembly relationship",
                           "*DIT57",
                           "bolt",
                           "BOLT",
                           " bolt ",
                           "bolt_1",
                           "bolt:1",
                           "BOLT::2",
                           "bolt-12",
                           "bolt.3",
                           "bolt (4)",
                           "bolt<5>",
                           "bolt#6",
                           "{3f2504e0-4f89-11d3-9a0c-0305e82c3301}",
                           "3f2504e0-4f89-11d3-9a0c-0305e82c3301"}) {
    EXPECT_FALSE(namesTheOccurrence(name, "bolt")) << name;
  }
}

TEST(NodeNames, WhatPeopleWriteNamesTheOccurrence) {
  for (const char* name : {"C1", "bolt1", "left bolt", "bolt left", "bolt_1 left", "boltx", "M8",
                           "\xE8\x9E\xBA\xE9\x92\x89", "NAUO-lid", "front/left"}) {
    EXPECT_TRUE(namesTheOccurrence(name, "bolt")) << name;
  }
  EXPECT_TRUE(namesTheOccurrence("bolt", "")) << "of a product without a name";
}

TEST(NodeNames, TheOccurrenceComesBeforeTheDesignatorAndTheProduct) {
  EXPECT_EQ(shownName({"C_0603", "decoupling", "C4"}), "decoupling");
  EXPECT_EQ(shownName({"C_0603", "NAUO4", "C4"}), "C4");
  EXPECT_EQ(shownName({"C_0603", "C_0603:4", "C_0603:4"}), "C_0603");
  EXPECT_EQ(shownName({"", "", ""}), "");
  EXPECT_EQ(shownName({"C_0603#2", "C_0603:2", "C_0603:2"}), "C_0603#2") << "as a scenario keeps the second one";
}

}  // namespace
}  // namespace glissade
