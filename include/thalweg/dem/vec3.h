// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_vec3_h
#define thalweg_dem_vec3_h

#include <cmath>

/// Functions of the loops over contacts are part of these, so that they are
/// compiled for the same instruction set.
#define THALWEG_INLINE inline __attribute__((always_inline))

/// A loop that is compiled for several instruction sets; which one runs is
/// chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#  define THALWEG_FOR_ALL_PROCESSORS \
    __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#  define THALWEG_FOR_ALL_PROCESSORS
#endif

namespace Thalweg
{
  /// Without references, which keep compilers from working on several at once.
  THALWEG_INLINE double
  smaller(const double a, const double b)
  {
    return a < b ? a : b;
  }

  THALWEG_INLINE double
  larger(const double a, const double b)
  {
    return a > b ? a : b;
  }

  /**
   * @brief Three components, also in two dimensions, where those of places and
   * velocities end with zero and those of spins begin with two of them.
   *
   * Grains do without deal.II's tensors: their loops are in files that do not
   * depend on what these are compiled for.
   */
  struct Vec3
  {
    double x, y, z;
  };

  THALWEG_INLINE Vec3
  operator+(const Vec3 &a, const Vec3 &b)
  {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }

  THALWEG_INLINE Vec3
  operator-(const Vec3 &a, const Vec3 &b)
  {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }

  THALWEG_INLINE Vec3
  operator-(const Vec3 &a)
  {
    return {-a.x, -a.y, -a.z};
  }

  THALWEG_INLINE Vec3
  operator*(const double s, const Vec3 &a)
  {
    return {s * a.x, s * a.y, s * a.z};
  }

  THALWEG_INLINE Vec3 &
  operator+=(Vec3 &a, const Vec3 &b)
  {
    a.x += b.x;
    a.y += b.y;
    a.z += b.z;
    return a;
  }

  THALWEG_INLINE Vec3 &
  operator-=(Vec3 &a, const Vec3 &b)
  {
    a.x -= b.x;
    a.y -= b.y;
    a.z -= b.z;
    return a;
  }

  THALWEG_INLINE double
  dot(const Vec3 &a, const Vec3 &b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }

  THALWEG_INLINE Vec3
  cross(const Vec3 &a, const Vec3 &b)
  {
    return {a.y * b.z - a.z * b.y,
            a.z * b.x - a.x * b.z,
            a.x * b.y - a.y * b.x};
  }

  THALWEG_INLINE double
  norm_square(const Vec3 &a)
  {
    return dot(a, a);
  }

  THALWEG_INLINE double
  norm(const Vec3 &a)
  {
    return std::sqrt(dot(a, a));
  }
} // namespace Thalweg

#endif
