#ifndef thalweg_core_bytes_h
#define thalweg_core_bytes_h

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
    explicit PlainReader(const char *position)
      : position(position)
    {}

    template <typename T>
    void
    read(T &value)
    {
      std::memcpy(&value, position, sizeof(T));
      position += sizeof(T);
    }

    /// What comes next.
    const char *
    place() const
    {
      return position;
    }

  private:
    const char *position;
  };
} // namespace Thalweg

#endif
