// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_offers_h
#define thalweg_core_offers_h

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Thalweg
{
  /// What a part of a run needs of another one, see Ports.
  struct Need
  {
    std::string part; ///< its name; empty: of any
    std::string thing;
  };

  /**
   * @brief What the parts of a run will offer each other, see Ports, as it is
   * known before there is anything.
   */
  class Offers
  {
  public:
    void
    add(const std::string &part, const std::string &thing)
    {
      things[part].insert(thing);
    }

    /// Whether a part offers a thing. @param part empty: any
    bool
    has(const std::string &part, const std::string &thing) const;

    /// @throws dealii::ExcMessage if nobody offers what is needed, with what
    ///   is offered instead
    /// @param who needs it, for the message: "'Couplings/drag'"
    void
    check(const Need &need, const std::string &who) const;

  private:
    /// "'a' offers 'streamlines', 'b' offers nothing"
    std::string
    inventory() const;

    std::map<std::string, std::set<std::string>> things;
  };
} // namespace Thalweg

#endif
