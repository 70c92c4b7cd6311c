// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/particles/carried_population.h>
#include <thalweg/particles/seeding.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <deal.II/fe/mapping_q1.h>

#include <gtest/gtest.h>

#include "../support/dimensions.h"
#include "../support/input.h"

namespace
{
  using namespace Thalweg;

  /// A polynomial of a given degree in each direction.
  template <int dim>
  class Polynomial : public dealii::Function<dim>
  {
  public:
    Polynomial(const unsigned int degree, const unsigned int n_components)
      : dealii::Function<dim>(n_components)
      , degree(degree)
    {}

    double
    value(const dealii::Point<dim> &x,
          const unsigned int        component = 0) const override
    {
      double value = 1. + component;
      for (unsigned int d = 0; d < dim; ++d)
        value *= degree == 1 ? 1. + (d + 2.) * x[d]
                             : 1. - x[d] * (component + d + x[d]);
      return value;
    }

  private:
    const unsigned int degree;
  };

  template <int dim>
  struct Travellers
  {
    explicit Travellers(Mesh<dim> &mesh)
      : mesh(mesh)
      , population(mesh)
      , particles(population)
    {
      make_spaces();
    }

    void
    make_spaces()
    {
      linear    = std::make_unique<LagrangeSpace<dim>>(mesh, 1, mesh.mapping());
      quadratic = std::make_unique<LagrangeSpace<dim>>(mesh, 2, mesh.mapping());
      linear->initialize(p, 1);
      quadratic->initialize(v, dim);
    }

    void
    fill()
    {
      interpolate_function(*linear, Polynomial<dim>(1, 1), p);
      interpolate_function(*quadratic, Polynomial<dim>(2, dim), v);
      linear->interpolate(p, 1);
      quadratic->interpolate(v, dim);
      SeedingParameters parameters;
      parameters.jitter                  = .7;
      parameters.particles_per_direction = 3;
      seed(population,
           parameters,
           Polynomial<dim>(2, dim),
           Polynomial<dim>(1, 1));
    }

    State<dim>
    state()
    {
      State<dim> state(Archive::nowhere());
      state.field("p", *linear, p, 1);
      state.field("v", *quadratic, v, dim);
      state.carry("particles", particles);
      return state;
    }

    /// The fields are those of fill(), and so are the particles.
    void
    expect_filled(const unsigned int n_particles)
    {
      Vector exact_p, exact_v;
      linear->initialize(exact_p, 1);
      quadratic->initialize(exact_v, dim);
      interpolate_function(*linear, Polynomial<dim>(1, 1), exact_p);
      interpolate_function(*quadratic, Polynomial<dim>(2, dim), exact_v);
      linear->interpolate(exact_p, 1);
      quadratic->interpolate(exact_v, dim);
      for (unsigned int i = 0; i < dim * quadratic->dependences().n_nodes();
           ++i)
        ASSERT_NEAR(v.local_element(i), exact_v.local_element(i), 1e-12);
      for (unsigned int i = 0; i < linear->dependences().n_nodes(); ++i)
        ASSERT_NEAR(p.local_element(i), exact_p.local_element(i), 1e-12);

      EXPECT_EQ(population.n_global_particles(), n_particles);
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        for (const auto &particle : population.in_cell(c))
          {
            const auto cell      = mesh.graph().iterator(c);
            const auto position  = particle.position();
            const auto reference = particle.reference();
            for (unsigned int d = 0; d < dim; ++d)
              {
                EXPECT_GE(reference[d], 0.);
                EXPECT_LE(reference[d], 1. + 1e-12);
              }
            EXPECT_LT(position.distance(
                        mesh.mapping().transform_unit_to_real_cell(cell,
                                                                   reference)),
                      1e-12);
            const auto properties = particle.properties();
            EXPECT_EQ(properties[dim], Polynomial<dim>(1, 1).value(position));
            for (unsigned int d = 0; d < dim; ++d)
              EXPECT_EQ(properties[d],
                        Polynomial<dim>(2, dim).value(position, d));
          }
    }

