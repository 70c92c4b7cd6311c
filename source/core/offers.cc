// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/offers.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  bool
  Offers::has(const std::string &part, const std::string &thing) const
  {
    for (const auto &[name, offered] : things)
      if ((part.empty() || part == name) && offered.count(thing) > 0)
        return true;
    return false;
  }



  void
  Offers::check(const Need &need, const std::string &who) const
  {
    AssertThrow(has(need.part, need.thing),
                dealii::ExcMessage(who + " needs '" + need.thing + "' of " +
                                   (need.part.empty() ? "another method"
                                                      : "'" + need.part + "'") +
                                   ", but " + inventory() + "."));
  }



  std::string
  Offers::inventory() const
  {
    std::string all;
    for (const auto &[name, offered] : things)
      {
        std::string list;
        for (const std::string &thing : offered)
          list += (list.empty() ? "'" : ", '") + thing + "'";
        all += (all.empty() ? "" : "; ") +
               (name.empty() ? "what there is:" : "'" + name + "' offers") +
               " " + list;
      }
    return all.empty() ? "no method offers anything" : all;
  }
} // namespace Thalweg
