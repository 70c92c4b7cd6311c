// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_jacobi_h
#define thalweg_linear_algebra_jacobi_h

namespace Thalweg
{
  /// The inverse diagonal of a matrix as a preconditioner.
  template <typename Vector>
  struct Jacobi
  {
    Vector inverse_diagonal;

    void
    vmult(Vector &destination, const Vector &source) const
    {
      destination = source;
      destination.scale(inverse_diagonal);
    }
  };
} // namespace Thalweg

#endif
