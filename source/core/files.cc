// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/descriptor.h>
#include <thalweg/core/files.h>

#include <deal.II/base/exceptions.h>

#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace Thalweg
{
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void
    fail(const std::string &what, const std::string &path, const int error)
    {
      throw dealii::ExcMessage(file_failure(what, path, error));
    }



    void
    write_temporary(const std::string           &path,
                    const std::vector<ByteView> &pieces,
                    const Durability             durability)
    {
      Descriptor    file(path, O_WRONLY | O_CREAT | O_TRUNC, "write");
      std::uint64_t size = 0;
      for (const ByteView &piece : pieces)
        {
          file.write(piece);
          size += piece.size;
        }
      if (durability == Durability::on_disk)
        file.sync();
      AssertThrow(file.size() == size,
                  dealii::ExcMessage("Cannot write '" + path + "': it has " +
                                     std::to_string(file.size()) +
                                     " bytes instead of " +
                                     std::to_string(size) + "."));
      file.close();
    }
  } // namespace



  std::string
  file_failure(const std::string &what,
               const std::string &path,
               const int          error)
  {
    std::string advice;
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
      advice = " Make room, or choose another place with --output DIR.";
    else if (error == EACCES || error == EPERM || error == EROFS)
      advice = " Choose another place with --output DIR.";
    else if (error == ENOENT && what != "read")
      advice = " Was its directory removed or moved?";
    return "Cannot " + what + " '" + path + "': " + std::strerror(error) + "." +
           advice;
  }



  std::uint32_t
  checksum_of(const std::vector<ByteView> &pieces)
  {
    boost::crc_32_type crc;
    for (const ByteView &piece : pieces)
      crc.process_bytes(piece.data, piece.size);
    return crc.checksum();
  }



  void
  write_file(const std::string           &path,
             const std::vector<ByteView> &pieces,
             const Durability             durability)
  {
    const std::string temporary = path + ".part";
    try
      {
        write_temporary(temporary, pieces, durability);
        rename_file(temporary, path);
      }
    catch (...)
      {
        // Half a file would keep the room that the next one needs.
        ::unlink(temporary.c_str());
        throw;
      }
  }



  void
  write_file(const std::string &path,
             const std::string &content,
             const Durability   durability)
  {
    write_file(path, {bytes_of(content)}, durability);
  }



  std::string
  read_file(const std::string &path)
  {
    const Descriptor file(path, O_RDONLY, "read");
    std::string      content;
    std::string      buffer(1 << 16, ' ');
    while (const std::size_t n =
             file.read(content.size(), buffer.data(), buffer.size()))
      content.append(buffer, 0, n);
    return content;
  }



  void
  read_range(const std::string  &path,
             const std::uint64_t offset,
             void               *data,
             const std::size_t   size)
  {
    const Descriptor file(path, O_RDONLY, "read");
    AssertThrow(file.read(offset, static_cast<char *>(data), size) == size,
                dealii::ExcMessage("Cannot read '" + path +
                                   "': it is shorter than it was."));
  }



  std::uint32_t
  checksum_of_file(const std::string &path)
  {
    const Descriptor   file(path, O_RDONLY, "read");
    boost::crc_32_type crc;
    std::uint64_t      offset = 0;
    std::string        buffer(1 << 20, ' ');
    while (const std::size_t n =
             file.read(offset, buffer.data(), buffer.size()))
      {
        crc.process_bytes(buffer.data(), n);
        offset += n;
      }
    return crc.checksum();
  }



  void
  sync_directory(const std::string &path)
  {
    const Descriptor directory(path, O_RDONLY | O_DIRECTORY, "write");
    directory.sync();
  }



  void
  rename_file(const std::string &from, const std::string &to)
  {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
      fail("rename '" + from + "' to", to, error.value());
  }



  void
  make_directory(const std::string &path)
  {
    std::error_code error;
    fs::create_directory(path, error);
    if (error)
      fail("create the directory", path, error.value());
  }



  std::string
  move_aside(const std::string &path)
  {
    std::string     place = path + ".old";
    std::error_code error;
    for (unsigned int i = 2; fs::exists(fs::symlink_status(place, error)); ++i)
      place = path + ".old." + std::to_string(i);
    if (fs::exists(fs::symlink_status(path, error)))
      rename_file(path, place);
    return place;
  }
} // namespace Thalweg
