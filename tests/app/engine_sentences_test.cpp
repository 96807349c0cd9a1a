// Every text that the engine makes for people has a French translation.
#include <gtest/gtest.h>
#include <QApplication>
#include <QTranslator>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/engine/support/directories.h"
#include "widgets/commands/diagnostic_text.h"
#include "widgets/panels/engine_texts.h"

namespace glissade {
namespace {

enum class Kind { Text, Word, Mark };

struct Token {
  Kind kind;
  std::string text;  ///< literal: without quotes and escapes; mark: one character, "<<" or "->"
};

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':' || c == '.'; }

std::string withoutEscapes(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      result += text[i];
    } else if (++i < text.size()) {
      result += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i];
    }
  }
  return result;
}

/// The position after the quote that ends the literal which begins at `at`.
std::size_t endOfLiteral(const std::string& source, std::size_t at) {
  const char quote = source[at++];
  while (at < source.size() && source[at] != quote) at += source[at] == '\\' ? 2 : 1;
  return at + 1;
}

std::size_t lineEnd(const std::string& source, std::size_t at) {
  return std::min(source.find('\n', at), source.size());
}

std::vector<Token> tokensOf(const std::string& source) {
  std::vector<Token> tokens;
  bool lineBegins = true;
  for (std::size_t i = 0; i < source.size();) {
    const char c = source[i];
    const bool directive = lineBegins && c == '#';
    if (c == '\n') lineBegins = true;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++i;
      continue;
    }
    lineBegins = false;
    if (directive || source.compare(i, 2, "//") == 0) {
      i = lineEnd(source, i);
    } else if (source.compare(i, 3, "R\"(") == 0) {
      i = source.find(")\"", i) + 2;
      tokens.push_back({Kind::Word, "raw"});
    } else if (c == '"' || c == '\'') {
      const std::size_t end = endOfLiteral(source, i);
      if (c == '"') tokens.push_back({Kind::Text, withoutEscapes(source.substr(i + 1, end - i - 2))});
      if (c != '"') tokens.push_back({Kind::Word, "character"});
      i = end;
    } else if (isWord(c) && c != ':' && c != '.') {
      const std::size_t from = i;
      // A ' inside a number separates digits.
      while (i < source.size() &&
             (isWord(source[i]) || (source[i] == '\'' && std::isdigit(static_cast<unsigned char>(c)) != 0)))
        ++i;
      tokens.push_back({Kind::Word, source.substr(from, i - from)});
    } else {
      const bool two = source.compare(i, 2, "<<") == 0 || source.compare(i, 2, "->") == 0;
      tokens.push_back({Kind::Mark, source.substr(i, two ? 2 : 1)});
      i += two ? 2 : 1;
    }
  }

  return tokens;
}

/// The state of an expression that is being read.
struct Expression {
  std::string text;

  int places = 0;

  bool hasText = false;

  bool endsInPlace = false;

  bool isOneText = false;  ///< a single literal and nothing else

  bool streams = false;

  bool ofString = false;  ///< the expression is the argument of std::string

  void addText(const std::string& literal) {
    isOneText = text.empty() && !endsInPlace;
    text += literal;
    hasText = true;
    endsInPlace = false;
  }

  void addPlace() {
    isOneText = false;
    if (!endsInPlace) text += "%" + std::to_string(++places);
    endsInPlace = true;
  }

  /// Reads "<<". An expression without text before the first << is the stream, and is dropped.
  void stream() {
    if (!streams && !hasText) *this = {};
    streams = true;
    isOneText = false;
  }
};

bool isOf(const Token& token, const std::string& marks) {
  return token.kind == Kind::Mark && token.text.size() == 1 && marks.find(token.text) != std::string::npos;
}

class Reader {
 public:
  explicit Reader(const std::string& source) : tokens_(tokensOf(source)) {}

