// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_descriptor_h
#define thalweg_core_descriptor_h

#include <thalweg/core/files.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief An open file of the system, which is closed at the end. Every
   * function throws a dealii::ExcMessage with the file and the system's
   * reason when it fails: streams do not say why, and some not even that.
   */
  class Descriptor
  {
  public:
    /// Opens a file. @param flags as for open()
    /// @param what is going to be done with it, for messages: "write"
    Descriptor(const std::string &path,
               const int          flags,
               const std::string &what);

    Descriptor(const Descriptor &) = delete;

    ~Descriptor();

    /// Closes the file: some file systems report only then that it is not on
    /// the disk.
    void
    close();

    /// Writes all of it.
    void
    write(const ByteView &piece) const;

    /// @return how much there was, which is less at the file's end
    std::size_t
    read(const std::uint64_t offset, char *next, const std::size_t size) const;

    /// Cuts what stands behind @p size bytes.
    void
    cut(const std::uint64_t size) const;

    /// Has it written to the disk.
    void
    sync() const;

    std::uint64_t
    size() const;

    /// That the file has a name yet: others may have removed it.
    void
    expect_name() const;

    /// The number that the system knows it by.
    int
    number() const
    {
      return number_;
    }

  private:
    const std::string path;
    const std::string what;
    int               number_;
  };
} // namespace Thalweg

#endif
