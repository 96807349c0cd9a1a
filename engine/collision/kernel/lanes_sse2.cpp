#include <emmintrin.h>

#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

/// Eight floats in two registers, which every x86-64 processor has.
struct Sse2Float8 {
  static constexpr unsigned kAllBits = 0xFF;
  using F = Sse2Float8;

  __m128 low, high;

  static F load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
  static F all(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
  static F tiny() { return all(1e-37F); }
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

/// Four doubles in two registers.
struct Sse2Double4 {
  static constexpr unsigned kAllBits = 0xF;
  using F = Sse2Double4;

  __m128d low, high;

  static F load(const double* p) { return {_mm_loadu_pd(p), _mm_loadu_pd(p + 2)}; }
  static F all(double x) { return {_mm_set1_pd(x), _mm_set1_pd(x)}; }
  static F tiny() { return all(1e-300); }
  void store(double* p) const {
    _mm_storeu_pd(p, low);
    _mm_storeu_pd(p + 2, high);
  }

  friend F operator+(F a, F b) { return {_mm_add_pd(a.low, b.low), _mm_add_pd(a.high, b.high)}; }
  friend F operator-(F a, F b) { return {_mm_sub_pd(a.low, b.low), _mm_sub_pd(a.high, b.high)}; }
  friend F operator*(F a, F b) { return {_mm_mul_pd(a.low, b.low), _mm_mul_pd(a.high, b.high)}; }
  friend F operator/(F a, F b) { return {_mm_div_pd(a.low, b.low), _mm_div_pd(a.high, b.high)}; }
  friend F min(F a, F b) { return {_mm_min_pd(a.low, b.low), _mm_min_pd(a.high, b.high)}; }
  friend F max(F a, F b) { return {_mm_max_pd(a.low, b.low), _mm_max_pd(a.high, b.high)}; }
  friend F less(F a, F b) { return {_mm_cmplt_pd(a.low, b.low), _mm_cmplt_pd(a.high, b.high)}; }
  friend F select(F mask, F yes, F no) {
    return {_mm_or_pd(_mm_and_pd(mask.low, yes.low), _mm_andnot_pd(mask.low, no.low)),
            _mm_or_pd(_mm_and_pd(mask.high, yes.high), _mm_andnot_pd(mask.high, no.high))};
  }
  friend unsigned bits(F mask) {
    return static_cast<unsigned>(_mm_movemask_pd(mask.low)) | static_cast<unsigned>(_mm_movemask_pd(mask.high)) << 2;
  }
};

}  // namespace

const LaneFunctions& sse2() {
  static constexpr LaneFunctions functions = table<Sse2Float8, Sse2Double4>("sse2");
  return functions;
}

}  // namespace glissade::lanes
