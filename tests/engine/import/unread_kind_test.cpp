#include "engine/import/unread_kind.h"

#include <gtest/gtest.h>

#include <utility>

namespace glissade {
namespace {

TEST(UnreadKind, IsNamedWithWhatToExport) {
  for (const auto& [file, kind] : {std::pair("a.SLDASM", "a SolidWorks file"),
                                   {"a.jt", "a JT file"},
                                   {"a.x_t", "a Parasolid file"},
                                   {"a.FCStd", "a FreeCAD file"},
                                   {"bolt.prt.3", "a part or an assembly of NX, Creo or Solid Edge"}}) {
    const auto found = unreadKind(file);
    ASSERT_TRUE(found) << file;
    EXPECT_EQ(toString(found->reason), std::string("is ") + kind + ", which is not read");
    EXPECT_EQ(toString(found->advice), "Export it as STEP (AP214 or AP242) in the program that it is from.");
  }
  EXPECT_EQ(toString(unreadKind("a.3mf")->advice),
            "Export it as STL, OBJ, PLY or glTF in the program that it is from.");
  EXPECT_EQ(toString(unreadKind("a.step.gz")->advice), "Unpack it, and give the file that is in it.");
}

TEST(UnreadKind, OtherEndingsAreNone) {
  for (const char* file : {"scenario.json", "a", "a.", ".prt/a.json", "a.3", "a.step", "a.cfg"}) {
    EXPECT_FALSE(unreadKind(file)) << file;
  }
}

}  // namespace
}  // namespace glissade
