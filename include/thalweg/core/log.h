// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_log_h
#define thalweg_core_log_h

#include <fstream>
#include <iosfwd>
#include <string>

namespace Thalweg
{
  /**
   * @brief What a run tells: on the terminal and in `log.txt`, by the root
   * process alone.
   *
   * A terminal that is gone or a disk that is full stops nothing: the other one
   * is told, once, and both are tried again with each line.
   */
  class Log
  {
  public:
    /// @param active whether this process speaks
    explicit Log(const bool active)
      : active(active)
    {}

    /// From now on writes to the file @p path too.
    /// @param append whether what stands there remains
    /// @throws dealii::ExcMessage if it cannot be opened
    void
    open(const std::string &path, const bool append = false);

    /// Writes a line.
    void
    line(const std::string &text);

    /// Writes a line that begins with "Warning: ", on the error stream.
    void
    warning(const std::string &text);

  private:
    void
    write(std::ostream &terminal, const std::string &text);

    bool          active;
    std::string   path;
    std::ofstream file;
    bool          has_complained = false;
  };
} // namespace Thalweg

#endif
