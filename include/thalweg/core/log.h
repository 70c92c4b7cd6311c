#ifndef thalweg_core_log_h
#define thalweg_core_log_h

#include <fstream>
#include <iostream>
#include <string>

namespace Thalweg
{
  /**
   * @brief What a run tells: on the terminal and in `log.txt`, by the root
   * process alone.
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
    void
    open(const std::string &path, const bool append = false)
    {
      if (active)
        file.open(path, append ? std::ios::app : std::ios::trunc);
    }

    /// Writes a line.
    void
    line(const std::string &text)
    {
      if (!active)
        return;
      std::cout << text << std::endl;
      if (file.is_open())
        file << text << std::endl;
    }

    /// Writes a line that begins with "Warning: ", on the error stream.
    void
    warning(const std::string &text)
    {
      if (!active)
        return;
      std::cerr << "Warning: " << text << std::endl;
      if (file.is_open())
        file << "Warning: " << text << std::endl;
    }

  private:
    bool          active;
    std::ofstream file;
  };
} // namespace Thalweg

#endif
