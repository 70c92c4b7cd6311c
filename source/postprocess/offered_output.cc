// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/offered_output.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Thalweg
{
  void
  check_offered(const Offers      &offers,
                const std::string &thing,
                const std::string &model,
                const std::string &example)
  {
    AssertThrow(offers.has("", thing),
                dealii::ExcMessage("No method of this run has " + thing +
                                   ". Take '" + model +
                                   "' out of 'Postprocess/Models', or add a "
                                   "method to 'Methods/Names': '" +
                                   example + "'."));
  }



  std::string
  file_name_of(const std::string &method, const std::string &thing)
  {
    std::string name = method.empty() ? thing : method;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  }
} // namespace Thalweg
