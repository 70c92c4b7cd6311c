// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_materials_fluid_values_h
#define thalweg_materials_fluid_values_h

#include <thalweg/materials/fluids.h>

#include <array>
#include <string>

namespace Thalweg
{
  /**
   * @brief Reads what users give fluid by fluid: `0.1` for all of them, or
   * `water: 0.1, air: 2`.
   * @param where the parameter, for the message
   * @param least what no value may be below
   * @return of both fluids, of a single one twice
   * @throws dealii::ExcMessage for what is no number, too small, of a fluid
   *   that is not there, or missing
   */
  std::array<double, 2>
  read_fluid_values(const std::string &text,
                    const Fluids      &fluids,
                    const double       least,
                    const std::string &where);
} // namespace Thalweg

#endif
