// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_words_h
#define thalweg_mesh_geometries_words_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /// The words of a mesh file, one after another. Whatever is not as it has
    /// to be is refused with its line.
    class Words
    {
    public:
      /**
       * @param text of the file; must outlive this object
       * @param refusal the beginning of messages, as in "The mesh file 'a.msh'
       *   cannot be read"
       */
      Words(const std::string &text, const std::string &refusal);

      /// Whether no word is left.
      bool
      at_end();

      /// The next word. @param name what it should be
      std::string
      next(const std::string &name);

      /// What follows up to the end of the line. @param ends_it whether to go
      /// to the next one
      std::string
      rest_of_line(const bool ends_it = false);

      /// Goes on at a later place in the text.
      void
      skip_to(const std::size_t place);

      /// The next word, which is @p word.
      void
      expect(const std::string &word);

      /// Passes everything up to @p word, and that.
      void
      skip_behind(const std::string &word);

      /// A whole number from @p least to @p most.
      std::int64_t
      whole(const std::string &name,
            const std::int64_t least,
            const std::int64_t most);

      /// How many things follow: not more than the file has room for.
      /// @param words that each one has at least
      std::size_t
      count(const std::string &name, const unsigned int words = 1);

      /// A finite number.
      double
      number(const std::string &name);

      /// The line of the last word.
      unsigned int
      line() const
      {
        return line_number;
      }

      [[noreturn]] void
      refuse(const std::string &why) const;

    private:
      void
      skip_blanks();

      const std::string &text;
      const std::string  refusal;
      std::size_t        position    = 0;
      unsigned int       next_line   = 1;
      unsigned int       line_number = 1;
    };
  } // namespace Geometries
} // namespace Thalweg

#endif
