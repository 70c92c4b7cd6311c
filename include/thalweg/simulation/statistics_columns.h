// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_statistics_columns_h
#define thalweg_simulation_statistics_columns_h

#include <string>
#include <vector>

namespace Thalweg
{
  /// How the statistics begin; behind these stand the columns of the solver
  /// and the wall times.
  const std::vector<std::string> &
  leading_columns();
} // namespace Thalweg

#endif
