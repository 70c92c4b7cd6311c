// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/surface_chain.h>
#include <thalweg/postprocess/surface_samples.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    std::array<double, dim>
    plain(const dealii::Tensor<1, dim> &tensor)
    {
      std::array<double, dim> numbers;
      for (unsigned int d = 0; d < dim; ++d)
        numbers[d] = tensor[d];
      return numbers;
    }


    template <int dim>
    SurfaceSample<dim>
    make_sample(const SurfacePoint<dim> &point)
    {
      const dealii::Tensor<1, dim> shear =
        point.traction - (point.traction * point.normal) * point.normal;
      SurfaceSample<dim> sample{};
      sample.position = plain<dim>(point.position);
      sample.normal   = plain<dim>(point.normal);
      sample.shear    = plain<dim>(shear);
      sample.pressure = point.pressure;
      return sample;
    }


    /// The component along the tangent that has the fluid on its left.
    double
    along(const std::array<double, 2> &normal,
          const std::array<double, 2> &vector)
    {
      return -normal[1] * vector[0] + normal[0] * vector[1];
    }


    /// Lets a face and its samples run along that tangent.
    void
    orient(FaceSamples<2> &face)
    {
      if (along(face.samples[0].normal,
                {{face.end[0] - face.begin[0], face.end[1] - face.begin[1]}}) <
          0.)
        std::swap(face.begin, face.end);
      const auto distance = [&](const SurfaceSample<2> &sample) {
        return std::hypot(sample.position[0] - face.begin[0],
                          sample.position[1] - face.begin[1]);
      };
      if (face.n_samples == 2 &&
          distance(face.samples[0]) > distance(face.samples[1]))
        std::swap(face.samples[0], face.samples[1]);
    }


    /// Appends a face's samples, @p length behind the chain's beginning.
    void
    append(const FaceSamples<2>    &face,
           const unsigned int       chain_number,
           const double             length,
           std::vector<LineSample> &line)
    {
      // The abscissas of the formulas of Gauss with one and two points.
      const double offset = face.n_samples == 2 ? .5 / std::sqrt(3.) : 0.;
      for (unsigned int q = 0; q < face.n_samples; ++q)
        {
          const auto &sample = face.samples[q];
          line.push_back(
            {{face.boundary,
              chain_number,
              length + face.measure * (.5 + (q == 0 ? -offset : offset)),
              along(sample.normal, sample.shear),
              along(sample.normal, sample.mean_shear)},
             sample});
        }
    }
  } // namespace


  template <int dim>
  std::vector<FaceSamples<dim>>
  sample_surface(
    const FlowFields<dim>                                    &flow,
    const std::map<dealii::types::boundary_id, unsigned int> &numbers)
  {
    std::set<dealii::types::boundary_id> ids;
    for (const auto &[id, number] : numbers)
      ids.insert(id);
    std::vector<FaceSamples<dim>> faces;
    visit_surface<dim>(flow,
                       ids,
                       std::min(flow.velocity_dofs.get_fe().degree, 2u),
                       [&](const auto &face,
                           const auto  id,
                           const auto &points) {
                         FaceSamples<dim> samples{};
                         samples.boundary  = numbers.at(id);
                         samples.n_samples = points.size();
                         samples.begin     = plain<dim>(face->vertex(0));
                         samples.end       = plain<dim>(face->vertex(1));
                         for (unsigned int q = 0; q < points.size(); ++q)
                           {
                             samples.samples[q] = make_sample<dim>(points[q]);
                             samples.measure += points[q].weight;
                           }
                         faces.push_back(samples);
                       });
    return faces;
  }


  std::vector<LineSample>
  order_along_lines(std::vector<FaceSamples<2>> faces)
  {
    std::map<unsigned int, std::vector<std::size_t>> of_boundary;
    for (std::size_t f = 0; f < faces.size(); ++f)
      {
        orient(faces[f]);
        of_boundary[faces[f].boundary].push_back(f);
      }
    std::vector<LineSample> line;
    for (const auto &[boundary, members] : of_boundary)
      {
        std::vector<Segment> segments;
        for (const std::size_t f : members)
          segments.push_back({{faces[f].begin[0], faces[f].begin[1]},
                              {faces[f].end[0], faces[f].end[1]}});
        const auto chains = chain(segments);
        for (unsigned int c = 0; c < chains.size(); ++c)
          {
            double length = 0.;
            for (const std::size_t s : chains[c])
              {
                append(faces[members[s]], c, length, line);
                length += faces[members[s]].measure;
              }
          }
      }
    return line;
  }


  std::vector<ZeroShear>
  find_zero_shear(const std::vector<LineSample> &samples, const bool mean)
  {
    std::vector<ZeroShear> zeros;
    for (std::size_t s = 1; s < samples.size(); ++s)
      {
        const auto  &left = samples[s - 1], &right = samples[s];
        const double before = mean ? left.place.mean_shear : left.place.shear;
        const double behind = mean ? right.place.mean_shear : right.place.shear;
        if (left.place.boundary != right.place.boundary ||
            left.place.chain != right.place.chain || !(before * behind < 0.))
          continue;
        const double part    = before / (before - behind);
        const auto   between = [&](const double a, const double b) {
          return a + part * (b - a);
        };
        zeros.push_back(
          {left.place.boundary,
           left.place.chain,
           between(left.place.arc_length, right.place.arc_length),
           {between(left.sample.position[0], right.sample.position[0]),
            between(left.sample.position[1], right.sample.position[1])},
           behind > 0. ? 1. : -1.});
      }
    return zeros;
  }


  template std::vector<FaceSamples<2>>
  sample_surface(const FlowFields<2> &,
                 const std::map<dealii::types::boundary_id, unsigned int> &);
  template std::vector<FaceSamples<3>>
  sample_surface(const FlowFields<3> &,
                 const std::map<dealii::types::boundary_id, unsigned int> &);
} // namespace Thalweg
