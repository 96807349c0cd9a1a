#pragma once

#include "engine/collision/kernel/lanes.h"

namespace glissade::lanes {

/// Eight (or four) vectors over a vector `F` of numbers.
template <class F>
struct Vec3 {
  F x, y, z;

  static Vec3 load(const float (&rows)[3][kWidth]) { return {F::load(rows[0]), F::load(rows[1]), F::load(rows[2])}; }
  static Vec3 broadcast(const float (&rows)[3][kWidth], std::size_t lane) {
    return {F::all(rows[0][lane]), F::all(rows[1][lane]), F::all(rows[2][lane])};
  }
  void store(float (&rows)[3][kWidth]) const {
    x.store(rows[0]);
    y.store(rows[1]);
    z.store(rows[2]);
  }

  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator*(F s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend F dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Vec3 absolute(const Vec3& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
  friend Vec3 select(F mask, const Vec3& yes, const Vec3& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
  }
  friend F sumOfAbsolutes(const Vec3& a) { return abs(a.x) + abs(a.y) + abs(a.z); }
};

}  // namespace glissade::lanes
