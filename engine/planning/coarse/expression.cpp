#include "engine/planning/coarse/expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "engine/base/number_text.h"

namespace glissade {

/// A node of the parsed expression: an operation on its arguments, or a leaf.
struct Expression::Term {
  using Operation = std::function<RuleValue(const std::vector<RuleValue>&)>;

  RuleType type = RuleType::Number;
  std::string name;     ///< name of a variable; empty otherwise
  RuleValue constant;   ///< value of a leaf without a name
  Operation operation;  ///< operation of an inner node
  std::vector<std::shared_ptr<const Term>> arguments;

  RuleValue value(const NameLookup& lookup) const {
    if (operation) {
      std::vector<RuleValue> values;
      for (const auto& argument : arguments) values.push_back(argument->value(lookup));
      return operation(values);
    }
    return name.empty() ? constant : lookup(name);
  }
};

namespace {

using Term = Expression::Term;
using TermPtr = std::shared_ptr<const Term>;
using Values = std::vector<RuleValue>;

/// Deepest nesting that is accepted. Deeper rules would not be readable.
constexpr int kDeepest = 64;
/// Longest text that is accepted: a chain of operations is as deep a tree as it is long.
constexpr std::size_t kLongest = 4096;

/// Value of a division by zero, and of everything that is computed from it.
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Precondition: the value is a number, which the parser has checked.
double numberOf(const RuleValue& value) { return std::get<double>(value); }

bool isNoNumber(const RuleValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr && std::isnan(*number);
}

TermPtr leaf(RuleValue constant) {
  auto term = std::make_shared<Term>();
  term->type = std::holds_alternative<double>(constant) ? RuleType::Number : RuleType::Text;
  term->constant = std::move(constant);
  return term;
}

TermPtr variable(std::string name, RuleType type) {
  auto term = std::make_shared<Term>();
  term->type = type;
  term->name = std::move(name);
  return term;
}

TermPtr inner(Term::Operation operation, std::vector<TermPtr> arguments, RuleType type = RuleType::Number) {
  auto term = std::make_shared<Term>();
  term->type = type;
  term->operation = std::move(operation);
  term->arguments = std::move(arguments);
  return term;
}

/// Infinite minus infinite, and the like, is 0.
double orZero(double value) { return std::isnan(value) ? 0.0 : value; }

Term::Operation onNumbers(double (*operation)(double, double)) {
  return [operation](const Values& v) -> RuleValue {
    if (isNoNumber(v[0]) || isNoNumber(v[1])) return kNoNumber;
    return orZero(operation(numberOf(v[0]), numberOf(v[1])));
  };
}

Term::Operation onNumber(double (*operation)(double)) {
  return [operation](const Values& v) -> RuleValue {
    return isNoNumber(v[0]) ? kNoNumber : orZero(operation(numberOf(v[0])));
  };
}

RuleValue quotient(const Values& v) {
  return numberOf(v[1]) == 0.0 ? kNoNumber : onNumbers([](double a, double b) { return a / b; })(v);
}

RuleValue choice(const Values& v) {
  if (isNoNumber(v[0])) return kNoNumber;
  return numberOf(v[0]) != 0.0 ? v[1] : v[2];
}

/// Two values are the same if both are texts or both are numbers, and they are equal.
Term::Operation comparison(bool wantSame) {
  return [wantSame](const Values& v) -> RuleValue {
    if (isNoNumber(v[0]) || isNoNumber(v[1])) return kNoNumber;
    return (v[0] == v[1]) == wantSame ? 1.0 : 0.0;
  };
}

double best(const Values& values, bool largest) {
  double result = numberOf(values.front());
  for (const RuleValue& value : values) {
    if (isNoNumber(value)) return kNoNumber;
    result = largest ? std::max(result, numberOf(value)) : std::min(result, numberOf(value));
  }
  return result;
}

struct Function {
  std::size_t least;
  std::size_t most;
  Term::Operation operation;
};

std::map<std::string, Function> functions() {
  constexpr std::size_t kAny = 16;
  return {
      {"min", {1, kAny, [](const Values& v) -> RuleValue { return best(v, false); }}},
      {"max", {1, kAny, [](const Values& v) -> RuleValue { return best(v, true); }}},
      {"abs", {1, 1, onNumber([](double x) { return std::abs(x); })}},
      {"sqrt", {1, 1, onNumber([](double x) { return std::sqrt(std::max(0.0, x)); })}},
      {"log2", {1, 1, onNumber([](double x) { return x > 0.0 ? std::log2(x) : 0.0; })}},
      {"if", {3, 3, choice}},
  };
}

struct SyntaxError {
  std::size_t position;
  Message reason;
};

/// Recursive descent, one function a level of the grammar.
class Parser {
 public:
  Parser(const std::string& text, const NameTypes& typeOf) : text_(text), typeOf_(typeOf), functions_(functions()) {}

