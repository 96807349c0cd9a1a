#include <immintrin.h>

#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

struct Avx2Float8 {
  static constexpr unsigned kAllBits = 0xFF;
  using F = Avx2Float8;

  __m256 v;

  static F load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static F all(float x) { return {_mm256_set1_ps(x)}; }
  static F tiny() { return all(1e-37F); }
  static F twice(const float* p) { return {_mm256_broadcast_ps(reinterpret_cast<const __m128*>(p))}; }
  static F halves(const float* p) { return {_mm256_set_m128(_mm_set1_ps(p[1]), _mm_set1_ps(p[0]))}; }
  void store(float* p) const { _mm256_storeu_ps(p, v); }

  friend F operator+(F a, F b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend F operator-(F a, F b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend F operator*(F a, F b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend F operator/(F a, F b) { return {_mm256_div_ps(a.v, b.v)}; }
  friend F min(F a, F b) { return {_mm256_min_ps(a.v, b.v)}; }
  friend F max(F a, F b) { return {_mm256_max_ps(a.v, b.v)}; }
  friend F sqrt(F a) { return {_mm256_sqrt_ps(a.v)}; }
  friend F abs(F a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)}; }
  friend F less(F a, F b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
  friend F select(F mask, F yes, F no) { return {_mm256_blendv_ps(no.v, yes.v, mask.v)}; }
  friend unsigned bits(F mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask.v)); }
};

struct Avx2Double4 {
  static constexpr unsigned kAllBits = 0xF;
  using F = Avx2Double4;

  __m256d v;

  static F load(const double* p) { return {_mm256_loadu_pd(p)}; }
  static F all(double x) { return {_mm256_set1_pd(x)}; }
  static F tiny() { return all(1e-300); }
  void store(double* p) const { _mm256_storeu_pd(p, v); }

  friend F operator+(F a, F b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend F operator-(F a, F b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend F operator*(F a, F b) { return {_mm256_mul_pd(a.v, b.v)}; }
  friend F operator/(F a, F b) { return {_mm256_div_pd(a.v, b.v)}; }
  friend F min(F a, F b) { return {_mm256_min_pd(a.v, b.v)}; }
  friend F max(F a, F b) { return {_mm256_max_pd(a.v, b.v)}; }
  friend F less(F a, F b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
  friend F select(F mask, F yes, F no) { return {_mm256_blendv_pd(no.v, yes.v, mask.v)}; }
  friend unsigned bits(F mask) { return static_cast<unsigned>(_mm256_movemask_pd(mask.v)); }
};

}  // namespace

const LaneFunctions& avx2() {
  static constexpr LaneFunctions functions = table<Avx2Float8, Avx2Double4>("avx2");
  return functions;
}

}  // namespace glissade::lanes
