// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_files_h
#define thalweg_core_files_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /// A piece of memory that somebody else owns.
  struct ByteView
  {
    const void *data = nullptr;
    std::size_t size = 0; ///< in bytes
  };

  template <typename Container>
  ByteView
  bytes_of(const Container &container)
  {
    return {container.data(),
            container.size() * sizeof(typename Container::value_type)};
  }

  /// The checksum (CRC-32) of pieces that stand one behind the other.
  std::uint32_t
  checksum_of(const std::vector<ByteView> &pieces);

  /// What to do when a file is to be whole: only that, or also that it
  /// survives when the machine fails.
  enum class Durability
  {
    whole,
    on_disk
  };

  /**
   * @brief Writes @p content to @p path so that the file is there completely
   * or not at all, whatever happens meanwhile.
   * @throws dealii::ExcMessage with the file and the system's reason if it
   *   cannot be written; what was there before is still there
   */
  void
  write_file(const std::string &path,
             const std::string &content,
             const Durability   durability = Durability::whole);

  /// The same for pieces of memory that stand one behind the other.
  void
  write_file(const std::string           &path,
             const std::vector<ByteView> &pieces,
             const Durability             durability);

  /**
   * @brief The content of the file @p path.
   * @throws dealii::ExcMessage if it cannot be read to its end
   */
  std::string
  read_file(const std::string &path);

  /// The @p size bytes that begin at @p offset of the file @p path.
  /// @throws dealii::ExcMessage if it cannot be read or is shorter
  void
  read_range(const std::string  &path,
             const std::uint64_t offset,
             void               *data,
             const std::size_t   size);

  /// The checksum of a file. @throws dealii::ExcMessage if it cannot be read
  std::uint32_t
  checksum_of_file(const std::string &path);

  /// Has the names in the directory @p path written to the disk.
  /// @throws dealii::ExcMessage if that fails
  void
  sync_directory(const std::string &path);

  /// Gives a file or directory another name.
  /// @throws dealii::ExcMessage with both names and the system's reason
  void
  rename_file(const std::string &from, const std::string &to);

  /// Creates the directory @p path if it is not there; its parent must be.
  /// @throws dealii::ExcMessage with the system's reason
  void
  make_directory(const std::string &path);

  /// Moves what is called @p path, if anything is, to a name with the ending
  /// `.old`, `.old.2` and so on that nothing has. @return the new name
  std::string
  move_aside(const std::string &path);

  /// The sentence for a call of the system that has failed with @p error:
  /// "Cannot write 'x': No space left on device. ..." with what to do about
  /// it. @param what "write", for example
  std::string
  file_failure(const std::string &what,
               const std::string &path,
               const int          error);
} // namespace Thalweg

#endif
