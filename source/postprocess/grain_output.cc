// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/points.h>
#include <thalweg/methods/grain_view.h>
#include <thalweg/postprocess/offered_output.h>

namespace Thalweg
{
  namespace
  {
    /// Grains for ParaView.
    template <int dim>
    class GrainOutput : public PointOutput<dim, const GrainView>
    {
    public:
      GrainOutput()
        : PointOutput<dim, const GrainView>("grains", "sand: grains")
      {}

    private:
      PointPatches<dim>
      points(const GrainView &view, const double) const override
      {
        constexpr unsigned int   n_spins = dim == 3 ? 3 : 1;
        std::vector<std::string> names{"radius", "id", "material"};
        names.insert(names.end(), dim, "velocity");
        names.insert(names.end(), n_spins, "spin");
        const GrainArrays &grains = view.system.grains();
        const auto         own    = view.system.own();
        PointPatches<dim>  patches(names, own.size());
        for (std::size_t k = 0; k < own.size(); ++k)
          {
            const std::uint32_t  i = own[k];
            const GrainMomentum &p = grains.momentum[i];
            const double         v[]{p.v.x, p.v.y, p.v.z};
            const double         w[]{p.w.x, p.w.y, p.w.z};
            auto &numbers = patches.set(k, as_point<dim>(grains.place[i].x));
            numbers(0, 0) = grains.place[i].r;
            numbers(1, 0) = grains.id[i];
            numbers(2, 0) = grains.material[i];
            for (unsigned int d = 0; d < dim; ++d)
              numbers(3 + d, 0) = v[d];
            for (unsigned int d = 0; d < n_spins; ++d)
              numbers(3 + dim + d, 0) = w[3 - n_spins + d];
          }
        return patches;
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   GrainOutput,
                   "grains",
                   "grains with radius, velocity, spin, number and material, "
                   "for ParaView; writes METHOD.pvd.")
} // namespace Thalweg
