// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_cut_cell_h
#define thalweg_interface_cut_cell_h

#include <thalweg/materials/fluids.h>
#include <thalweg/mesh/cell_graph.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /// What the pressure has in cut cells besides the Q1 functions.
  enum class PressureEnrichment
  {
    none,
    gradient,     ///< a kink: N_j psi
    discontinuous ///< a jump: N_j (H - H_j)
  };

  /**
   * @brief The integrals of a cell that two fluids share.
   *
   * N are the Q1 shape functions, and the functions N_j psi enrich the pressure
   * (N. Moes et al., Comput. Methods Appl. Mech. Engrg. 192, 2003), with
   * psi = (sum_v N_v w_v - |phi_h|) / length, where w_v = |phi_v| at
   * independent nodes and the interpolated value of |phi| at hanging nodes.
   * Defined so, a pressure with a kink on a plane is represented exactly on
   * every mesh, a cell beside a cut hanging face has a psi too although the
   * interface does not pass through it, and psi is continuous: it vanishes
   * wherever there is no kink.
   *
   * Or, in place of N_j psi, the functions N_j (H - H_j), where H is 0 in fluid
   * 0 and 1 in fluid 1, and H_j its value at vertex j: with the N_j they are
   * all Q1 functions of both sides (Fig. 16b), and their gradients are those
   * on the sides. They are continuous from cell to cell where no node hangs.
   */
  template <int dim>
  struct CutCell
  {
    static constexpr unsigned int n_vertices = 1 << dim;
    template <typename T>
    using PerVertex = std::array<T, n_vertices>;

    unsigned int cell; ///< in the graph

    PerVertex<double>            mass;        ///< int rho N_i
    PerVertex<PerVertex<double>> mass_matrix; ///< int rho N_i N_j
    PerVertex<PerVertex<double>> laplace;     ///< int grad N_i . grad N_j / rho
    PerVertex<dealii::Tensor<1, dim>> gradient; ///< int grad N_i / rho

    bool enriched = false;
    /// [i][j]: int grad N_i . grad(N_j psi) / rho
    PerVertex<PerVertex<double>> laplace_star;
    /// [j][k]: int grad(N_j psi) . grad(N_k psi) / rho
    PerVertex<PerVertex<double>> laplace_star_star;
    /// [j][i]: int N_j psi grad N_i
    PerVertex<PerVertex<dealii::Tensor<1, dim>>> star_divergence;
    /// [i][j]: int N_i grad(N_j psi), on both sides of a jump
    PerVertex<PerVertex<dealii::Tensor<1, dim>>> star_gradient;
    /// [n_vertices * i + j]: int N_i N_j n over the interface; empty where
    /// there are no jumps
    std::vector<dealii::Tensor<1, dim>> star_jump;
    /// [n_vertices * i + j]: int grad N_i x grad N_j in fluid 1; likewise
    std::vector<dealii::Tensor<2, dim>> second_gradients;
    /// [j][k]: of laplace_star_star with what jumps move, for preconditioners
    PerVertex<PerVertex<double>> star_response;
    /// [j]: int (N_j psi)^2, and int N_j^2 psi
    PerVertex<double> star_mass, mixed_mass;
    /// [j]: int grad(N_j psi)
    PerVertex<dealii::Tensor<1, dim>> star_load;
    /// [j]: int grad(N_j psi) / rho
    PerVertex<dealii::Tensor<1, dim>> star_inverse_load;

    /// Of the denser fluid's part: int N_i, int grad N_i, and int grad(N_i psi)
    PerVertex<double>                 denser_measure;
    PerVertex<dealii::Tensor<1, dim>> denser_gradient;
    PerVertex<dealii::Tensor<1, dim>> denser_star_load;

    /// The unit normal of the interface, pointing to fluid 1, and the
    /// viscosities of a laminate: the arithmetic mean, and the harmonic one
    /// for shear across the interface.
    dealii::Tensor<1, dim> normal;
    double                 arithmetic_viscosity;
    double                 harmonic_viscosity;
    double                 negative_fraction;
  };

  /**
   * @brief Integrates a cut cell.
   * @param index its number in the graph
   * @param cell its geometry
   * @param phi level set at the vertices, not all of one sign or equal w
   * @param w what sum N_v w_v - |phi| subtracts from, see CutCell
   * @param length of psi, the same for all cells
   * @param fluids densities and viscosities
   * @param enrichment to fill; it stays off too where its functions are too
   *   small to matter
   */
  template <int dim>
  CutCell<dim>
  integrate_cut_cell(const unsigned int                    index,
                     const typename CellGraph<dim>::Cell  &cell,
                     const std::array<double, (1 << dim)> &phi,
                     const std::array<double, (1 << dim)> &w,
                     const double                          length,
                     const Fluids                         &fluids,
                     const PressureEnrichment              enrichment);

  /// The volume of the part of a cell where the level set with the values
  /// @p phi at the vertices is negative.
  template <int dim>
  double
  negative_volume(const typename CellGraph<dim>::Cell  &cell,
                  const std::array<double, (1 << dim)> &phi);
} // namespace Thalweg

#endif
