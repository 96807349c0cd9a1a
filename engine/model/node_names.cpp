#include "engine/model/node_names.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "engine/model/body_path.h"

namespace glissade {
namespace {

bool isNumeral(char c) { return c >= '0' && c <= '9'; }

/// Bytes of characters beyond ASCII count as letters, for letters of any script.
bool isLetterOfAnyScript(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalpha(byte) != 0;
}

std::string lowerCased(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// True for digits between marks, as exporters number their instances: "_1", ":2", "-3", ".4", " (5)", "<6>", "#7".
bool isNumber(std::string_view text) {
  constexpr std::string_view kMarks = " _:.-#()<>[]";
  const bool isPlain = std::all_of(text.begin(), text.end(),
                                   [&](char c) { return isNumeral(c) || kMarks.find(c) != std::string_view::npos; });
  return isPlain && std::any_of(text.begin(), text.end(), isNumeral);
}

/// True for eight, four, four, four and twelve hexadecimal digits.
bool isUuid(std::string_view text) {
  if (text.size() == 38 && text.front() == '{') text = text.substr(1, 36);
  if (text.size() != 36) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isMark = i == 8 || i == 13 || i == 18 || i == 23;
    if (isMark ? text[i] != '-' : std::isxdigit(static_cast<unsigned char>(text[i])) == 0) return false;
  }
  return true;
}

/// True for keys that exporters write in place of a missing name. `name`: in lower case.
bool isKey(std::string_view name) {
  for (const std::string_view word : {"nauo", "next_assembly_usage_occurrence", "next assembly usage occurrence",
                                      "next assembly relationship", "next assembly usage"}) {
    if (name.substr(0, word.size()) != word) continue;
    const std::string_view rest = name.substr(word.size());
    if (rest.empty() || isNumber(rest)) return true;
  }
  return name.front() == '*' || name == "none" || name == "null" || name == "unknown" || isUuid(name);
}

}  // namespace

bool namesTheOccurrence(const std::string& name, const std::string& product) {
  if (std::none_of(name.begin(), name.end(), isLetterOfAnyScript)) return false;
  const std::string own = lowerCased(trimmed(name));
  const std::string usual = lowerCased(trimmed(withoutNumber(product)));
  if (isKey(own)) return false;
  if (usual.empty() || own.compare(0, usual.size(), usual) != 0) return true;
  const std::string_view rest = std::string_view(own).substr(usual.size());
  return !rest.empty() && (isNumeral(rest.front()) || !isNumber(rest));
}

const std::string& shownName(const NodeNames& names) {
  if (namesTheOccurrence(names.occurrence, names.product)) return names.occurrence;
  if (namesTheOccurrence(names.designator, names.product)) return names.designator;
  return names.product;
}

std::vector<NodeNames> productNames(const std::vector<std::string>& products) {
  std::vector<NodeNames> names;
  for (const std::string& product : products) names.push_back({product});
  return names;
}

}  // namespace glissade
