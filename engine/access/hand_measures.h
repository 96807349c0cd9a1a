#pragma once

#include "engine/base/enum_names.h"

namespace glissade {

/// Whose hand is asked about.
enum class HandSize { SmallWoman, Average, LargeMan };

inline constexpr HandSize kHandSizes[] = {HandSize::SmallWoman, HandSize::Average, HandSize::LargeMan};

/// Lengths of a hand and a forearm, metres. Source: ANSUR II (2012 Anthropometric Survey of U.S. Army Personnel,
/// NATICK/TR-15/007), 4,082 men and 1,986 women; the percentiles are those of its public data. Every measure is at the
/// percentile: a person of whom all are there at the same time is rare, and larger or smaller than that share of
/// people.
struct HandMeasures {
  double handLength = 0.0;            ///< wrist crease to the tip of the middle finger
  double palmLength = 0.0;            ///< wrist crease to the crease of the middle finger
  double handBreadth = 0.0;           ///< across the knuckles, without the thumb
  double handCircumference = 0.0;     ///< about the knuckles
  double wristCircumference = 0.0;    ///< at the stylion
  double forearmCircumference = 0.0;  ///< the largest, flexed
  double forearmHandLength = 0.0;     ///< elbow to the tip of the middle finger

  double forearmLength() const { return forearmHandLength - handLength; }
  /// Thickness of a hand with this breadth and circumference whose cross-section consists of two lines and two half
  /// circles.
  double handThickness() const;
};

/// 5th percentile of women; the mean of the medians of women and men; 95th percentile of men.
const HandMeasures& measuresOf(HandSize size);

/// "p5f", "p50", "p95m".
inline constexpr EnumNames<HandSize, 3> kHandSizeNames{{"p5f", "p50", "p95m"}};

}  // namespace glissade
