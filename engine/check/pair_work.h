#pragma once

#include <optional>
#include <vector>

#include "engine/check/pair_fit.h"

namespace glissade::check {

/// Relative difference within which two careful estimates of a bound agree.
inline constexpr double kEstimate = 0.02;

/// 0 if there are no values.
double largest(const std::vector<double>& values);

/// The judgement of a pair: its input and its intermediate results.
struct PairWork {
  /// Finds the allowances of the pair with this statement about it; null: nobody has stated anything.
  void findBounds(const PairWord* about);
  /// Adds an allowance of the moving body or, if `yields`, of the other body, with the evidence of `bounds`.
  AppliedAllowance& add(bool yields, double applied);
  /// Sets the pitch: a person's, else the stated one, else that of the path. Sets which body may turn by a person's
  /// statement.
  void applyStatements(Thread& thread, const std::optional<double>& stated);

  const PairQuestion& question;
  const FitWords& fits;
  PlacedBodies& bodies;
  const StopToken& stop;
  const PairWord* word;  ///< a person's statement about the pair; null: none
  PairBounds bounds{};
  PairFit fit{};
};

}  // namespace glissade::check
