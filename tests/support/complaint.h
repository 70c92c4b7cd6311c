// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_complaint_h
#define tests_support_complaint_h

#include <thalweg/core/spelling.h>

#include <deal.II/base/exceptions.h>

#include <sstream>
#include <string>

/// What an exception says that @p action throws; empty: nothing is thrown.
template <typename Action>
std::string
complaint_of(const Action &action)
{
  try
    {
      action();
    }
  catch (const dealii::ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      return Thalweg::trimmed(text.str());
    }
  return "";
}

#endif
