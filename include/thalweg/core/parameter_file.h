// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_parameter_file_h
#define thalweg_core_parameter_file_h

#include <thalweg/core/input_lines.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What a user wrote: an input file and the options that override
   * it.
   *
   * It is read before any parameter is declared, because some settings (the
   * dimension) decide what is declared. Nothing wrong is passed over: every
   * fault is kept, and they are reported together with their places and with
   * the nearest right names.
   *
   * A file may set a parameter once. What an included file sets may be set
   * once more by the file that includes it, and an option overrides both.
   */
  class ParameterFile
  {
  public:
    /// Without a file: all parameters keep their defaults.
    ParameterFile() = default;

    /// Reads the file @p path. Faults are kept for apply().
    explicit ParameterFile(const std::string &path);

    /// Reads @p text, which messages call @p name.
    ParameterFile(const std::string &text, const std::string &name);

    /// Overrides a parameter by @p assignment, "Section/Name=value".
    void
    override(const std::string &assignment);

    /// The value that was given to "Section/Name", or @p otherwise.
    std::string
    value(const std::string &path, const std::string &otherwise) const;

    /// Whether nothing was given at all.
    bool
    is_empty() const
    {
      return lines.entries.empty() && lines.sections.empty() &&
             lines.faults.empty() && overrides.empty();
    }

    /**
     * @brief Sets all parameters in @p prm, and so the variables that belong
     * to them, as far as nothing is wrong with them.
     * @return all that is wrong, "file:line: what is wrong" each: lines that
     *   cannot be understood, names that @p prm does not declare, values that
     *   do not fit, settings given twice
     */
    std::vector<std::string>
    apply(dealii::ParameterHandler &prm) const;

  private:
    InputLines              lines;
    std::vector<InputEntry> overrides;
  };

  /// Throws one exception that lists @p faults, if there are any.
  /// @throws dealii::ExcMessage
  void
  throw_faults(const std::vector<std::string> &faults);
} // namespace Thalweg

#endif