    Mesh<dim>                          &mesh;
    Population<dim>                     population;
    CarriedPopulation<dim>              particles;
    std::unique_ptr<LagrangeSpace<dim>> linear, quadratic;
    Vector                              p, v;
  };

  /// Flags that only depend on where a cell is.
  template <int dim>
  void
  flag(Mesh<dim> &mesh, const unsigned int round)
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto   center = cell->center();
          const double wave =
            std::sin(9. * center[0] + round) * std::cos(7. * center[1] - round);
          if (wave > .3 && cell->level() < 3)
            cell->set_refine_flag();
          else if (wave < 0.)
            cell->set_coarsen_flag();
        }
  }

  template <int dim>
  void
  create(Mesh<dim> &mesh, const std::string &levels)
  {
    dealii::ParameterHandler prm;
    MeshParameters<dim>      parameters;
    parameters.declare(Section(prm));
    prm.parse_input_from_string(unit_box<dim>(3, levels));
    mesh.create(parameters);
  }

  template <int dim>
  void
  load(Mesh<dim> &mesh, const SavedCells &saved)
  {
    dealii::ParameterHandler prm;
    MeshParameters<dim>      parameters;
    parameters.declare(Section(prm));
    prm.parse_input_from_string(unit_box<dim>(3, "0"));
    mesh.create_to_load(parameters);
    mesh.load(parameters, saved);
  }

  template <typename Dimension>
  class MeshTransferMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(MeshTransferMpi, Dimensions);
} // namespace



TYPED_TEST(MeshTransferMpi, NothingIsLostOnMeshesThatChange)
{
  constexpr int dim = TypeParam::value;
  Mesh<dim>     mesh(MPI_COMM_WORLD);
  create(mesh, "if(x + y < 0.9, 1, 0)");
  Travellers<dim> travellers(mesh);
  travellers.fill();
  const unsigned int n_particles = travellers.population.n_global_particles();
  std::set<unsigned int> sizes;
  for (unsigned int round = 0; round < 4; ++round)
    {
      flag(mesh, round);
      MeshTransfer<dim> transfer(mesh);
      transfer.pack(travellers.state());
      mesh.triangulation().execute_coarsening_and_refinement();
      mesh.update();
      travellers.make_spaces();
      transfer.unpack(travellers.state());
      travellers.expect_filled(n_particles);
      sizes.insert(mesh.triangulation().n_global_active_cells());
    }
  EXPECT_GT(sizes.size(), 2u);
}



TYPED_TEST(MeshTransferMpi, LoadedStateIsTheSameBitByBit)
{
  constexpr int dim = TypeParam::value;
  Mesh<dim>     mesh(MPI_COMM_WORLD);
  create(mesh, "if(x + y < 0.9, 1, 0)");
  flag(mesh, 1);
  mesh.triangulation().execute_coarsening_and_refinement();
  mesh.update();
  Travellers<dim> travellers(mesh);
  travellers.fill();
  const std::vector<unsigned int> counts =
    dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                       mesh.graph().n_owned_cells());
  MeshTransfer<dim> departure(mesh);
  const PackedCells packed = departure.pack_to_save(travellers.state());
  const Archive     archive;
  departure.keep(archive);

  SavedCells saved;
  saved.n_ranks = saved.n_old_ranks = counts.size();
  saved.first_of_rank               = {0};
  for (const unsigned int n : counts)
    saved.first_of_rank.push_back(saved.first_of_rank.back() + n);
  saved.own = mesh.cells_on_curve();
  Mesh<dim> loaded(MPI_COMM_WORLD);
  load(loaded, saved);
  Travellers<dim>   arrivals(loaded);
  MeshTransfer<dim> transfer(loaded);
  transfer.keep(archive.reader());
  transfer.unpack_saved(arrivals.state(), packed);
  arrivals.expect_filled(travellers.population.n_global_particles());

  // The numbering only depends on the mesh, not on its history.
  ASSERT_EQ(arrivals.v.locally_owned_size(), travellers.v.locally_owned_size());
  for (unsigned int i = 0; i < arrivals.v.locally_owned_size(); ++i)
    ASSERT_EQ(arrivals.v.local_element(i), travellers.v.local_element(i));
  const auto &graph = mesh.graph();
  ASSERT_EQ(graph.n_cells(), loaded.graph().n_cells());
  for (unsigned int c = 0; c < graph.n_cells(); ++c)
    {
      ASSERT_EQ(graph.cell(c).vertices, loaded.graph().cell(c).vertices);
      ASSERT_EQ(graph.cell(c).global_index,
                loaded.graph().cell(c).global_index);
    }
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      auto particle = arrivals.population.in_cell(c).begin();
      for (const auto &old : travellers.population.in_cell(c))
        {
          EXPECT_EQ(old.id(), particle->id());
          EXPECT_EQ(old.position(), particle->position());
          EXPECT_EQ(old.reference(), particle->reference());
          ++particle;
        }
    }
}



