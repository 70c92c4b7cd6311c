// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/descriptor.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Thalweg
{
  namespace
  {
    void
    expect(const bool is_well, const std::string &what, const std::string &path)
    {
      const int error = errno;
      AssertThrow(is_well, dealii::ExcMessage(file_failure(what, path, error)));
    }
  } // namespace



  Descriptor::Descriptor(const std::string &path,
                         const int          flags,
                         const std::string &what)
    : path(path)
    , what(what)
    , number_(::open(path.c_str(), flags | O_CLOEXEC, 0666))
  {
    expect(number_ >= 0, what, path);
  }



  Descriptor::~Descriptor()
  {
    if (number_ >= 0)
      ::close(number_);
  }



  void
  Descriptor::close()
  {
    const int closed = ::close(number_);
    number_          = -1;
    expect(closed == 0, what, path);
  }



  void
  Descriptor::write(const ByteView &piece) const
  {
    const char *next = static_cast<const char *>(piece.data);
    std::size_t left = piece.size;
    while (left > 0)
      {
        const ssize_t n = ::write(number_, next, left);
        if (n < 0 && errno == EINTR)
          continue;
        if (n == 0)
          errno = ENOSPC;
        expect(n > 0, what, path);
        next += n;
        left -= n;
      }
  }



  std::size_t
  Descriptor::read(const std::uint64_t offset,
                   char               *next,
                   const std::size_t   size) const
  {
    std::size_t done = 0;
    while (done < size)
      {
        const ssize_t n =
          ::pread(number_, next + done, size - done, offset + done);
        if (n < 0 && errno == EINTR)
          continue;
        expect(n >= 0, what, path);
        if (n == 0)
          break;
        done += n;
      }
    return done;
  }



  void
  Descriptor::cut(const std::uint64_t size) const
  {
    expect(::ftruncate(number_, size) == 0, what, path);
  }



  void
  Descriptor::sync() const
  {
    // Some file systems cannot, and say so.
    expect(::fsync(number_) == 0 || errno == EINVAL || errno == ENOTSUP,
           what,
           path);
  }



  std::uint64_t
  Descriptor::size() const
  {
    struct stat status;
    expect(::fstat(number_, &status) == 0, what, path);
    return status.st_size;
  }



  void
  Descriptor::expect_name() const
  {
    struct stat status;
    expect(::fstat(number_, &status) == 0, what, path);
    AssertThrow(status.st_nlink > 0,
                dealii::ExcMessage("The file '" + path +
                                   "' was removed while the run was writing "
                                   "to it."));
  }
} // namespace Thalweg
