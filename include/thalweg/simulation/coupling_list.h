// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_coupling_list_h
#define thalweg_simulation_coupling_list_h

#include <thalweg/core/instances.h>
#include <thalweg/core/offers.h>
#include <thalweg/core/parameter_file.h>
#include <thalweg/coupling/coupling.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The couplings of a run: those of "Couplings/Names", each with a
   * section of its name.
   *
   * Its functions are those of Coupling, for all of them.
   */
  template <int dim>
  class CouplingList
  {
  public:
    struct Entry
    {
      std::string              name;
      Coupling<dim>           *coupling;
      std::vector<std::string> between; ///< names of methods
    };

    /// Declares the section "Couplings", and makes the couplings of @p input.
    /// @throws dealii::ExcMessage for names that cannot be
    void
    declare(const Section &root, const ParameterFile &input);

    /// @param methods the names of those that there are
    void
    check(const std::vector<std::string> &methods,
          std::vector<std::string>       &faults) const;

    /// That the methods offer what the couplings need.
    void
    check_needs(const std::vector<std::string> &methods,
                const Offers                   &offers,
                std::vector<std::string>       &faults) const;

    /// @param ports what the methods offer
    void
    create(Context         &context,
           Mesh<dim>       &mesh,
           BodyForces<dim> &forces,
           Ports           &ports);

    void
    release();

    void
    attach();

    void
    initialize();

    void
    keep(const State<dim> &state);

    void
    update();

    /// The largest change of all.
    double
    change() const;

    std::vector<std::string>
    columns() const;

    void
    record(const double time);

    std::vector<Entry>
    used() const;

  private:
    Instances<Coupling<dim>> named;
    std::string              names; ///< as they are declared
    /// Of each, by its name.
    std::map<std::string, std::vector<std::string>> between;
    Context                                        *context = nullptr;
    /// One of each model, for the reference.
    std::vector<std::unique_ptr<Coupling<dim>>> shown;
  };
} // namespace Thalweg

#endif
