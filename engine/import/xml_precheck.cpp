#include "engine/import/xml_precheck.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/utf8.h"

namespace glissade {
namespace {

constexpr std::size_t kDeepestElement = 100;
constexpr std::size_t kMostElements = 200'000;
constexpr std::size_t kMostAttributes = 100;

struct XmlRefusal {
  std::size_t position;
  Message reason;
};

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool beginsName(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool continuesName(char c) { return beginsName(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == ':'; }

/// Scans the text once, from markup to markup. Throws XmlRefusal.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}

  XmlFacts scan() {
    checkCharacters();
    for (at_ = text_.find('<'); at_ != std::string_view::npos; at_ = text_.find('<', at_)) takeMarkup();
    if (!open_.empty()) {
      refuse(text_.size(), {GLISSADE_TEXT("ends inside the element '%1'"), {open_.back()}});
    }
    return facts_;
  }

 private:
  [[noreturn]] static void refuse(std::size_t position, const Message& reason) { throw XmlRefusal{position, reason}; }

  void checkCharacters() const {
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t length = utf8LengthAt(text_, at);
      if (length == 0 || text_[at] == '\0') refuse(at, GLISSADE_TEXT("is not valid UTF-8 text"));
      at += length;
    }
  }

  bool follows(std::string_view token) const { return text_.substr(at_, token.size()) == token; }

  void takeMarkup() {
    if (follows("<!--")) return skipBehind("-->", 4, GLISSADE_TEXT("a comment"));
    if (follows("<![CDATA[")) return skipBehind("]]>", 9, GLISSADE_TEXT("a CDATA section"));
    if (follows("<!")) refuse(at_, GLISSADE_TEXT("has a document type, which is not read"));
    if (follows("<?")) return takeInstruction();
    if (follows("</")) return takeEndTag();
    takeStartTag();
  }

  void skipBehind(std::string_view end, std::size_t opening, CatalogueText what) {
    const std::size_t found = text_.find(end, at_ + opening);
    if (found == std::string_view::npos) refuse(at_, {GLISSADE_TEXT("has %1 that does not end"), {what}});
    at_ = found + end.size();
  }

  /// TinyXML ends a processing instruction at its first '>'.
  void takeInstruction() {
    const std::size_t end = text_.find('>', at_);
    if (end == std::string_view::npos || text_[end - 1] != '?' || end < at_ + 3) {
      refuse(at_, GLISSADE_TEXT("has a processing instruction that does not end with its first '>'"));
    }
    at_ = end + 1;
  }

  void takeEndTag() {
    const std::size_t begin = at_;
    at_ += 2;
    const std::string_view name = takeName();
    skipSpaces();
    if (open_.empty() || name != open_.back()) {
      refuse(begin, GLISSADE_TEXT("has the end tag of an element that is not open"));
    }
    if (!take('>')) refuse(begin, GLISSADE_TEXT("has a tag that does not end"));
    open_.pop_back();
  }

  void takeStartTag() {
    const std::size_t begin = at_++;
    const std::string_view name = takeName();
    if (++elements_ > kMostElements) refuse(begin, {GLISSADE_TEXT("has more than %1 elements"), {kMostElements}});
    takeAttributes(begin);
    const bool alone = take('/');
    if (!take('>')) refuse(begin, GLISSADE_TEXT("has a tag that does not end"));
    open_.push_back(name);
    if (open_.size() > kDeepestElement) {
      refuse(begin, {GLISSADE_TEXT("is nested too deeply (more than %1 elements)"), {kDeepestElement}});
    }
    count();
    if (alone) open_.pop_back();
  }

  void takeAttributes(std::size_t tag) {
    for (std::size_t attributes = 0;;) {
      const bool apart = skipSpaces();
      if (at_ >= text_.size() || text_[at_] == '>' || text_[at_] == '/') return;
      if (!apart) refuse(tag, GLISSADE_TEXT("has a tag that is not valid XML"));
      if (++attributes > kMostAttributes) {
        refuse(tag, {GLISSADE_TEXT("has an element with more than %1 attributes"), {kMostAttributes}});
      }
      takeName();
      skipSpaces();
      if (!take('=')) refuse(at_, GLISSADE_TEXT("has an attribute without a value"));
      skipSpaces();
      takeValue();
    }
  }

  void takeValue() {
    const std::size_t begin = at_;
    const char quote = at_ < text_.size() ? text_[at_] : ' ';
    if (quote != '"' && quote != '\'') refuse(begin, GLISSADE_TEXT("has an attribute whose value is not quoted"));
    const std::size_t end = text_.find(quote, begin + 1);
    if (end == std::string_view::npos) refuse(begin, GLISSADE_TEXT("has an attribute whose value does not end"));
    if (text_.substr(begin, end - begin).find('<') != std::string_view::npos) {
      refuse(begin, GLISSADE_TEXT("has '<' in the value of an attribute, which XML writes as &lt;"));
    }
    at_ = end + 1;
  }

  std::string_view takeName() {
    const std::size_t begin = at_;
    if (at_ >= text_.size() || !beginsName(text_[at_])) {
      refuse(begin, GLISSADE_TEXT("has a tag or an attribute without a name"));
    }
    while (at_ < text_.size() && continuesName(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool skipSpaces() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
    return at_ > begin;
  }

  /// Counts the innermost open element if urdfdom reads it at that place.
  void count() {
    if (open_.size() == 2 && open_[1] == "link") ++facts_.links;
    const bool inShape = open_.size() == 4 && open_[1] == "link" && (open_[2] == "visual" || open_[2] == "collision");
    if (inShape && open_[3] == "geometry") ++facts_.geometries;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t elements_ = 0;
  std::vector<std::string_view> open_;  ///< names of the elements around `at_`
  XmlFacts facts_;
};

}  // namespace

Result<XmlFacts> precheckXml(const std::string& text, const std::string& file) {
  try {
    return XmlScanner(text).scan();
  } catch (const XmlRefusal& refusal) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(refusal.position);
    const auto line = 1 + std::count(text.begin(), end, '\n');
    return Diagnostic{ErrorKind::MalformedInput,
                      file,
                      {GLISSADE_TEXT("line %1"), {line}},
                      refusal.reason,
                      GLISSADE_TEXT("Correct the file.")};
  }
}

}  // namespace glissade
