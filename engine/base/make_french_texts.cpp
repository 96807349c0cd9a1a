// Makes the table of French texts of the engine from the file of translations: make_french_texts IN.ts OUT.cpp.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace {

/// The content of the next element, with the position after it. Empty position: there is none.
struct Element {
  std::string content;
  std::size_t end = std::string::npos;
};

std::string withoutEntities(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> kEntities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&#xa0;", "\u00a0"}, {"&amp;", "&"}};
  for (const auto& [entity, character] : kEntities) {
    for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1)) {
      text.replace(at, entity.size(), character);
    }
  }
  return text;
}

Element elementFrom(const std::string& ts, const std::string& name, std::size_t from) {
  const std::string begin = "<" + name + ">";
  const std::string end = "</" + name + ">";
  const std::size_t first = ts.find(begin, from);
  if (first == std::string::npos) return {};
  const std::size_t last = ts.find(end, first);
  if (last == std::string::npos) return {};
  return {withoutEntities(ts.substr(first + begin.size(), last - first - begin.size())), last + end.size()};
}

/// English and French texts of the context "Messages". Unfinished ones are left out.
std::map<std::string, std::string> textsOf(const std::string& ts) {
  std::map<std::string, std::string> texts;
  const std::size_t context = ts.find("<name>Messages</name>");
  const std::size_t end = ts.find("</context>", context);
  for (std::size_t at = ts.find("<message>", context); at < end; at = ts.find("<message>", at + 1)) {
    const Element english = elementFrom(ts, "source", at);
    const Element french = english.end == std::string::npos ? Element() : elementFrom(ts, "translation", english.end);
    if (french.end < ts.find("</message>", at)) texts.emplace(english.content, french.content);
  }
  return texts;
}

std::string literal(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') {
      quoted += "\\n";
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  std::ifstream in(argv[1]);
  const std::string ts{std::istreambuf_iterator<char>(in), {}};
  std::ofstream out(argv[2]);
  out << "// Made by make_french_texts.\n#include \"engine/base/french_texts.h\"\n\n"
      << "namespace glissade {\n\nstd::span<const FrenchText> frenchTexts() {\n  static constexpr FrenchText kTexts[] "
         "= {\n";
  for (const auto& [english, french] : textsOf(ts))
    out << "      {" << literal(english) << ", " << literal(french) << "},\n";
  out << "  };\n  return kTexts;\n}\n\n}  // namespace glissade\n";
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