  std::vector<std::string> texts() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) read(tokens_[at_]);
    while (!open_.empty()) finish();
    return std::move(texts_);
  }

 private:
  void read(const Token& token) {
    if (token.kind == Kind::Text) return current().addText(token.text);
    if (isOf(token, "([{")) return open();
    if (isOf(token, ")]}")) return close(token.text == "}");
    if (token.text == "<<") return current().stream();
    if (isOf(token, ",;?:=|&!") || isComparison(token)) return end();
    if (token.kind == Kind::Word && (token.text == "return" || token.text == "throw" || token.text == "else"))
      return end();
    if (token.text == "->" || isOf(token, "+<>")) return;
    if (!isString(at_)) current().addPlace();
  }

  /// Whether the tokens construct a std::string.
  bool isString(std::size_t at) const {
    return at + 1 < tokens_.size() && tokens_[at].text == "std::string" && tokens_[at + 1].text == "(";
  }

  void open() {
    const bool ofString = at_ > 0 && isString(at_ - 1);
    open_.push_back({});
    current().ofString = ofString;
  }

  /// Angle brackets of a cast or a template follow a word; those of a comparison do not.
  bool isComparison(const Token& token) const {
    return isOf(token, "<>") && at_ > 0 && at_ + 1 < tokens_.size() && tokens_[at_ - 1].kind == Kind::Mark;
  }

  void close(bool block) {
    if (open_.size() < 2) return end();
    const Expression inner = open_.back();
    if (inner.ofString && inner.isOneText) {
      open_.pop_back();
      return current().addText(inner.text);
    }
    finish();
    if (block) return end();
    current().addPlace();
  }

  void end() {
    finish();
    open_.push_back({});
  }

  void finish() {
    if (open_.back().hasText) texts_.push_back(open_.back().text);
    open_.pop_back();
  }

  Expression& current() { return open_.back(); }

  std::vector<Token> tokens_;

  std::size_t at_ = 0;

  std::vector<Expression> open_{1};

  std::vector<std::string> texts_;
};

/// The texts that the expressions of a C++ source make of string literals: `"line " + std::to_string(n) + ": " + why`
/// is "line %1: %2". Streams (`<<`) count as `+`. Raw literals and those with an encoding are left out.
std::vector<std::string> textsMadeIn(const std::string& source) { return Reader(source).texts(); }

namespace fs = std::filesystem;

/// Files whose texts are not translated by the window's tables. Reports and plots of studies are translated by
/// study_french.cpp, instructions by instruction_french.cpp; benchmarks are for developers. The command line prints the
/// verdicts of the judge; the window shows only whether a path or a step is valid, and the conditions
/// (kShownOfTheJudge). The window has its own texts for the rows of work times (work_time_texts.cpp).
constexpr const char* kOtherwiseTranslated[] = {"engine/check/",
                                                "engine/study/study_french.cpp",
                                                "engine/study/instruction/instruction_french.cpp",
                                                "engine/study/instruction/instruction_html.cpp",
                                                "engine/study/instruction/instruction_script.cpp",
                                                "engine/study/report_html.cpp",
                                                "engine/study/svg_plot.cpp",
                                                "engine/study/plan_graph.cpp",
                                                "engine/study/line_chart.cpp",
                                                "engine/study/xml_text.cpp",
                                                "engine/study/benchmarks/",
                                                "engine/sequence/work_times.cpp",
                                                "engine/sequence/line_balance.cpp",
                                                "engine/product/designation."};

constexpr const char* kShownOfTheJudge = "engine/check/condition.cpp";

/// Texts that the window does not show to people: names of random streams, keys of caches, rules and commands as they
/// are typed, statements of files about their writer, and texts of the command line.
constexpr const char* kNotForTheWindow[] = {
    "of %1",
    "held by ",
    "next assembly usage occurrence",  // keys and beginnings of files
    "next assembly relationship",
    "next assembly usage",
    "Shift JIS",
    "Open CASCADE Topology",
    "CASCADE Topology V",
    "%1\t%2\t%3\tIGES %4\t%5",
    "as one",
    "as %1",
    "simulated operator",
    "task operator",
    "shown configuration",
    "Shows a way at the level of a task.",  // shown by studies on the command line only
    "random shooter",
    "goal bias",
    "%1 life %2",
    "contact slide",
    "gap %1",
    "level %1",
    "round %1",
    "milestone of %1",
    "contact follower",
    "gap bridges",
    "contact sampler",
    "milestones, attempt %1",
    "step %1, attempt %2",
    "whole workspace",
    "ompl seed",
    "preferred places",
    "0.1 * size * (max(a.complexity, b.complexity) - 1)",
    "place.cluttered or place.complexity > 2",
    "if((a.shape != \"\" and a.shape != object.shape) or (b.shape != \"\" and b.shape != object.shape), 10 * size, %1)",
    "if(min(a.compatibility, b.compatibility) < 0.5, 10 * size, %1)",
    "in the tapped hole of ",
    "in the hole of ",
    "on the thread of ",
    "on the shaft of ",
    "%1 taken %2 thinner%3 (%4)",
    "pitch %1",
    "%1 (ISO coarse, %2)",
    "2 * size * (1 - min(a.compatibility, b.compatibility)) + 0.5 * %1",
    "if(fragile, 0, 5) + length + direction_change + tool_change",
    "step %1",
    "box %1 %2 %3",
    "cylinder %1 %2",
    "sphere %1",
    "Glissade %1",
    "STL is little-endian",
    "Swept volume, millimetres, by Glissade",
    ("Seconds of manual work and the limits between its cases. The defaults are estimates of the size of the tables "
     "for "
     "manual assembly in Boothroyd, Dewhurst and Knight, Product Design for Manufacture and Assembly (2011)."),
    "the solved",
    "%1 of %1 over %2 runs",
    "model name",
    "Clang %1",
    "GCC %1",
    "%1 GB of memory",
    "%1, FCL %2, %3",
    "--out out/%1",
    "glissade-cli study %1 --jobs 2",
    "glissade-offscreen --study-pictures out/%1",
    "glissade-cli report out/%1"};

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Whether the text has at least two words; keys, names and formats have one.
bool isSentence(const std::string& text) {
  static const std::regex words("[A-Za-z]{2,}[,:]? [A-Za-z%'(0-9]|^[A-Z][a-z]+ [a-z]");
  return std::regex_search(text, words);
}

