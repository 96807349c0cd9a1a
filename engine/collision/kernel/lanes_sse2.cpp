#include <emmintrin.h>

#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

/// Eight floats in two registers: what every x86-64 has.
struct Sse2Float8 {
  __m128 low, high;

  using F = Sse2Float8;
  static F load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
  static F all(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
  static F twice(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p)}; }
  static F halves(const float* p) { return {_mm_set1_ps(p[0]), _mm_set1_ps(p[1])}; }
  void store(float* p) const {
    _mm_storeu_ps(p, low);
    _mm_storeu_ps(p + 4, high);
  }

  friend F operator+(F a, F b) { return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)}; }
  friend F operator-(F a, F b) { return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)}; }
  friend F operator*(F a, F b) { return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)}; }
  friend F operator/(F a, F b) { return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)}; }
  friend F min(F a, F b) { return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)}; }
  friend F max(F a, F b) { return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)}; }
  friend F sqrt(F a) { return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
  friend F abs(F a) {
    const __m128 sign = _mm_set1_ps(-0.0F);
    return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
  }
  friend F less(F a, F b) { return {_mm_cmplt_ps(a.low, b.low), _mm_cmplt_ps(a.high, b.high)}; }
  friend F select(F mask, F yes, F no) {
    return {_mm_or_ps(_mm_and_ps(mask.low, yes.low), _mm_andnot_ps(mask.low, no.low)),
            _mm_or_ps(_mm_and_ps(mask.high, yes.high), _mm_andnot_ps(mask.high, no.high))};
  }
  friend unsigned bits(F mask) {
    return static_cast<unsigned>(_mm_movemask_ps(mask.low)) | static_cast<unsigned>(_mm_movemask_ps(mask.high)) << 4;
  }
};

}  // namespace

const LaneFunctions& sse2() {
  static constexpr LaneFunctions functions = Arithmetic<Sse2Float8>::table("sse2");
  return functions;
}

}  // namespace glissade::lanes
