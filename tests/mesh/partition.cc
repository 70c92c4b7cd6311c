// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/node_space.h>
#include <thalweg/mesh/mesh.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>
#include <map>
#include <string>

#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/input.h"

using namespace Thalweg;

namespace
{
  /// A mesh from the text of an input file.
  template <int dim>
  struct Made
  {
    explicit Made(const std::string &text, const MPI_Comm communicator)
      : mesh(communicator)
    {
      dealii::ParameterHandler prm;
      parameters.declare(Section(prm));
      prm.parse_input_from_string(text);
      mesh.create(parameters);
    }

    MeshParameters<dim> parameters;
    Mesh<dim>           mesh;
  };

  const std::string metis = section("Partition", {"Model = metis"});

  /// The same mesh by METIS over all ranks, and by p4est as a whole on each.
  template <int dim>
  struct Both
  {
    using Behind = typename CellGraph<dim>::Behind;

    explicit Both(const std::string &text)
      : parts(text + metis, MPI_COMM_WORLD)
      , whole(text, MPI_COMM_SELF)
    {
      const CellGraph<dim> &graph = whole.mesh.graph();
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        of_id[graph.iterator(c)->id()] = c;
    }

    /// The cell of the whole mesh that is @p cell of the parts.
    unsigned int
    in_whole(const unsigned int cell) const
    {
      return of_id.at(parts.mesh.graph().iterator(cell)->id());
    }

    const Made<dim>                        parts;
    const Made<dim>                        whole;
    std::map<dealii::CellId, unsigned int> of_id;
  };


  /// Local refinement with hanging nodes, also across periodic boundaries.
  template <int dim>
  std::string
  stairs()
  {
    return unit_box<dim>(4,
                         "if(x + y < 0.6, 2, if(x + y < 0.9, 1, 0))",
                         {"Periodic boundaries = left:right"});
  }


  template <int dim>
  void
  expect_equal_faces(const Both<dim> &both, const unsigned int c)
  {
    using Behind      = typename CellGraph<dim>::Behind;
    const auto &parts = both.parts.mesh.graph();
    const auto &whole = both.whole.mesh.graph();
    for (unsigned int f = 0; f < parts.n_faces; ++f)
      {
        const auto &one   = parts.cell(c).faces[f];
        const auto &other = whole.cell(both.in_whole(c)).faces[f];
        ASSERT_EQ(one.behind, other.behind);
        ASSERT_EQ(one.boundary_id, other.boundary_id);
        ASSERT_EQ(one.periodic < 0, other.periodic < 0);
        if (one.periodic >= 0)
          ASSERT_LT((parts.periodic_offsets()[one.periodic] -
                     whole.periodic_offsets()[other.periodic])
                      .norm(),
                    1e-14);
        if (one.behind == Behind::cell)
          ASSERT_EQ(both.in_whole(one.index), unsigned(other.index));
        else if (one.behind == Behind::refined)
          for (unsigned int i = 0; i < parts.n_face_children; ++i)
            ASSERT_EQ(both.in_whole(parts.face_children(one.index)[i]),
                      unsigned(whole.face_children(other.index)[i]));
      }
  }
} // namespace


template <typename T>
class MetisMpi : public testing::Test
{};
TYPED_TEST_SUITE(MetisMpi, Dimensions);


TYPED_TEST(MetisMpi, HasTheCellsOfP4est)
{
  constexpr int   dim = TypeParam::value;
  const Both<dim> both(stairs<dim>());
  const auto     &parts = both.parts.mesh.graph();
  const auto     &whole = both.whole.mesh.graph();
  const MPI_Comm  world = MPI_COMM_WORLD;
  EXPECT_EQ(dealii::Utilities::MPI::sum(parts.n_owned_cells(), world),
            whole.n_cells());
  // METIS aims at equal parts; 3 % more is what it allows itself.
  EXPECT_LE(dealii::Utilities::MPI::max(parts.n_owned_cells(), world),
            1.1 * whole.n_cells() /
              dealii::Utilities::MPI::n_mpi_processes(world));
  std::vector<unsigned int> n_owners(whole.n_cells());
  for (unsigned int c = 0; c < parts.n_cells(); ++c)
    {
      if (c < parts.n_owned_cells())
        ++n_owners[both.in_whole(c)];
      for (unsigned int v = 0; v < parts.n_vertices; ++v)
        ASSERT_EQ(parts.cell(c).vertices[v],
                  whole.cell(both.in_whole(c)).vertices[v]);
    }
  dealii::Utilities::MPI::sum(n_owners, world, n_owners);
  for (const unsigned int n : n_owners)
    ASSERT_EQ(n, 1u);
  EXPECT_EQ(both.parts.mesh.coarse_checksum(),
            both.whole.mesh.coarse_checksum());
}


