#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "engine/base/result.h"

namespace glissade {

/// A value in a rule: booleans are the numbers 0 and 1.
using RuleValue = std::variant<double, std::string>;

/// Looks a name of a rule up: "distance", "place.complexity", "object.shape".
using NameLookup = std::function<RuleValue(const std::string& name)>;

/// A small expression that a user can read and change, for the functions f and g of paper 2,
/// equation (1), and for choosing planners. Grammar, loosest first:
///   or | and | not | < <= > >= == != | + - | * / | unary - | number, "text", name, ( ),
///   min(a, b...), max(a, b...), abs(a), sqrt(a), log2(a), if(condition, a, b), infinite
class Expression {
 public:
  /// Syntax errors and names for which `known` is false are MalformedInput errors that tell the
  /// position in the text.
  static Result<Expression> parse(const std::string& text, const std::function<bool(const std::string&)>& known);

  Expression(const Expression&) = default;
  Expression(Expression&&) = default;
  Expression& operator=(const Expression&) = default;
  Expression& operator=(Expression&&) = default;
  ~Expression() = default;

  const std::string& text() const { return text_; }
  /// A text where a number is needed counts as 0, as does what is not a number.
  double number(const NameLookup& lookup) const;
  bool holds(const NameLookup& lookup) const { return number(lookup) != 0.0; }

  struct Term;

 private:
  Expression(std::string text, std::shared_ptr<const Term> root) : text_(std::move(text)), root_(std::move(root)) {}

  std::string text_;
  std::shared_ptr<const Term> root_;
};

}  // namespace glissade
