// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_motion_table_h
#define thalweg_fluid_motion_table_h

#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Reads a table of numbers against time.
   *
   * The first line that is neither empty nor a comment (#) names the columns,
   * the first of which is the time "t"; commas, semicolons or white space
   * separate. A column of @p allowed is whatever the caller makes of it.
   *
   * @param path of the file
   * @param allowed names besides "t"
   * @param end the time, s, from 0 to which it must reach
   * @param where the parameter that names the file, for messages
   * @return the columns by name, all of the same length of at least two
   * @throws dealii::ExcMessage with file and line for whatever cannot be used
   */
  std::map<std::string, std::vector<double>>
  read_motion_table(const std::string              &path,
                    const std::vector<std::string> &allowed,
                    const double                    end,
                    const std::string              &where);
} // namespace Thalweg

#endif
