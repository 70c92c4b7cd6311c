// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_growing_file_h
#define thalweg_core_growing_file_h

#include <thalweg/core/descriptor.h>

#include <cstdint>
#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief A text file that begins with a header and grows, and that a
   * resumed run cuts to what it was.
   *
   * What was appended is on the disk when append() returns. Belongs to one
   * process.
   */
  class GrowingFile
  {
  public:
    /// Empties or creates the file. @param header may be empty
    /// @throws dealii::ExcMessage if it cannot be written
    void
    create(const std::string &path, const std::string &header);

    /**
     * @brief Opens the file again and takes off all that stands behind
     * @p length bytes.
     *
     * If it does not begin with @p header or is shorter, it is moved aside
     * (see move_aside()), and a new one is created.
     * @return what the user is to be told; empty: all is as it was
     * @throws dealii::ExcMessage if it cannot be written
     */
    std::string
    reopen(const std::string  &path,
           const std::string  &header,
           const std::uint64_t length);

    /**
     * @brief Creates the file in a run that goes on and does not know it; one
     * that is there is moved aside.
     * @return what the user is to be told; empty: nothing was there
     * @throws dealii::ExcMessage if it cannot be written
     */
    std::string
    begin_anew(const std::string &path, const std::string &header);

    /// All of @p text or nothing of it.
    /// @throws dealii::ExcMessage if the disk is full or the file was removed
    void
    append(const std::string &text);

    bool
    is_open() const
    {
      return file != nullptr;
    }

    /// In bytes.
    std::uint64_t
    length() const
    {
      return size;
    }

  private:
    std::string                 path;
    std::unique_ptr<Descriptor> file;
    std::uint64_t               size = 0;
  };
} // namespace Thalweg

#endif
