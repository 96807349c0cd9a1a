#include "engine/base/csv_table.h"

#include <array>
#include <charconv>
#include <cmath>

namespace glissade {

void CsvTable::header(std::initializer_list<std::string> names) {
  for (const std::string& name : names) text(name);
}

void CsvTable::row() {
  content_ += '\n';
  atLineStart_ = true;
}

void CsvTable::separate() {
  if (!atLineStart_) content_ += ',';
  atLineStart_ = false;
}

void CsvTable::text(const std::string& value) {
  separate();
  if (value.find_first_of(",\"\r\n") == std::string::npos) {
    content_ += value;
    return;
  }
  content_ += '"';
  for (const char c : value) {
    if (c == '"') content_ += '"';
    content_ += c;
  }
  content_ += '"';
}

void CsvTable::number(std::optional<double> value) {
  separate();
  if (!value || !std::isfinite(*value)) return;
  std::array<char, 400> buffer{};  // the largest double has 309 digits
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *value, std::chars_format::fixed);
  content_.append(buffer.data(), end.ptr);
}

}  // namespace glissade
