// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_ports_h
#define thalweg_core_ports_h

#include <deal.II/base/exceptions.h>

#include <any>
#include <map>
#include <string>

namespace Thalweg
{
  /**
   * @brief What the parts of a run offer each other, by the name of the part
   * and of the thing: `get<const VelocityPort<dim>>("water", "velocity")`.
   *
   * Whoever offers says so anew whenever the things are made anew; whoever
   * uses them asks each time.
   */
  class Ports
  {
  public:
    /// Offers an object under two names; what was there before under these is
    /// forgotten. It must outlive its use.
    template <typename T>
    void
    offer(const std::string &part, const std::string &thing, T &object)
    {
      offers[part][thing] = &object;
    }

    /**
     * @brief What a part offers.
     * @param part empty: the first, in the order of their names, that offers
     *   such a thing
     * @param who asks, for the message: "'Methods/dye'"
     * @throws dealii::ExcMessage that says what there is
     */
    template <typename T>
    T &
    get(const std::string &part,
        const std::string &thing,
        const std::string &who) const
    {
      for (const auto &[name, things] : offers)
        if (part.empty() || part == name)
          if (const auto found = things.find(thing); found != things.end())
            if (T *const *object = std::any_cast<T *>(&found->second))
              return **object;
      throw dealii::ExcMessage(who + " needs '" + thing + "'" +
                               (part.empty() ? "" : " of '" + part + "'") +
                               "; " + inventory() + ".");
    }

    /// All that are offered under the name @p thing, by the names of the
    /// parts.
    template <typename T>
    std::map<std::string, T *>
    all(const std::string &thing) const
    {
      std::map<std::string, T *> found;
      for (const auto &[part, things] : offers)
        if (const auto offer = things.find(thing); offer != things.end())
          if (T *const *object = std::any_cast<T *>(&offer->second))
            found[part] = *object;
      return found;
    }

  private:
    /// "there is nothing yet", or a list of all.
    std::string
    inventory() const;

    std::map<std::string, std::map<std::string, std::any>> offers;
  };
} // namespace Thalweg

#endif