/// The text without the characters that join it to the text before.
std::string alone(const std::string& text) {
  static const std::regex joint("^[;.,]? +");
  return std::regex_replace(text, joint, "");
}

class EngineSentences : public testing::Test {
 protected:
  EngineSentences() {
    EXPECT_TRUE(
        french_.load(QString::fromStdString(test::programDirectory()) + QStringLiteral("/../app/glissade_fr.qm")));
    QApplication::installTranslator(&french_);
    for (const char* text : kEngineTexts) otherwise_.insert(text);
    for (const char* text : kNotForTheWindow) otherwise_.insert(text);
    for (const char* file : {"engine/study/study_french.cpp", "engine/study/instruction/instruction_french.cpp"}) {
      const std::string studies = contentOf(fs::path(test::sourceDirectory()) / file);
      for (const std::string& text : textsMadeIn(studies)) otherwise_.insert(alone(text));
    }
  }
  ~EngineSentences() override { QApplication::removeTranslator(&french_); }

  bool isTranslated(const std::string& text) const {
    return otherwise_.count(text) == 1 || engineText(text) != QString::fromStdString(text);
  }

 private:
  QTranslator french_;
  std::set<std::string> otherwise_;
};

TEST_F(EngineSentences, AreAllInFrench) {
  const fs::path root = test::sourceDirectory();
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root / "engine")) {
    const std::string name = fs::relative(entry.path(), root).generic_string();
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    if (name != kShownOfTheJudge && std::any_of(std::begin(kOtherwiseTranslated), std::end(kOtherwiseTranslated),
                                                [&](const char* other) { return name.rfind(other, 0) == 0; })) {
      continue;
    }
    for (const std::string& made : textsMadeIn(contentOf(entry.path()))) {
      const std::string text = alone(made);
      if (!isSentence(text)) continue;
      ++found;
      EXPECT_TRUE(isTranslated(text)) << name << ": \"" << text
                                      << "\" is in no list of widgets/commands/*_sentences.h, "
                                      << "or not in resources/i18n/glissade_fr.ts";
    }
  }
  EXPECT_GT(found, 600U) << "the sources are read as if they had few sentences";
}

TEST_F(EngineSentences, AreTranslatedWithWhatTheyAreJoinedOf) {
  EXPECT_EQ(engineText("the object penetrates 'is empty'"), QStringLiteral("l'objet pénètre dans « is empty »"));
  EXPECT_EQ(engineText("cannot be read: line 3: '4' is not a value"),
            QStringLiteral("ne peut pas être lu : ligne 3 : « 4 » n'est pas une valeur"));
  EXPECT_EQ(engineText("complexity 2, so rrt; blocked, so contact-birrt; place P3 was not crossed"),
            QStringLiteral("complexité 2, donc rrt ; bloqué, donc contact-birrt ; le lieu P3 n'a pas été traversé"));
  EXPECT_EQ(engineText("said by nobody"), QStringLiteral("said by nobody"));
}

TEST(SourceSentences, AreReadFromExpressions) {
  using Strings = std::vector<std::string>;
  EXPECT_EQ(textsMadeIn(R"(fail("is '" + name + "' of " + std::to_string(n + 1), "Give " "one.");)"),
            (Strings{"is '%1' of %2", "Give one."}));
  EXPECT_EQ(textsMadeIn(R"(text << "a " << x->y << " m"; // "not this"
    return std::string("b ") + (big ? "more" : "less");)"),
            (Strings{"a %1 m", "more", "less", "b %1"}));
}

}  // namespace
}  // namespace glissade
