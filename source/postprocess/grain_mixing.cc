// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/grain_table.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Grains of a sample, and those of them of the given material.
    struct MixingSample
    {
      double all = 0., some = 0.;
    };



    /// P. M. C. Lacey's index (J. Appl. Chem. 4, 1954, p. 257): 0 of grains
    /// that are apart, 1 of those that are mixed at random. Samples count with
    /// the number of their grains.
    double
    lacey_index(const std::vector<MixingSample> &samples)
    {
      MixingSample sum;
      double       n_samples = 0.;
      for (const MixingSample &sample : samples)
        {
          sum.all += sample.all;
          sum.some += sample.some;
          n_samples += sample.all > 0.;
        }
      if (sum.all == 0.)
        return 0.;
      const double part     = sum.some / sum.all;
      double       variance = 0.;
      for (const MixingSample &sample : samples)
        if (sample.all > 0.)
          variance +=
            sample.all / sum.all * std::pow(sample.some / sample.all - part, 2);
      const double apart  = part * (1. - part);
      const double random = apart * n_samples / sum.all;
      return apart > random ? (apart - variance) / (apart - random) : 0.;
    }



    /// How well grains of one material are mixed with the others.
    template <int dim>
    class GrainMixing : public GrainRows<dim>
    {
    public:
      GrainMixing()
        : GrainRows<dim>("mixing")
      {}

      void
      declare_parameters(const Section &section) override
      {
        GrainRows<dim>::declare_parameters(section);
        section.add("Material",
                    material,
                    "",
                    "Whose grains are counted beside all; nothing: the first "
                    "material.",
                    dealii::Patterns::Anything());
        section.add("Width",
                    width,
                    "m",
                    "Of the cubes (squares) whose grains are a sample; 0: a "
                    "20th of the domain's largest side.",
                    dealii::Patterns::Double(0));
      }

    private:
      std::vector<std::string>
      columns(const GrainView &view) const override
      {
        material_of(view); // that it is there
        return {"time [s]", "Lacey's index", "part of the material"};
      }

      std::vector<double>
      row(const MPI_Comm   communicator,
          const Mesh<dim> &mesh,
          const GrainView &view) const override
      {
        const auto   samples = samples_of(communicator, mesh, view);
        MixingSample sum;
        for (const MixingSample &sample : samples)
          {
            sum.all += sample.all;
            sum.some += sample.some;
          }
        return {lacey_index(samples), sum.all > 0. ? sum.some / sum.all : 0.};
      }

      unsigned int
      material_of(const GrainView &view) const
      {
        return material.empty()
                 ? 0
                 : view.materials.find(material, "Postprocess/mixing/Material");
      }

      /// Of all ranks. Collective.
      std::vector<MixingSample>
      samples_of(const MPI_Comm   communicator,
                 const Mesh<dim> &mesh,
                 const GrainView &view) const
      {
        const auto &[low, high] = mesh.box();
        double largest          = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          largest = std::max(largest, high[d] - low[d]);
        const double               w = width > 0. ? width : largest / 20.;
        std::array<std::size_t, 3> n{{1, 1, 1}};
        for (unsigned int d = 0; d < dim; ++d)
          n[d] = 1 + std::floor((high[d] - low[d]) / w);
        AssertThrow(double(n[0]) * n[1] * n[2] < 1e7,
                    dealii::ExcMessage("'Postprocess/mixing/Width' makes more "
                                       "than ten million samples of the "
                                       "domain: give a larger one."));
        std::vector<double> counts(2 * n[0] * n[1] * n[2], 0.);
        const unsigned int  wanted = material_of(view);
        const GrainArrays  &grains = view.system.grains();
        for (const std::uint32_t i : view.system.own())
          {
            const Vec3  &x = grains.place[i].x;
            const double at[]{x.x, x.y, x.z};
            std::size_t  index = 0;
            for (unsigned int d = dim; d-- > 0;)
              index = index * n[d] +
                      static_cast<std::size_t>(
                        std::clamp((at[d] - low[d]) / w, 0., n[d] - 1.));
            counts[2 * index] += 1.;
            counts[2 * index + 1] += grains.material[i] == wanted;
          }
        dealii::Utilities::MPI::sum(counts, communicator, counts);
        std::vector<MixingSample> samples(counts.size() / 2);
        for (std::size_t k = 0; k < samples.size(); ++k)
          samples[k] = {counts[2 * k], counts[2 * k + 1]};
        return samples;
      }

      std::string material;
      double      width = 0.;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   GrainMixing,
                   "mixing",
                   "how well grains of one material are mixed with the others, "
                   "by the index of Lacey; writes METHOD_mixing.csv.")
} // namespace Thalweg
