// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_archive_h
#define thalweg_core_archive_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Named values that a run must know to go on, and that are the same
   * on all processes: written into a checkpoint, or found there again.
   *
   * One function of a part names its values once, for both directions:
   *
   * @code
   * void Schedule::keep(Archive archive)
   * {
   *   archive.value("next", next);
   * }
   * @endcode
   *
   * Numbers keep all their bits, not-a-number and infinity included. Copies
   * share what they hold.
   */
  class Archive
  {
  public:
    /// An archive to be written; empty at first.
    Archive();

    /// An archive to be read, from what bytes() returned.
    /// @throws dealii::ExcMessage if @p bytes are none
    static Archive
    restore(const std::string &bytes);

    /// The same values, to be read.
    Archive
    reader() const;

    /// An archive that neither takes nor gives: values stay as they are.
    static Archive
    nowhere();

    /// Whether value() changes its argument.
    bool
    is_restoring() const
    {
      return mode == Mode::read;
    }

    /// Whether an archive that is read has something of this name.
    bool
    has(const std::string &name) const;

    /// A part of this one for values of their own.
    /// @throws dealii::ExcMessage if it is not there to be read
    Archive
    enter(const std::string &name) const;

    /// Stores @p value, or sets it to what was stored.
    /// @tparam T bool, int, unsigned int, std::uint64_t, double, std::string,
    ///   or std::vector of one of the last four
    /// @throws dealii::ExcMessage if it is not there to be read
    template <typename T>
    void
    value(const std::string &name, T &value) const;

    /// What was stored, to be kept in a file.
    std::string
    bytes() const;

  private:
    enum class Mode
    {
      write,
      read,
      nowhere
    };
    struct Tree;

    Mode                  mode = Mode::write;
    std::shared_ptr<Tree> tree;
    /// Path in the tree, for messages and look-ups.
    std::string path;
  };
} // namespace Thalweg

#endif
