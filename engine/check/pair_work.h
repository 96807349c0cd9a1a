#pragma once

#include <optional>
#include <vector>

#include "engine/check/pair_fit.h"

namespace glissade::check {

/// By which two careful estimates of the same bound may differ, as a share of it.
inline constexpr double kEstimate = 0.02;

/// 0 where there are none.
double largest(const std::vector<double>& values);

/// A pair while a judgement takes it: what is asked, and what has been found so far.
struct PairWork {
  /// Finds what the pair may be taken thinner, with this word about it; null: nobody said anything.
  void findBounds(const PairWord* about);
  /// An allowance of the moving body or, where it yields, of the other one, with what `bounds` says of it.
  AppliedAllowance& add(bool yields, double applied);
  /// The pitch is a person's, else the stated one, else that of the path. Which body may turn is a person's word.
  void heedWord(Thread& thread, const std::optional<double>& stated);

  const PairQuestion& question;
  const FitWords& fits;
  PlacedBodies& bodies;
  const StopToken& stop;
  const PairWord* word;  ///< a person's about the pair; null: none
  PairBounds bounds{};
  PairFit fit{};
};

}  // namespace glissade::check
