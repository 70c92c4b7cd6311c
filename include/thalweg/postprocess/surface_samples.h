// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_surface_samples_h
#define thalweg_postprocess_surface_samples_h

#include <thalweg/postprocess/surface.h>

#include <array>
#include <map>
#include <vector>

namespace Thalweg
{
  /// Pressure and wall shear stress at a point; plain memory.
  template <int dim>
  struct SurfaceSample
  {
    std::array<double, dim> position;
    std::array<double, dim> normal; ///< out of the fluid
    std::array<double, dim> shear;  ///< Pa, the fluid's on the wall
    std::array<double, dim> mean_shear;
    double                  pressure; ///< Pa
    double                  mean_pressure;
  };

  /// The samples on a face, one or two in each direction; plain memory.
  template <int dim>
  struct FaceSamples
  {
    unsigned int            boundary; ///< its number in the user's list
    unsigned int            n_samples;
    std::array<double, dim> begin, end; ///< the first two vertices
    double                  measure;
    std::array<SurfaceSample<dim>, (1 << (dim - 1))> samples;
  };

  /**
   * @brief Samples the flow on the faces of locally owned cells at
   * boundaries, always in the same order.
   *
   * The points are those of a Gauss formula with as many points as the
   * velocity's degree (at most two), where gradients are most accurate.
   * @param numbers the boundaries' ids and their numbers
   */
  template <int dim>
  std::vector<FaceSamples<dim>>
  sample_surface(
    const FlowFields<dim>                                    &flow,
    const std::map<dealii::types::boundary_id, unsigned int> &numbers);

  /// A sample's place along the boundary, and what is signed along it.
  struct LinePlace
  {
    unsigned int boundary;
    unsigned int chain; ///< its number within the boundary
    double       arc_length;
    double       shear; ///< Pa
    double       mean_shear;
  };

  /// A sample in its place.
  struct LineSample
  {
    LinePlace        place;
    SurfaceSample<2> sample;
  };

  /**
   * @brief Brings samples in the order along each boundary, in the direction
   * that has the fluid on its left, along which wall shear is positive.
   */
  std::vector<LineSample>
  order_along_lines(std::vector<FaceSamples<2>> faces);

  /// Where the wall shear changes its sign.
  struct ZeroShear
  {
    unsigned int     boundary;
    unsigned int     chain;
    double           arc_length;
    dealii::Point<2> position;
    double           sign_behind;
  };

  /// The zeros by linear interpolation between samples.
  /// @param mean of the averaged wall shear stress instead
  std::vector<ZeroShear>
  find_zero_shear(const std::vector<LineSample> &samples, const bool mean);
} // namespace Thalweg

#endif
