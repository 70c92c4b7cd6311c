// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/files.h>
#include <thalweg/core/log.h>
#include <thalweg/core/plain_text.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <iostream>

namespace Thalweg
{
  void
  Log::open(const std::string &path, const bool append)
  {
    if (!active)
      return;
    this->path = path;
    errno      = 0;
    file.open(path, append ? std::ios::app : std::ios::trunc);
    AssertThrow(file, dealii::ExcMessage(file_failure("write", path, errno)));
  }



  void
  Log::line(const std::string &text)
  {
    if (active)
      write(std::cout, text);
  }



  void
  Log::warning(const std::string &text)
  {
    if (active)
      write(std::cerr, "Warning: " + bounded_message(text));
  }



  void
  Log::write(std::ostream &terminal, const std::string &text)
  {
    terminal.clear();
    terminal << text << std::endl;
    if (path.empty())
      return;
    file.clear();
    errno = 0;
    file << text << std::endl;
    if (file || has_complained)
      return;
    has_complained = true;
    std::cerr << "Warning: " << file_failure("write", path, errno)
              << " The run goes on, and tries again with each line."
              << std::endl;
  }
} // namespace Thalweg
