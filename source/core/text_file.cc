// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/core/text_file.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Thalweg
{
  namespace
  {
    /// An open file.
    class InputDescriptor
    {
    public:
      explicit InputDescriptor(const std::string &path)
        // A pipe without a writer would block.
        : number(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
      {}

      InputDescriptor(const InputDescriptor &) = delete;

      ~InputDescriptor()
      {
        if (number >= 0)
          ::close(number);
      }

      const int number;
    };


    [[noreturn]] void
    refuse(const std::string &what, const std::string &why)
    {
      throw dealii::ExcMessage(what + " cannot be read: " + why);
    }


    void
    expect_plain(const struct stat &status,
                 const std::string &what,
                 const std::size_t  longest)
    {
      if (S_ISDIR(status.st_mode))
        refuse(what, "it is a directory, not a file.");
      if (!S_ISREG(status.st_mode))
        refuse(what,
               "it is a pipe or a device, not a file. Write its content to a "
               "file, and give the name of that.");
      if (static_cast<std::size_t>(status.st_size) > longest)
        refuse(what,
               "it has " + std::to_string(status.st_size) +
                 " bytes, more than the " + std::to_string(longest) +
                 " that such a file can have. Is it the right one?");
    }
  } // namespace



  std::string
  with_home(const std::string &path)
  {
    if (path.empty() || path[0] != '~')
      return path;
    const std::size_t slash = path.find('/');
    if (slash != 1 && path.size() > 1)
      {
        AssertThrow(slash == std::string::npos,
                    dealii::ExcMessage(
                      "The home directory of somebody else is not looked up in "
                      "the path '" +
                      excerpt(path) + "'. Write the whole path instead."));
        return path;
      }
    const char *const home = std::getenv("HOME");
    AssertThrow(home != nullptr && *home != '\0',
                dealii::ExcMessage(
                  "The path '" + excerpt(path) +
                  "' begins with '~', but the environment variable HOME, "
                  "which says what that is, is not set. Write the whole "
                  "path."));
    return home + path.substr(1);
  }



  TextFile
  read_text_file(const std::string &path,
                 const std::string &what,
                 const std::size_t  longest)
  {
    struct stat status;
    // Opening a device may do something already.
    if (::stat(path.c_str(), &status) != 0)
      refuse(what, std::strerror(errno));
    expect_plain(status, what, longest);
    const InputDescriptor file(path);
    if (file.number < 0 || ::fstat(file.number, &status) != 0)
      refuse(what, std::strerror(errno));
    expect_plain(status, what, longest);

    TextFile text;
    text.identity = {status.st_dev, status.st_ino};
    char buffer[1 << 16];
    while (true)
      {
        const ssize_t n = ::read(file.number, buffer, sizeof(buffer));
        if (n < 0 && errno == EINTR)
          continue;
        if (n < 0)
          refuse(what,
                 "after " + std::to_string(text.content.size()) +
                   " bytes: " + std::strerror(errno));
        if (n == 0)
          return text;
        text.content.append(buffer, n);
        if (text.content.size() > longest)
          refuse(what,
                 "it has more than the " + std::to_string(longest) +
                   " bytes that such a file can have.");
      }
  }



  std::string
  plain_lines(const std::string &content, const std::string &what)
  {
    const bool is_utf_16 = content.compare(0, 2, "\xFF\xFE") == 0 ||
                           content.compare(0, 2, "\xFE\xFF") == 0;
    AssertThrow(!is_utf_16 && content.find('\0') == std::string::npos,
                dealii::ExcMessage(what +
                                   " is not plain text (perhaps it is in "
                                   "UTF-16, or binary); save it as UTF-8."));
    const bool  has_mark = content.compare(0, 3, "\xEF\xBB\xBF") == 0;
    std::string text;
    text.reserve(content.size());
    for (std::size_t i = has_mark ? 3 : 0; i < content.size(); ++i)
      if (content[i] != '\r')
        text += content[i];
      else if (i + 1 == content.size() || content[i + 1] != '\n')
        text += '\n';
    return text;
  }
} // namespace Thalweg
