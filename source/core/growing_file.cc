// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/growing_file.h>

#include <deal.II/base/exceptions.h>

#include <fcntl.h>
#include <filesystem>

namespace Thalweg
{
  namespace
  {
    bool
    begins_with(const Descriptor &file, const std::string &header)
    {
      std::string text(header.size(), ' ');
      return file.read(0, text.data(), text.size()) == text.size() &&
             text == header;
    }
  } // namespace



  void
  GrowingFile::create(const std::string &path, const std::string &header)
  {
    this->path = path;
    file       = std::make_unique<Descriptor>(path,
                                        O_WRONLY | O_CREAT | O_TRUNC | O_APPEND,
                                        "write");
    size       = 0;
    append(header);
  }



  std::string
  GrowingFile::reopen(const std::string  &path,
                      const std::string  &header,
                      const std::uint64_t length)
  {
    std::error_code error;
    file.reset();
    if (!std::filesystem::exists(path, error))
      {
        create(path, header);
        return "The file '" + path +
               "' that the run had written is missing; it begins anew.";
      }
    auto old = std::make_unique<Descriptor>(path, O_RDWR | O_APPEND, "write");
    const bool is_long_enough = old->size() >= length;
    if (is_long_enough && begins_with(*old, header))
      {
        old->cut(length);
        file       = std::move(old);
        this->path = path;
        size       = length;
        return "";
      }
    const std::string aside = move_aside(path);
    create(path, header);
    return "The file '" + path + "' " +
           (is_long_enough ? "has other columns" : "is shorter") +
           " than when the checkpoint was written; it begins anew, and what "
           "it was is now '" +
           aside + "'.";
  }



  std::string
  GrowingFile::begin_anew(const std::string &path, const std::string &header)
  {
    std::error_code   error;
    const bool        is_there = std::filesystem::exists(path, error);
    const std::string aside    = is_there ? move_aside(path) : "";
    create(path, header);
    return is_there
             ? "The checkpoint does not know the file '" + path +
                 "': it begins anew, and what it was is now '" + aside + "'."
             : "";
  }



  void
  GrowingFile::append(const std::string &text)
  {
    file->expect_name();
    try
      {
        file->write(bytes_of(text));
      }
    catch (const dealii::ExcMessage &)
      {
        // No half row: another run may go on from here.
        try
          {
            file->cut(size);
          }
        catch (const dealii::ExcMessage &)
          {
            // What failed first is what there is to say.
          }
        throw;
      }
    size += text.size();
  }
} // namespace Thalweg
