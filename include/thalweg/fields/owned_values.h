// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_owned_values_h
#define thalweg_fields_owned_values_h

#include <thalweg/fields/dependences.h>

namespace Thalweg
{
  /// a = b; ghosts are not updated.
  inline void
  copy_owned(Vector &a, const Vector &b)
  {
    a.zero_out_ghost_values();
    a.copy_locally_owned_data_from(b);
  }

  /// result = new_value + ratio (new_value - old_value); ghosts are not
  /// updated.
  inline void
  extrapolate_owned(const Vector &new_value,
                    const Vector &old_value,
                    const double  ratio,
                    Vector       &result)
  {
    copy_owned(result, new_value);
    result.add(ratio, new_value);
    result.add(-ratio, old_value);
  }
} // namespace Thalweg

#endif
