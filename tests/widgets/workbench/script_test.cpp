#include "widgets/workbench/script.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

ScriptCommands commands() {
  ScriptCommands commands;
  const auto nothing = [](const ScriptCommands::Words&) -> Outcome { return Done{}; };
  commands.add("action", 1, nothing);
  commands.add("wait", 2, nothing);
  commands.add("select", 2, nothing);
  return commands;
}

TEST(Script, ReadsCommandsAndSkipsCommentsAndEmptyLines) {
  const auto script =
      parseScript("# a comment\n\n  action run.start  # go\nwait solved 100\nquit\n", "a.script", commands());
  ASSERT_TRUE(script);
  ASSERT_EQ(script->size(), 3U);
  EXPECT_EQ((*script)[0].name, "action");
  EXPECT_EQ((*script)[0].words, (std::vector<std::string>{"run.start"}));
  EXPECT_EQ((*script)[1].line, 4);
}

TEST(Script, PartsOfOneNameAreNoComments) {
  const auto script = parseScript("select body pin#2 #and a comment\n#quit\n", "a.script", commands());
  ASSERT_TRUE(script);
  ASSERT_EQ(script->size(), 1U);
  EXPECT_EQ((*script)[0].words, (std::vector<std::string>{"body", "pin#2"}));
}

TEST(Script, ErrorsNameFileAndLine) {
  for (const char* bad : {"action run.start\nexplode\n", "action run.start\nwait solved\n"}) {
    const auto script = parseScript(bad, "a.script", commands());
    ASSERT_FALSE(script);
    EXPECT_EQ(script.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(script.error().file, "a.script");
    EXPECT_EQ(toString(script.error().location), "line 2");
  }
}

}  // namespace
}  // namespace glissade
