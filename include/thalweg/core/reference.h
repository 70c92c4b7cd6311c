// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_reference_h
#define thalweg_core_reference_h

#include <deal.II/base/parameter_handler.h>

#include <ostream>
#include <string>

namespace Thalweg
{
  /**
   * @brief Prints all parameters that @p prm declares, in the order of their
   * declaration.
   * @param out where to
   * @param prm with the values to print
   * @param format "prm", an input file with the documentation as comments;
   *   "json"; or "markdown", the reference in `doc/parameters.md`
   */
  void
  print_reference(std::ostream                   &out,
                  const dealii::ParameterHandler &prm,
                  const std::string              &format);
} // namespace Thalweg

#endif
