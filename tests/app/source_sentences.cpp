#include "tests/app/source_sentences.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace glissade::test {
namespace {

enum class Kind { Text, Word, Mark };

struct Token {
  Kind kind;
  std::string text;  ///< of a literal without quotes and escapes, of a mark one character or "<<", "->"
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

/// Past the quote that ends the literal which begins at `at`.
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
      // A ' within a number separates digits.
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

/// What is known so far of one expression.
struct Expression {
  std::string text;
  int places = 0;
  bool hasText = false;
  bool endsInPlace = false;
  bool isOneText = false;  ///< a single literal and nothing else
  bool streams = false;
  bool ofString = false;  ///< what std::string is made of

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
  /// What stands before the first << is the stream.
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

  /// Whether std::string is made there of what follows in parentheses.
  bool isString(std::size_t at) const {
    return at + 1 < tokens_.size() && tokens_[at].text == "std::string" && tokens_[at + 1].text == "(";
  }

  void open() {
    const bool ofString = at_ > 0 && isString(at_ - 1);
    open_.push_back({});
    current().ofString = ofString;
  }

  /// Angle brackets of a cast or a template hug a word; those of a comparison do not.
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

}  // namespace

std::vector<std::string> textsMadeIn(const std::string& source) { return Reader(source).texts(); }

}  // namespace glissade::test