TYPED_TEST(MetisMpi, KnowsWhatIsBehindEachFace)
{
  constexpr int   dim = TypeParam::value;
  const Both<dim> both(stairs<dim>());
  for (unsigned int c = 0; c < both.parts.mesh.graph().n_owned_cells(); ++c)
    expect_equal_faces(both, c);
}


TYPED_TEST(MetisMpi, TellsBoundariesFromUnknownNeighborsOfGhostCells)
{
  constexpr int dim = TypeParam::value;
  // In a row of cells a ghost cell's periodic neighbour may be unknown.
  const std::string row = box_of(dim == 2 ? "5, 1" : "5, 1, 1",
                                 "0",
                                 {"Periodic boundaries = left:right"});
  for (const std::string &text : {stairs<dim>(), unit_box<dim>(7), row})
    {
      const Both<dim> both(text);
      const auto     &parts = both.parts.mesh.graph();
      for (unsigned int c = 0; c < parts.n_cells(); ++c)
        for (unsigned int f = 0; f < parts.n_faces; ++f)
          {
            const bool is_boundary =
              both.whole.mesh.graph().at_boundary(both.in_whole(c), f);
            ASSERT_EQ(parts.at_boundary(c, f), is_boundary);
            if (is_boundary)
              ASSERT_EQ(parts.iterator(c)->face(f)->boundary_id(),
                        both.whole.mesh.graph()
                          .iterator(both.in_whole(c))
                          ->face(f)
                          ->boundary_id());
          }
    }
}


TYPED_TEST(MetisMpi, KnowsAllCellsAroundTheVerticesOfItsOwn)
{
  constexpr int     dim = TypeParam::value;
  const Both<dim>   both(stairs<dim>());
  const auto       &parts = both.parts.mesh.graph();
  const auto       &tria  = both.whole.mesh.triangulation();
  std::vector<bool> is_known(tria.n_active_cells()), is_near(tria.n_vertices());
  for (unsigned int c = 0; c < parts.n_cells(); ++c)
    {
      const auto &cell = both.whole.mesh.graph().iterator(both.in_whole(c));
      is_known[cell->active_cell_index()] = true;
      if (c < parts.n_owned_cells())
        for (const unsigned int v : cell->vertex_indices())
          is_near[cell->vertex_index(v)] = true;
    }
  for (const auto &cell : tria.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (is_near[cell->vertex_index(v)])
        ASSERT_TRUE(is_known[cell->active_cell_index()]);
}


TYPED_TEST(MetisMpi, HasTheNodesOfP4est)
{
  constexpr int        dim = TypeParam::value;
  const Both<dim>      both(stairs<dim>());
  const NodeSpace<dim> parts(both.parts.mesh), whole(both.whole.mesh);
  EXPECT_EQ(parts.scalar().n_dofs(), whole.scalar().n_dofs());
  const auto n_independent = [](const NodeSpace<dim> &space) {
    unsigned int n = 0;
    for (unsigned int node = 0; node < space.n_owned_nodes(); ++node)
      n += !space.is_dependent(node);
    return n;
  };
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_independent(parts), MPI_COMM_WORLD),
            n_independent(whole));
}


TYPED_TEST(MetisMpi, FollowsCurvedBoundaries)
{
  constexpr int     dim = TypeParam::value;
  const std::string text =
    section("Geometry", {"Model = cylinder in channel"}) +
    section("Refinement", {"Global levels = 1"});
  const Both<dim>             both(text);
  const dealii::MappingQ<dim> curved(2);
  const auto                 &parts = both.parts.mesh.graph();
  for (unsigned int c = 0; c < parts.n_cells(); ++c)
    {
      const auto &cell  = parts.iterator(c);
      const auto &other = both.whole.mesh.graph().iterator(both.in_whole(c));
      for (unsigned int v = 0; v < parts.n_vertices; ++v)
        ASSERT_LT(cell->vertex(v).distance(other->vertex(v)), 1e-12);
      dealii::Point<dim> unit;
      for (unsigned int d = 0; d < dim; ++d)
        unit[d] = .5 * (d % 2);
      ASSERT_LT(curved.transform_unit_to_real_cell(cell, unit)
                  .distance(curved.transform_unit_to_real_cell(other, unit)),
                1e-12);
    }
}


TEST(MetisMpi2d, RefusesMoreProcessesThanCells)
{
  const unsigned int n =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const auto make = [](const unsigned int n_cells) {
    Made<2>(box_of(std::to_string(n_cells) + ", 1", "0") + metis,
            MPI_COMM_WORLD);
  };
  EXPECT_EQ(complaint_of([&]() { make(n); }), "");
  if (n == 1)
    return;
  const std::string message = complaint_of([&]() { make(n - 1); });
  EXPECT_NE(message.find("too few for METIS to give one to each of the " +
                         std::to_string(n)),
            std::string::npos)
    << message;
}
