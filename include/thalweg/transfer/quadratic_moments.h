// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_quadratic_moments_h
#define thalweg_transfer_quadratic_moments_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Thalweg
{
  /**
   * @brief The monomials of dim variables up to the fourth degree, those of
   * lower degree first, and so that each follows from an earlier one: those up
   * to the second degree, and all that two of them can yield.
   */
  template <int dim>
  class Monomials
  {
  public:
    static constexpr unsigned int n_linear    = dim + 1;
    static constexpr unsigned int n_quadratic = (dim + 1) * (dim + 2) / 2;
    static constexpr unsigned int n           = dim == 2 ? 15 : 35; ///< of all

    static const Monomials &
    instance()
    {
      static const Monomials monomials;
      return monomials;
    }

    /// All of them at a point.
    std::array<double, n>
    values(const dealii::Tensor<1, dim> &x) const
    {
      std::array<double, n> value;
      value[0] = 1.;
      for (unsigned int k = 1; k < n; ++k)
        value[k] = value[lower[k]] * x[direction[k]];
      return value;
    }

    /// The number of the product of two up to the second degree.
    unsigned int
    product(const unsigned int i, const unsigned int j) const
    {
      return products[i][j];
    }

  private:
    using Exponents = std::array<unsigned int, dim>;

    Monomials();

    unsigned int
    find(const Exponents &exponents) const;

    std::array<Exponents, n>    exponents_of;
    std::array<unsigned int, n> lower, direction;
    std::array<std::array<unsigned int, n_quadratic>, n_quadratic> products;
  };



  /**
   * @brief What a fit of a polynomial of second degree to scattered values
   * needs of them: sums over the points around a node, each with its weight.
   */
  template <int dim>
  class QuadraticMoments
  {
  public:
    static constexpr unsigned int n_quadratic = Monomials<dim>::n_quadratic;
    static constexpr unsigned int n_monomials = Monomials<dim>::n;
    static constexpr unsigned int size        = n_monomials + n_quadratic + 2;

    /// Of monomials, of the first of them times the value, of its square; and
    /// of the squares of the weights.
    std::array<double, size> sums{};

    /// @param monomials of the offset from the node
    void
    add(const double                           weight,
        const std::array<double, n_monomials> &monomials,
        const double                           value)
    {
      for (unsigned int k = 0; k < n_monomials; ++k)
        sums[k] += weight * monomials[k];
      const double weighted = weight * value;
      for (unsigned int k = 0; k < n_quadratic; ++k)
        sums[n_monomials + k] += weighted * monomials[k];
      sums[size - 2] += weighted * value;
      sums[size - 1] += weight * weight;
    }

    /// How far the points' centre is from the node, in parts of their mean
    /// distance: 0 around it, up to 1 where they stand to one side.
    double
    one_sidedness() const;

    /// Of the weights.
    double
    weight() const
    {
      return sums[0];
    }

    /**
     * @brief The polynomial's value at the node. There must be a point.
     *
     * The degree is lower where the points, few or all to one side, do not
     * determine more: such a value makes the errors of single ones larger,
     * and if it goes back to them they grow from step to step.
     * @param misfit which part of the values' variance it does not explain,
     *   with regard to how many points there are: as many as unknowns always
     *   lie on a polynomial
     */
    double
    fit(double &misfit) const;

  private:
    /// @param largest_gain of the variance of single values
    template <unsigned int n>
    bool
    try_fit(const double largest_gain, double &value, double &misfit) const;
  };
} // namespace Thalweg

#endif