  TermPtr parse() {
    TermPtr term = number(&Parser::disjunction);
    skipSpaces();
    if (at_ < text_.size()) fail({GLISSADE_TEXT("'%1' was not expected"), {text_.substr(at_, 8)}});
    return term;
  }

 private:
  using Level = TermPtr (Parser::*)();

  [[noreturn]] void fail(const Message& reason) const { throw SyntaxError{at_, reason}; }

  /// Parses an operand that must be a number.
  TermPtr number(Level level) {
    skipSpaces();
    const std::size_t begin = at_;
    return numeric((this->*level)(), begin);
  }
  TermPtr numeric(TermPtr term, std::size_t begin) const {
    if (term->type == RuleType::Number) return term;
    if (term->name.empty()) throw SyntaxError{begin, GLISSADE_TEXT("a text stands where a number is needed")};
    throw SyntaxError{begin, {GLISSADE_TEXT("'%1', a text, stands where a number is needed"), {term->name}}};
  }

  void skipSpaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
  }
  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  bool takes(const std::string& token) {
    skipSpaces();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    const std::size_t after = at_ + token.size();
    if (isLetter(token.front()) && after < text_.size() && (isLetter(text_[after]) || isDigit(text_[after]))) {
      return false;
    }
    at_ = after;
    return true;
  }
  void expect(const std::string& token) {
    if (!takes(token)) fail({GLISSADE_TEXT("'%1' is missing"), {token}});
  }

  /// Operands of one level of the grammar, from left to right.
  TermPtr chain(Level operand, const std::vector<std::pair<std::string, Term::Operation>>& operations) {
    skipSpaces();
    const std::size_t begin = at_;
    TermPtr left = (this->*operand)();
    for (;;) {
      const auto found = std::find_if(operations.begin(), operations.end(),
                                      [this](const auto& operation) { return takes(operation.first); });
      if (found == operations.end()) return left;
      left = inner(found->second, {numeric(left, begin), number(operand)});
    }
  }

