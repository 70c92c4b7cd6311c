// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/run_lock.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace Thalweg
{
  namespace
  {
    /// Who has a directory.
    struct Holder
    {
      std::string host;
      long        process = 0;
    };



    Holder
    this_process()
    {
      char host[256] = "";
      ::gethostname(host, sizeof(host) - 1);
      return {host, ::getpid()};
    }



    Holder
    read_holder(const Descriptor &file)
    {
      std::string text(512, ' ');
      text.resize(file.read(0, text.data(), text.size()));
      Holder             holder;
      std::istringstream in(text);
      in >> holder.host >> holder.process;
      return holder;
    }



    bool
    is_gone(const Holder &holder)
    {
      if (holder.process <= 0)
        return true;
      return holder.host == this_process().host &&
             ::kill(holder.process, 0) != 0 && errno == ESRCH;
    }



    /// Whether @p path is the file that was opened: the one that had it may
    /// have removed it meanwhile.
    bool
    is_same_file(const std::string &path, const int number)
    {
      struct stat by_name, by_number;
      return ::stat(path.c_str(), &by_name) == 0 &&
             ::fstat(number, &by_number) == 0 &&
             by_name.st_ino == by_number.st_ino &&
             by_name.st_dev == by_number.st_dev;
    }



    [[noreturn]] void
    refuse(const std::string &directory,
           const std::string &path,
           const Holder      &holder,
           const bool         is_certain)
    {
      throw dealii::ExcMessage(
        "Another run is writing into '" + directory + "': process " +
        std::to_string(holder.process) + " on " + holder.host +
        ". Wait for its end, or choose another directory with --output DIR." +
        (is_certain ? "" : " If that process is gone, delete '" + path + "'."));
    }
  } // namespace



  RunLock::RunLock(const std::string &directory)
    : directory(directory)
    , path(directory + "/lock")
  {
    while (file == nullptr)
      {
        auto opened =
          std::make_unique<Descriptor>(path, O_RDWR | O_CREAT, "write");
        if (::flock(opened->number(), LOCK_EX | LOCK_NB) != 0)
          {
            const bool   is_certain = errno == EWOULDBLOCK;
            const Holder holder     = read_holder(*opened);
            if (is_certain || !is_gone(holder))
              refuse(directory, path, holder, is_certain);
          }
        if (is_same_file(path, opened->number()))
          file = std::move(opened);
      }
    file->cut(0);
    const Holder      own = this_process();
    const std::string text =
      own.host + " " + std::to_string(own.process) + "\n";
    file->write(bytes_of(text));
  }



  RunLock::~RunLock()
  {
    if (is_same_file(path, file->number()))
      ::unlink(path.c_str());
  }



  void
  RunLock::expect_directory() const
  {
    AssertThrow(is_same_file(path, file->number()),
                dealii::ExcMessage("The output directory '" + directory +
                                   "' was removed or moved while the run was "
                                   "writing into it: '" +
                                   path + "' is not there any more."));
  }
} // namespace Thalweg
