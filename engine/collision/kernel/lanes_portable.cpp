#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

/// Eight floats in a loop: for any machine, and the reference for the others.
struct PortableFloat8 {
  float v[kWidth];

  template <class Function>
  static PortableFloat8 map(const Function& f) {
    PortableFloat8 result;
    for (std::size_t i = 0; i < kWidth; ++i) result.v[i] = f(i);
    return result;
  }
  static PortableFloat8 load(const float* p) {
    return map([&](std::size_t i) { return p[i]; });
  }
  static PortableFloat8 all(float x) {
    return map([&](std::size_t) { return x; });
  }
  static PortableFloat8 twice(const float* p) {
    return map([&](std::size_t i) { return p[i % 4]; });
  }
  static PortableFloat8 halves(const float* p) {
    return map([&](std::size_t i) { return p[i / 4]; });
  }
  void store(float* p) const {
    for (std::size_t i = 0; i < kWidth; ++i) p[i] = v[i];
  }

  using F = PortableFloat8;
  friend F operator+(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] + b.v[i]; });
  }
  friend F operator-(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] - b.v[i]; });
  }
  friend F operator*(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] * b.v[i]; });
  }
  friend F operator/(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] / b.v[i]; });
  }
  friend F min(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
  }
  friend F max(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
  }
  friend F abs(const F& a) {
    return map([&](std::size_t i) { return __builtin_fabsf(a.v[i]); });
  }
  friend F sqrt(const F& a) {
    return map([&](std::size_t i) { return __builtin_sqrtf(a.v[i]); });
  }
  /// 1 where a < b, else 0.
  friend F less(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] < b.v[i] ? 1.0F : 0.0F; });
  }
  friend F select(const F& mask, const F& yes, const F& no) {
    return map([&](std::size_t i) { return mask.v[i] > 0.0F ? yes.v[i] : no.v[i]; });
  }
  friend unsigned bits(const F& mask) {
    unsigned result = 0;
    for (std::size_t i = 0; i < kWidth; ++i) result |= mask.v[i] > 0.0F ? 1U << i : 0U;
    return result;
  }
};

}  // namespace

const LaneFunctions& portable() {
  static constexpr LaneFunctions functions = Arithmetic<PortableFloat8>::table("portable");
  return functions;
}

}  // namespace glissade::lanes
