#include "engine/import/xml_precheck.h"

#include <algorithm>

#include "engine/base/utf8.h"

namespace glissade {
namespace {

constexpr int kDeepest = 100;

Diagnostic malformed(const std::string& text, std::size_t position, const std::string& file,
                     const std::string& reason) {
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n');
  return {ErrorKind::MalformedInput, file, "line " + std::to_string(line), reason, "Correct the file."};
}

}  // namespace

Result<XmlFacts> precheckXml(const std::string& text, const std::string& file) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8LengthAt(text, at);
    if (length == 0 || text[at] == '\0') return malformed(text, at, file, "is not valid UTF-8 text");
    at += length;
  }
  XmlFacts facts;
  int depth = 0;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      if (at == std::string::npos) break;
      continue;
    }
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return malformed(text, at, file, "has a tag that does not end");
    const bool closing = text.compare(at, 2, "</") == 0;
    const bool alone = text[end - 1] == '/' || text[at + 1] == '?' || text[at + 1] == '!';
    if (closing) --depth;
    if (!closing && !alone && ++depth > kDeepest) return malformed(text, at, file, "is nested too deeply");
    if (text.compare(at, 9, "<geometry") == 0) ++facts.geometries;
  }
  return facts;
}

}  // namespace glissade
