#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "engine/base/result.h"

namespace glissade {

/// A value in a rule: booleans are the numbers 0 and 1.
using RuleValue = std::variant<double, std::string>;

enum class RuleType { Number, Text };
/// The type of a name in a rule ("distance", "place.complexity", "object.shape"); nothing where the name is unknown.
using NameTypes = std::function<std::optional<RuleType>(const std::string& name)>;
/// The value of a known name.
using NameLookup = std::function<RuleValue(const std::string& name)>;

/// A small expression that a user can read and change, for the functions f and g of paper 2,
/// equation (1), and for choosing planners. Grammar, loosest first:
///   or | and | not | < <= > >= == != | + - | * / | unary - | number, "text", name, ( ),
///   min(a, b...), max(a, b...), abs(a), sqrt(a), log2(a), if(condition, a, b), infinite
class Expression {
 public:
  /// Syntax errors, unknown names and texts where a number is needed are MalformedInput errors that tell the
  /// position in the text.
  static Result<Expression> parse(const std::string& text, const NameTypes& typeOf);

  Expression(const Expression&) = default;
  Expression(Expression&&) = default;
  Expression& operator=(const Expression&) = default;
  Expression& operator=(Expression&&) = default;
  ~Expression() = default;

  const std::string& text() const { return text_; }
  /// The value of the expression; not a number where the rule divides by zero. Infinite minus infinite, and zero times
  /// infinite, are 0.
  double number(const NameLookup& lookup) const;
  /// A condition that divides by zero does not hold.
  bool holds(const NameLookup& lookup) const;

  struct Term;

 private:
  Expression(std::string text, std::shared_ptr<const Term> root) : text_(std::move(text)), root_(std::move(root)) {}

  std::string text_;
  std::shared_ptr<const Term> root_;
};

}  // namespace glissade
