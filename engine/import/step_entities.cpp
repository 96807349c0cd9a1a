#include "engine/import/step_entities.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace glissade {
namespace {

bool isBlankOfStep(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool isOfType(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '!'; }

/// End of a string or a comment that begins at `at`; `at` if none begins there.
std::size_t behindQuoted(std::string_view text, std::size_t at) {
  std::size_t end = at;
  if (text[at] == '\'' || text[at] == '"') end = text.find(text[at], at + 1);
  if (text.compare(at, 2, "/*") == 0) {
    end = text.find("*/", at + 2);
    if (end != std::string_view::npos) ++end;
  }
  if (end == at) return at;
  return end == std::string_view::npos ? text.size() : end + 1;
}

/// Skips blanks and comments.
std::size_t nextToken(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (isBlankOfStep(text[at])) {
      ++at;
    } else if (text.compare(at, 2, "/*") == 0) {
      at = behindQuoted(text, at);
    } else {
      break;
    }
  }
  return at;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(nextToken(text, 0));
  while (!text.empty() && isBlankOfStep(text.back())) text.remove_suffix(1);
  return text;
}

/// The first `wanted` outside of strings, comments and parentheses; the end if there is none. Parentheses are ignored
/// for the end of an entity.
std::size_t findOutside(std::string_view text, std::size_t from, char wanted) {
  int depth = 0;
  for (std::size_t at = from; at < text.size();) {
    if (const std::size_t behind = behindQuoted(text, at); behind != at) {
      at = behind;
      continue;
    }
    const char c = text[at];
    if (c == wanted && (depth == 0 || wanted == ';')) return at;
    if (c == '(') ++depth;
    if (c == ')') --depth;
    ++at;
  }
  return text.size();
}

std::uint64_t numberIn(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

std::size_t endOfDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) ++at;
  return at;
}

}  // namespace

StepEntities::StepEntities(std::string_view text) : text_(text) {
  const std::size_t data = text.find("DATA");
  for (std::size_t at = std::min(data, text.size()); at < text.size();) {
    at = nextToken(text, at);
    const std::size_t end = std::min(text.find(';', at), text.size());
    if (at < text.size() && text[at] == '#') {
      const std::size_t digits = endOfDigits(text, at + 1);
      const std::size_t equals = nextToken(text, digits);
      const std::uint64_t id = numberIn(text.substr(at + 1, digits - at - 1));
      if (id != 0 && equals < text.size() && text[equals] == '=') {
        const std::size_t last = findOutside(text, equals, ';');
        entities_.push_back({id, at, std::min(last + 1, text.size())});
        at = last + 1;
        continue;
      }
    }
    if (text.compare(at, 6, "ENDSEC") == 0) endOfData_ = at;
    at = end + 1;
  }
  std::stable_sort(entities_.begin(), entities_.end(), [](const Entity& a, const Entity& b) { return a.id < b.id; });
}

const StepEntities::Entity* StepEntities::find(std::uint64_t id) const {
  const auto found = std::lower_bound(entities_.begin(), entities_.end(), id,
                                      [](const Entity& entity, std::uint64_t wanted) { return entity.id < wanted; });
  return found != entities_.end() && found->id == id ? &*found : nullptr;
}

std::string_view StepEntities::typeOf(const Entity& entity) const {
  const std::string_view text = text_.substr(entity.begin, entity.end - entity.begin);
  const std::size_t begin = nextToken(text, text.find('=') + 1);
  std::size_t end = begin;
  while (end < text.size() && isOfType(text[end])) ++end;
  return text.substr(begin, end - begin);
}

std::vector<StepRecord> StepEntities::recordsOf(std::uint64_t id) const {
  const Entity* entity = find(id);
  return entity == nullptr ? std::vector<StepRecord>() : recordsOf(*entity);
}

std::vector<StepRecord> StepEntities::recordsOf(const Entity& entity) const {
  std::string_view text = text_.substr(entity.begin, entity.end - entity.begin);
  if (!text.empty() && text.back() == ';') text.remove_suffix(1);
  std::size_t at = nextToken(text, text.find('=') + 1);
  const bool isComplex = at < text.size() && text[at] == '(';
  if (isComplex) ++at;
  std::vector<StepRecord> records;
  while ((at = nextToken(text, at)) < text.size() && text[at] != ')') {
    const std::size_t begin = at;
    while (at < text.size() && isOfType(text[at])) ++at;
    const std::string_view type = text.substr(begin, at - begin);
    const std::size_t open = nextToken(text, at);
    if (type.empty() || open >= text.size() || text[open] != '(') break;
    const std::size_t close = findOutside(text, open + 1, ')');
    records.push_back({type, text.substr(open + 1, close - open - 1)});
    at = close + 1;
    if (!isComplex) break;
  }
  return records;
}

std::vector<std::string_view> stepValues(std::string_view arguments) {
  std::vector<std::string_view> values;
  if (trimmed(arguments).empty()) return values;
  for (std::size_t at = 0; at <= arguments.size();) {
    const std::size_t comma = findOutside(arguments, at, ',');
    values.push_back(trimmed(arguments.substr(at, comma - at)));
    at = comma + 1;
  }
  return values;
}

std::vector<std::string_view> stepList(std::string_view value) {
  value = trimmed(value);
  if (value.size() < 2 || value.front() != '(' || value.back() != ')') return {};
  return stepValues(value.substr(1, value.size() - 2));
}

std::uint64_t stepReference(std::string_view value) {
  value = trimmed(value);
  return value.size() < 2 || value.front() != '#' ? 0 : numberIn(value.substr(1));
}

std::vector<std::uint64_t> stepReferencesIn(std::string_view text) {
  std::vector<std::uint64_t> found;
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t behind = behindQuoted(text, at); behind != at) {
      at = behind;
    } else if (text[at] == '#') {
      const std::size_t end = endOfDigits(text, at + 1);
      if (const std::uint64_t id = numberIn(text.substr(at + 1, end - at - 1))) found.push_back(id);
      at = end;
    } else {
      ++at;
    }
  }
  return found;
}

}  // namespace glissade
