// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_contact_list_h
#define thalweg_dem_contact_list_h

#include <thalweg/dem/contact.h>
#include <thalweg/dem/grain_cells.h>
#include <thalweg/dem/pair_loop.h>

namespace Thalweg
{
  /// A contact of a grain as it is kept while lists are made anew.
  struct ContactRecord
  {
    std::uint64_t partner; ///< its number
    ContactMemory memory;  ///< as seen from the grain
  };

  /// Contacts of some grains, one grain's behind the other's.
  struct ContactTable
  {
    std::vector<std::uint32_t> begin{0};
    std::vector<ContactRecord> contacts;
  };

  /**
   * @brief Pairs that touch or nearly do, with what they remember: pruned from
   * the list of neighbours every few steps, so that loops meet hardly any
   * others.
   */
  class ContactList
  {
  public:
    /// @param rolls whether rolling remembers something
    explicit ContactList(const bool rolls = false)
      : rolls(rolls)
    {}

    /// Keeps those of @p neighbours that are less than @p margin apart, and
    /// what those that touched remember.
    void
    prune(const PairList                &neighbours,
          const std::vector<GrainPlace> &place,
          const double                   margin);

    /// Forgets all pairs.
    void
    clear(const std::size_t n_grains);

    /// Gives pairs what a table has for their grains.
    /// @param row of each grain in the table, or -1
    void
    remember(const std::vector<std::uint64_t> &id,
             const std::vector<std::int32_t>  &row,
             const ContactTable               &table);

    /// All contacts, each with both of its grains if they are of this rank.
    void
    write(const std::vector<std::uint64_t> &id,
          const std::vector<std::uint8_t>  &own,
          ContactTable                     &table) const;

    std::vector<std::uint32_t> begin, partner;
    std::vector<std::uint8_t>  touching;
    std::vector<Vec3>          slip, roll; ///< zero where nothing touches
    std::vector<TouchingPair>  hits;       ///< room for the loop over pairs

  private:
    bool rolls;
    /// The next list while it is made.
    std::vector<std::uint32_t> new_begin, new_partner;
    std::vector<std::uint8_t>  new_touching;
    std::vector<Vec3>          new_slip, new_roll;
  };
} // namespace Thalweg

#endif
