// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_bytes_h
#define thalweg_core_bytes_h

#include <deal.II/base/exceptions.h>

#include <cstddef>
#include <cstring>
#include <vector>

namespace Thalweg
{
  /// Appends a plain value to @p bytes.
  template <typename T>
  void
  append_plain(std::vector<char> &bytes, const T &value)
  {
    const char *first = reinterpret_cast<const char *>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
  }

  /// Reads what append_plain() wrote, one value behind the other.
  class PlainReader
  {
  public:
    PlainReader(const char *begin, const std::size_t size)
      : position(begin)
      , end(begin + size)
    {}

    /// @throws dealii::ExcMessage if there is not so much left
    template <typename T>
    void
    read(T &value)
    {
      AssertThrow(sizeof(T) <= left(),
                  dealii::ExcMessage("its cells are cut short"));
      std::memcpy(&value, position, sizeof(T));
      position += sizeof(T);
    }

    /// How many bytes come yet.
    std::size_t
    left() const
    {
      return end - position;
    }

  private:
    const char       *position;
    const char *const end;
  };
} // namespace Thalweg

#endif
