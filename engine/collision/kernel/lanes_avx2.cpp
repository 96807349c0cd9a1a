#include <immintrin.h>

#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

struct Avx2Float8 {
  __m256 v;

  using F = Avx2Float8;
  static F load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static F all(float x) { return {_mm256_set1_ps(x)}; }
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

}  // namespace

const LaneFunctions& avx2() {
  static constexpr LaneFunctions functions = Arithmetic<Avx2Float8>::table("avx2");
  return functions;
}

}  // namespace glissade::lanes