TYPED_TEST(MeshTransferMpi, RefusesWhatCannotBe)
{
  constexpr int dim = TypeParam::value;
  Mesh<dim>     mesh(MPI_COMM_WORLD);
  create(mesh, "if(x + y < 0.9, 1, 0)");
  SavedCells saved;
  saved.place   = "there";
  saved.n_ranks = saved.n_old_ranks = 1;
  const auto refuse                 = [&](const std::vector<CurveCell> &cells) {
    // On each process alone.
    Mesh<dim> loaded(MPI_COMM_SELF);
    saved.own           = cells;
    saved.first_of_rank = {0, cells.size()};
    try
      {
        load(loaded, saved);
      }
    catch (const dealii::ExcMessage &failure)
      {
        return message_of(failure);
      }
    return std::string();
  };
  Mesh<dim> whole(MPI_COMM_SELF);
  create(whole, "if(x + y < 0.9, 1, 0)");
  const auto good = whole.cells_on_curve();
  EXPECT_EQ(refuse(good), "");

  auto cells = good;
  cells.pop_back();
  EXPECT_NE(refuse(cells).find("do not cover"), std::string::npos);
  cells = good;
  std::swap(cells.front(), cells.back());
  EXPECT_NE(refuse(cells).find("do not cover"), std::string::npos);
  for (const CurveCell bad : {CurveCell{0, 4000000000u, 0},
                              CurveCell{1ull << 40, 0, 1},
                              CurveCell{0, 0, 60}})
    {
      cells.back() = bad;
      EXPECT_NE(refuse(cells).find("cannot be"), std::string::npos);
    }
  // One corner much finer than its neighbours.
  cells                        = {good.begin() + (1 << dim), good.end()};
  const unsigned int     depth = 5;
  std::vector<CurveCell> fine;
  for (unsigned int level = depth; level > 0; --level)
    for (std::uint64_t child = level == depth ? 0 : 1; child < (1u << dim);
         ++child)
      fine.push_back({child, 0, level});
  cells.insert(cells.begin(), fine.begin(), fine.end());
  EXPECT_EQ(refuse(cells), "");
  cells = {good.begin() + (1 << dim), good.end()};
  fine.clear();
  // The other end of the first coarse cell touches its neighbours.
  for (unsigned int level = 1; level <= depth; ++level)
    {
      const std::uint64_t last = (1ull << (dim * level)) - 1;
      for (std::uint64_t child = 0; child + 1 < (1u << dim); ++child)
        fine.push_back({last - (1u << dim) + 1 + child,
                        0,
                        static_cast<std::uint32_t>(level)});
      if (level == depth)
        fine.push_back({last, 0, depth});
    }
  cells.insert(cells.begin(), fine.begin(), fine.end());
  EXPECT_NE(refuse(cells).find("more than one"), std::string::npos)
    << refuse(cells);
}
