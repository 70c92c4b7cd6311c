#include <thalweg/core/growing_file.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>

namespace Thalweg
{
  namespace
  {
    bool
    begins_with(const std::string &path, const std::string &header)
    {
      std::ifstream file(path, std::ios::binary);
      std::string   text(header.size(), ' ');
      file.read(text.data(), text.size());
      return file && text == header;
    }


    void
    expect(const bool is_well, const std::string &path)
    {
      AssertThrow(is_well,
                  dealii::ExcMessage("Cannot write to '" + path +
                                     "'. Does the directory exist, may you "
                                     "write there, and is the disk full?"));
    }
  } // namespace



  void
  GrowingFile::create(const std::string &path, const std::string &header)
  {
    this->path = path;
    file.close();
    file.clear();
    file.open(path, std::ios::binary | std::ios::trunc);
    expect(bool(file), path);
    size = 0;
    append(header);
  }



  std::string
  GrowingFile::reopen(const std::string  &path,
                      const std::string  &header,
                      const std::uint64_t length)
  {
    std::error_code error;
    const bool      is_there = std::filesystem::exists(path, error);
    const bool      is_long_enough =
      is_there && std::filesystem::file_size(path, error) >= length && !error;
    if (is_long_enough && begins_with(path, header))
      {
        std::filesystem::resize_file(path, length, error);
        file.close();
        file.clear();
        file.open(path, std::ios::binary | std::ios::app);
        expect(!error && file, path);
        this->path = path;
        size       = length;
        return "";
      }
    if (is_there)
      std::filesystem::rename(path, path + ".old", error);
    create(path, header);
    if (!is_there)
      return "The file '" + path +
             "' that the run had written is missing; it begins anew.";
    return "The file '" + path + "' " +
           (is_long_enough ? "has other columns" : "is shorter") +
           " than when the checkpoint was written; it begins anew, and what "
           "it was is now '" +
           path + ".old'.";
  }



  void
  GrowingFile::append(const std::string &text)
  {
    file << text;
    expect(bool(file.flush()), path);
    size += text.size();
  }
} // namespace Thalweg
