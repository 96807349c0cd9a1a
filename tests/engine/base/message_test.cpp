#include "engine/base/message.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "engine/base/diagnostic.h"
#include "engine/base/message_json.h"

namespace glissade {
namespace {

TEST(Message, PutsArgumentsWhereTheTextHasThem) {
  const Message message{GLISSADE_TEXT("%1 of %2"), {3, "%1"}};
  EXPECT_EQ(toString(message), "3 of %1") << "a placeholder in an argument is not replaced";
  EXPECT_EQ(toString(message, Language::French), "3 sur %1");
  EXPECT_EQ(toString(Message(CatalogueText{"%1 and %2"}, {"a"})), "a and %2") << "an argument is missing";
  EXPECT_EQ(toString(Message()), "");
  EXPECT_EQ(toString(Message(std::string("bolt.step"))), "bolt.step");
}

TEST(Message, ReadersChooseLanguageAndUnit) {
  const Message inner{GLISSADE_TEXT("cannot be read: %1"), {"EIO"}};
  const Message message{CatalogueText{"%1, %2, %3"}, {inner, Length{0.00125}, Depth{0.0012345}}};
  EXPECT_EQ(toString(message), "cannot be read: EIO, 1.25 mm, 1.235 mm");
  MessageStyle inches(Language::French);
  inches.length = [](double metres) { return std::to_string(static_cast<int>(metres / 25.4e-6)) + " thou"; };
  EXPECT_EQ(toString(message, inches), "ne peut pas être lu\u00a0: EIO, 49 thou, 1.235 mm")
      << "a depth that a person accepts is shown as it is stated";
}

TEST(Message, TextsThatTheCatalogueHasNotAreEnglish) {
  EXPECT_FALSE(hasFrench("said by nobody"));
  EXPECT_EQ(toString(Message(CatalogueText{"said by nobody"}), Language::French), "said by nobody");
}

TEST(Message, WordsAgreeWithTheirNumber) {
  const auto certified = [](std::size_t steps) {
    return Message{GLISSADE_TEXT("%1 of %2 {2|step|steps} {1|is|are} certified, %3"), {steps, 2, "2 mm"}};
  };
  EXPECT_EQ(toString(certified(0)), "0 of 2 steps are certified, 2 mm");
  EXPECT_EQ(toString(certified(1)), "1 of 2 steps is certified, 2 mm");
  EXPECT_EQ(toString(certified(0), Language::French), "0 étape sur 2 est certifiée, 2 mm");
  EXPECT_EQ(toString(certified(2), Language::French), "2 étapes sur 2 sont certifiées, 2 mm");
}

TEST(Message, BracesThatAreNoFormsStay) {
  for (const char* text : {"{", "{1", "{1|a", "{1|a}", "{0|a|b}", "{2|a|b}", "{x|a|b}", "}{1|}"}) {
    EXPECT_EQ(toString(Message(CatalogueText{text}, {7})), text);
  }
}

TEST(Message, SeveralBecomeOne) {
  EXPECT_TRUE(joined({}, "; ").empty());
  EXPECT_EQ(toString(joined({Message(std::string("a")), Message(std::string("b")), Message(std::string("c"))}, "; ")),
            "a; b; c");
}

/// A message of random texts, numbers and messages.
Message randomMessage(std::mt19937& random, int depth) {
  std::vector<MessageArgument> arguments;
  for (std::size_t left = random() % 4; left > 0; --left) {
    switch (random() % (depth > 0 ? 4 : 3)) {
      case 0: arguments.emplace_back("text " + std::to_string(random() % 100)); break;
      case 1: arguments.emplace_back(Length{1e-3 * static_cast<double>(random() % 1000)}); break;
      case 2: arguments.emplace_back(Depth{1e-6 * static_cast<double>(random() % 1000)}); break;
      default: arguments.emplace_back(randomMessage(random, depth - 1));
    }
  }
  return {CatalogueText{"is empty"}, std::move(arguments)};
}

TEST(MessageJson, KeepsMessages) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const Message message = randomMessage(random, 5);
    const auto read = messageFrom(nlohmann::json::parse(toJson(message).dump()));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, message);
  }
}

TEST(MessageJson, RefusesOtherForms) {
  for (const char* text : {"1", "[]", "{}", R"({"text": 1})", R"({"text": "a", "arguments": {}})",
                           R"({"text": "a", "arguments": [1]})", R"({"text": "a", "arguments": [{"length": "1"}]})"}) {
    EXPECT_FALSE(messageFrom(nlohmann::json::parse(text))) << text;
  }
  Message deep{std::string("a")};
  for (int i = 0; i < 20; ++i) deep = Message(CatalogueText{"%1"}, {deep});
  EXPECT_FALSE(messageFrom(toJson(deep)));
}

TEST(Diagnostic, IsWrittenInTheReadersLanguage) {
  const Diagnostic why{ErrorKind::MalformedInput,
                       "a.json",
                       {GLISSADE_TEXT("line %1"), {3}},
                       GLISSADE_TEXT("is empty"),
                       GLISSADE_TEXT("Correct the file.")};
  EXPECT_EQ(toString(why), "a.json: line 3: is empty. Correct the file.");
  EXPECT_EQ(toString(why, Language::French), "a.json\u00a0: ligne 3\u00a0: est vide. Corrigez le fichier.");
}

}  // namespace
}  // namespace glissade
