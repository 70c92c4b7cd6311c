// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>

#include "own_flow.h"

namespace
{
  /// Averages of a linear flow whose amplitude changes, on a mesh that does.
  class ChangingMesh
  {
  public:
    using Tensor = dealii::Tensor<1, 2>;
    using Point  = dealii::Point<2>;

    ChangingMesh()
      : state(hanging_box<2>(4) + one_fluid(2., .5))
    {
      make_flow();
      averages = state.prepare("time averages");
    }

    static Tensor
    linear(const Point &p)
    {
      return Tensor({1. + p[0] - 2. * p[1], 3. * p[0]});
    }

    static double
    pressure(const Point &p)
    {
      return 5. * p[0] - p[1];
    }

    void
    step(const double amplitude)
    {
      flow->set_velocity([&](const auto &p) { return amplitude * linear(p); });
      auto solution      = state.view();
      solution.time      = 1.;
      solution.time_step = .5;
      solution.step      = 1;
      averages->execute(state.context, whole(solution));
    }

    void
    refine()
    {
      auto &tria = state.mesh.triangulation();
      for (const auto &cell : tria.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[1] < .4)
          cell->set_refine_flag();
      tria.execute_coarsening_and_refinement();
      state.mesh.update();
      state.space = std::make_unique<Thalweg::NodeSpace<2>>(state.mesh);
      make_flow();
      averages->mesh_changed(whole(state.view()));
    }

    /// Calls @p visit(entry, value) for all entries of all fields with what
    /// they should be.
    /// @param mean of the amplitudes
    /// @param square of their fluctuations, integrated over time
    template <typename Visitor>
    void
    for_each_entry(const double mean, const double square, const Visitor &visit)
    {
      const Thalweg::State<2> fields(Thalweg::Archive::nowhere());
      averages->keep(fields);
      EXPECT_EQ(fields.fields().size(), 4u);
      const auto &graph = state.mesh.graph();
      for (const auto &field : fields.fields())
        for (unsigned int c = 0; c < graph.n_cells(); ++c)
          for (unsigned int i = 0; i < field.space->n_nodes_per_cell(); ++i)
            {
              const Point p =
                Thalweg::Q1::position<2>(graph.cell(c).vertices,
                                         field.space->unit_nodes()[i]);
              const Tensor       u    = linear(p);
              const unsigned int node = field.space->nodes(c)[i];
              for (unsigned int d = 0; d < field.n_components; ++d)
                {
                  double value = mean * u[d];
                  if (field.name == "mean pressure")
                    value = pressure(p);
                  else if (field.name == "stress x")
                    value = square * u[0] * u[d];
                  else if (field.name == "stress y")
                    value = square * u[1] * u[d];
                  visit(field.vector->local_element(field.n_components * node +
                                                    d),
                        value);
                }
            }
    }

    void
    expect(const double mean, const double square)
    {
      double difference = 0.;
      for_each_entry(mean, square, [&](const double entry, const double value) {
        difference = std::max(difference, std::abs(entry - value));
      });
      EXPECT_LT(difference, 1e-12);
    }

  private:
    void
    make_flow()
    {
      flow = std::make_unique<OwnFlow<2>>(state.mesh, 1, linear, pressure);
      state.flow = &flow->fields;
    }

    State<2>                                   state;
    std::unique_ptr<OwnFlow<2>>                flow;
    std::unique_ptr<Thalweg::Postprocessor<2>> averages;
  };
} // namespace


TEST(FlowMeansMpi, MeansSurviveAnotherMesh)
{
  ChangingMesh run;
  run.step(1.);
  run.step(3.);
  run.expect(2., 1.);
  run.refine();
  run.for_each_entry(0., 0., [](const double entry, double) {
    EXPECT_EQ(entry, 0.);
  });
  // What interpolation of linear and quadratic fields gives.
  run.for_each_entry(2., 1., [](double &entry, const double value) {
    entry = value;
  });
  run.step(5.);
  run.expect(3., 4.);
}