  TermPtr disjunction() {
    return chain(&Parser::conjunction,
                 {{"or", onNumbers([](double a, double b) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; })}});
  }
  TermPtr conjunction() {
    return chain(&Parser::negation,
                 {{"and", onNumbers([](double a, double b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; })}});
  }
  TermPtr negation() {
    if (!takes("not")) return relation();
    const Nesting nesting(*this);
    return inner(onNumber([](double x) { return x == 0.0 ? 1.0 : 0.0; }), {number(&Parser::negation)});
  }
  TermPtr relation() {
    skipSpaces();
    const std::size_t begin = at_;
    TermPtr left = sum();
    if (takes("==")) return inner(comparison(true), {left, sum()});
    if (takes("!=")) return inner(comparison(false), {left, sum()});
    const auto order = [&](double (*operation)(double, double)) {
      return inner(onNumbers(operation), {numeric(left, begin), number(&Parser::sum)});
    };
    if (takes("<=")) return order([](double a, double b) { return a <= b ? 1.0 : 0.0; });
    if (takes(">=")) return order([](double a, double b) { return a >= b ? 1.0 : 0.0; });
    if (takes("<")) return order([](double a, double b) { return a < b ? 1.0 : 0.0; });
    if (takes(">")) return order([](double a, double b) { return a > b ? 1.0 : 0.0; });
    return left;
  }
  TermPtr sum() {
    return chain(&Parser::product, {{"+", onNumbers([](double a, double b) { return a + b; })},
                                    {"-", onNumbers([](double a, double b) { return a - b; })}});
  }
  TermPtr product() {
    return chain(&Parser::unary, {{"*", onNumbers([](double a, double b) { return a * b; })}, {"/", quotient}});
  }
  TermPtr unary() {
    if (!takes("-")) return primary();
    const Nesting nesting(*this);
    return inner(onNumber([](double x) { return -x; }), {number(&Parser::unary)});
  }
  TermPtr primary() {
    const Nesting nesting(*this);
    skipSpaces();
    if (at_ >= text_.size()) fail(GLISSADE_TEXT("the rule ends too early"));
    if (takes("(")) {
      TermPtr term = disjunction();
      expect(")");
      return term;
    }
    if (text_[at_] == '"') return quoted();
    if (isDigit(text_[at_]) || text_[at_] == '.') return numeral();
    if (isLetter(text_[at_])) return named();
    fail({GLISSADE_TEXT("'%1' was not expected"), {text_.substr(at_, 1)}});
  }
  TermPtr quoted() {
    const std::size_t end = text_.find('"', at_ + 1);
    if (end == std::string::npos) fail(GLISSADE_TEXT("a text is not closed"));
    TermPtr term = leaf(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end + 1;
    return term;
  }
  TermPtr numeral() {
    std::size_t end = at_;
    while (end < text_.size() && (isDigit(text_[end]) || text_[end] == '.')) ++end;
    const auto value = toNumber(text_.substr(at_, end - at_));
    if (!value) fail({GLISSADE_TEXT("'%1' is not a number"), {text_.substr(at_, end - at_)}});
    at_ = end;
    return leaf(*value);
  }
  TermPtr named() {
    std::size_t end = at_;
    while (end < text_.size() && (isLetter(text_[end]) || isDigit(text_[end]) || text_[end] == '.')) ++end;
    const std::string name = text_.substr(at_, end - at_);
    const auto function = functions_.find(name);
    if (function != functions_.end()) {
      at_ = end;
      return call(name, function->second);
    }
    if (name == "infinite") {
      at_ = end;
      return leaf(std::numeric_limits<double>::infinity());
    }
    const auto type = typeOf_(name);
    if (!type) fail({GLISSADE_TEXT("the name '%1' is unknown"), {name}});
    at_ = end;
    return variable(name, *type);
  }
  TermPtr call(const std::string& name, const Function& function) {
    expect("(");
    const bool chooses = name == "if";
    std::vector<TermPtr> arguments{number(&Parser::disjunction)};
    while (takes(",")) arguments.push_back(chooses ? disjunction() : number(&Parser::disjunction));
    expect(")");
    if (arguments.size() < function.least || arguments.size() > function.most) {
      fail({GLISSADE_TEXT("'%1' has the wrong number of arguments"), {name}});
    }
    const bool text = std::any_of(arguments.begin(), arguments.end(),
                                  [](const TermPtr& argument) { return argument->type == RuleType::Text; });
    return inner(function.operation, std::move(arguments), text ? RuleType::Text : RuleType::Number);
  }

  /// Counts how deep the grammar has gone.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepest) parser_.fail(GLISSADE_TEXT("the rule is nested too deeply"));
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  const std::string& text_;
  const NameTypes& typeOf_;
  std::map<std::string, Function> functions_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Location columnAt(std::size_t position) { return {GLISSADE_TEXT("column %1"), {position + 1}}; }

}  // namespace

Result<Expression> Expression::parse(const std::string& text, const NameTypes& typeOf) {
  if (text.size() > kLongest) {
    return Diagnostic{ErrorKind::MalformedInput,
                      "",
                      columnAt(kLongest),
                      GLISSADE_TEXT("the rule is too long"),
                      {GLISSADE_TEXT("Use at most %1 characters."), {kLongest}}};
  }
  try {
    return Expression(text, Parser(text, typeOf).parse());
  } catch (const SyntaxError& error) {
    const std::string shown = text.size() > 200 ? text.substr(0, 200) + "..." : text;
    return Diagnostic{ErrorKind::MalformedInput,
                      "",
                      columnAt(error.position),
                      error.reason,
                      {GLISSADE_TEXT("Correct the rule: %1"), {shown}}};
  }
}

double Expression::number(const NameLookup& lookup) const { return numberOf(root_->value(lookup)); }

bool Expression::holds(const NameLookup& lookup) const {
  const RuleValue value = root_->value(lookup);
  return !isNoNumber(value) && numberOf(value) != 0.0;
}

}  // namespace glissade
