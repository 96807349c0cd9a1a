#include "engine/collision/kernel/lane_arithmetic.h"
#include "engine/collision/kernel/lanes_of.h"

namespace glissade::lanes {
namespace {

/// A vector of `kCount` numbers with loops: for any machine, and the reference for the others.
template <class Real, std::size_t kCount>
struct Portable {
  static constexpr unsigned kAllBits = (1U << kCount) - 1U;
  using F = Portable;

  Real v[kCount];

  template <class Function>
  static F map(const Function& f) {
    F result;
    for (std::size_t i = 0; i < kCount; ++i) result.v[i] = f(i);
    return result;
  }
  static F load(const Real* p) {
    return map([&](std::size_t i) { return p[i]; });
  }
  static F all(double x) {
    return map([&](std::size_t) { return static_cast<Real>(x); });
  }
  static F tiny() { return all(sizeof(Real) == sizeof(float) ? 1e-37 : 1e-300); }
  static F twice(const Real* p) {
    return map([&](std::size_t i) { return p[i % 4]; });
  }
  static F halves(const Real* p) {
    return map([&](std::size_t i) { return p[i / 4]; });
  }
  void store(Real* p) const {
    for (std::size_t i = 0; i < kCount; ++i) p[i] = v[i];
  }

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
    return map([&](std::size_t i) { return a.v[i] < 0 ? -a.v[i] : a.v[i]; });
  }
  friend F sqrt(const F& a) {
    return map([&](std::size_t i) { return static_cast<Real>(__builtin_sqrt(a.v[i])); });
  }
  /// 1 where a < b, else 0.
  friend F less(const F& a, const F& b) {
    return map([&](std::size_t i) { return a.v[i] < b.v[i] ? Real(1) : Real(0); });
  }
  friend F select(const F& mask, const F& yes, const F& no) {
    return map([&](std::size_t i) { return mask.v[i] > 0 ? yes.v[i] : no.v[i]; });
  }
  friend unsigned bits(const F& mask) {
    unsigned result = 0;
    for (std::size_t i = 0; i < kCount; ++i) result |= mask.v[i] > 0 ? 1U << i : 0U;
    return result;
  }
};

}  // namespace

const LaneFunctions& portable() {
  static constexpr LaneFunctions functions = table<Portable<float, 8>, Portable<double, 4>>("portable");
  return functions;
}

}  // namespace glissade::lanes
