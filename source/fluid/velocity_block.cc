// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/near_null_space.h>
#include <thalweg/fluid/velocity_block.h>
#include <thalweg/fluid/velocity_matrix.h>
#include <thalweg/linear_algebra/amg.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// A number of conjugate gradient steps with the diagonal, without a
    /// matrix: as many as diffusion goes cells in a time step.
    template <int dim>
    class JacobiVelocityBlock : public VelocityBlock<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      void
      initialize(const NodeSpace<dim> &,
                 const BoundaryNodes<dim> &,
                 const ViscousOperator<dim> &viscous) override
      {
        A = &viscous;
      }

      void
      update(const double fourier_number) override
      {
        n_steps = static_cast<unsigned int>(
          std::min(100., std::ceil(1. + 2. * std::sqrt(fourier_number))));
      }

      void
      vmult(Vector &destination, const Vector &source) const override
      {
        destination = 0.;
        dealii::IterationNumberControl control(n_steps, 0.);
        dealii::SolverCG<Vector>(control).solve(*A,
                                                destination,
                                                source,
                                                A->jacobi());
      }

    private:
      const ViscousOperator<dim> *A       = nullptr;
      unsigned int                n_steps = 1;
    };



    /// With a matrix.
    template <int dim>
    class MatrixVelocityBlock : public VelocityBlock<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      void
      initialize(const NodeSpace<dim>       &space_,
                 const BoundaryNodes<dim>   &boundary_,
                 const ViscousOperator<dim> &viscous_) override
      {
        space    = &space_;
        boundary = &boundary_;
        viscous  = &viscous_;
        matrix.reset();
      }

      void
      update(const double) override
      {
        if (!matrix)
          matrix =
            std::make_unique<VelocityMatrix<dim>>(*space, *boundary, *viscous);
        matrix->assemble();
        set_up(matrix->matrix());
      }

      void
      vmult(Vector &destination, const Vector &source) const override
      {
        apply(destination, source);
        boundary->project(destination);
      }

      unsigned int
      n_setups() const override
      {
        return setups;
      }

    protected:
      virtual void
      set_up(const dealii::TrilinosWrappers::SparseMatrix &A) = 0;

      virtual void
      apply(Vector &destination, const Vector &source) const = 0;

      const NodeSpace<dim>                *space    = nullptr;
      const BoundaryNodes<dim>            *boundary = nullptr;
      const ViscousOperator<dim>          *viscous  = nullptr;
      std::unique_ptr<VelocityMatrix<dim>> matrix;
      unsigned int                         setups = 0;
    };



    /// Algebraic multigrid with rigid motions as its near-null space.
    template <int dim>
    class AmgVelocityBlock : public MatrixVelocityBlock<dim>
    {
    private:
      void
      set_up(const dealii::TrilinosWrappers::SparseMatrix &A) override
      {
        amg.build(A,
                  AmgPreconditioner::Smoother::chebyshev,
                  {rigid_motions(*this->space), dim});
        ++this->setups;
      }

      void
      apply(Vector &destination, const Vector &source) const override
      {
        amg.vmult(destination, source);
      }

      AmgPreconditioner amg;
    };



    /// Incomplete factorization of each process's part.
    template <int dim>
    class IluVelocityBlock : public MatrixVelocityBlock<dim>
    {
    private:
      void
      set_up(const dealii::TrilinosWrappers::SparseMatrix &A) override
      {
        ilu.initialize(A);
        ++this->setups;
      }

      void
      apply(Vector &destination, const Vector &source) const override
      {
        ilu.vmult(destination, source);
      }

      dealii::TrilinosWrappers::PreconditionILU ilu;
    };



    /// A direct solver, for tests.
    template <int dim>
    class DirectVelocityBlock : public MatrixVelocityBlock<dim>
    {
    private:
      void
      set_up(const dealii::TrilinosWrappers::SparseMatrix &A) override
      {
        solver =
          std::make_unique<dealii::TrilinosWrappers::SolverDirect>(control);
        solver->initialize(A);
        ++this->setups;
      }

      void
      apply(Vector &destination, const Vector &source) const override
      {
        Vector load(source);
        solver->solve(destination, load);
      }

      dealii::SolverControl                                   control;
      std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> solver;
    };



    /// The diagonal where friction reaches a cell or two, else multigrid.
    template <int dim>
    class AutomaticVelocityBlock : public VelocityBlock<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      void
      initialize(const NodeSpace<dim>       &space,
                 const BoundaryNodes<dim>   &boundary,
                 const ViscousOperator<dim> &viscous) override
      {
        jacobi.initialize(space, boundary, viscous);
        amg.initialize(space, boundary, viscous);
      }

      void
      update(const double fourier_number) override
      {
        constexpr double largest_for_jacobi = 4.;
        chosen = fourier_number > largest_for_jacobi
                   ? static_cast<VelocityBlock<dim> *>(&amg)
                   : &jacobi;
        chosen->update(fourier_number);
      }

      void
      vmult(Vector &destination, const Vector &source) const override
      {
        chosen->vmult(destination, source);
      }

      unsigned int
      n_setups() const override
      {
        return amg.n_setups();
      }

    private:
      JacobiVelocityBlock<dim> jacobi;
      AmgVelocityBlock<dim>    amg;
      VelocityBlock<dim>      *chosen = nullptr;
    };
  } // namespace

  THALWEG_REGISTER(VelocityBlock,
                   JacobiVelocityBlock,
                   "jacobi",
                   "some steps of conjugate gradients with the diagonal, "
                   "without a matrix: where inertia rules")
  THALWEG_REGISTER(VelocityBlock,
                   AmgVelocityBlock,
                   "amg",
                   "a cycle of algebraic multigrid (Trilinos ML) that knows "
                   "rigid motions: where viscosity rules")
  THALWEG_REGISTER(VelocityBlock,
                   IluVelocityBlock,
                   "ilu",
                   "an incomplete factorization on each process")
  THALWEG_REGISTER(VelocityBlock,
                   DirectVelocityBlock,
                   "direct",
                   "a direct solver, for tests on small meshes")
  THALWEG_REGISTER(VelocityBlock,
                   AutomaticVelocityBlock,
                   "automatic",
                   "`jacobi` where viscosity reaches no more than two cells in "
                   "a step, else `amg`")
} // namespace Thalweg
