// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "support/input.h"
#include "support/irregular_mesh.h"
#include "support/run_case.h"

namespace
{
  /// A heavy drop that moves with its surroundings through a periodic box.
  std::string
  drop(const std::string &dt, const std::string &end, const std::string &levels)
  {
    return "subsection Geometry\n set Periodic boundaries = left:right, "
           "bottom:top\n subsection box\n  set Repetitions = 16, 16\n end\n"
           "end\n"
           "subsection Refinement\n set Local levels = " +
           levels +
           "\nend\n"
           "subsection Time\n set Time step = " +
           dt + "\n set End time = " + end +
           "\nend\n"
           "subsection Fluids\n subsection Second fluid\n  set Density = 1\n "
           "end\nend\n"
           "subsection Initial conditions\n set Velocity = 1; 0.5\n"
           " set Level set = sqrt((x-0.5)^2 + (y-0.5)^2) - 0.2\nend\n"
           "subsection Fluid solver\n subsection fractional step\n"
           "  set Pressure tolerance = 1e-12\n end\nend\n";
  }



  /// A drop, in 3D a cylinder, in any mesh of the unit box.
  template <int dim>
  std::string
  drop_in(const std::string &mesh, const std::string &dt)
  {
    const std::string velocity = dim == 2 ? "1; 0.5" : "1; 0.5; 0";
    return mesh +
           section("Boundary conditions", {"Velocity = 0: " + velocity}) +
           section("Time",
                   {"Time step = " + dt,
                    "End time = " + std::to_string(10 * std::stod(dt))}) +
           section("Fluids", {}, section("Second fluid", {"Density = 1"})) +
           section("Initial conditions",
                   {"Velocity = " + velocity,
                    "Level set = sqrt((x-0.5)^2 + (y-0.5)^2) - 0.2"}) +
           tight_solver("1e-12", "1e-8");
  }



  template <int dim>
  double
  deviation(const RunCase<dim> &run)
  {
    const double U = std::sqrt(1.25);
    return std::max(std::abs(run.last("max velocity 1 [m/s]") - U),
                    std::abs(run.last("max velocity 2 [m/s]") - U));
  }
} // namespace



TEST(Translation, UniformFlowStaysUniformAtAnyTimeStep)
{
  for (const auto &[dt, end] : {std::make_pair("0.0005", "0.005"),
                                std::make_pair("0.05", "0.5"),
                                std::make_pair("0.4", "2")})
    EXPECT_LT(deviation(RunCase<2>(drop(dt, end, "0"))), 1e-7) << dt;
}



TEST(Translation, UniformFlowStaysUniformAcrossHangingNodes)
{
  EXPECT_LT(deviation(RunCase<2>(drop("0.05", "0.5", "if(x < 0.5, 1, 0)"))),
            1e-7);
}



TEST(Translation, UniformFlowStaysUniformInCellsOfAnyShape)
{
  for (const bool triangles : {false, true})
    {
      const IrregularMesh<2> mesh(8, triangles ? .2 : .3, triangles);
      for (const std::string dt : {"0.001", "0.05"})
        EXPECT_LT(
          deviation(RunCase<2>(drop_in<2>(mesh.geometry(triangles), dt))), 1e-7)
          << triangles << dt;
    }
}



TEST(Translation, UniformFlowStaysUniformInCellsOfAnyShape3d)
{
  const IrregularMesh<3> mesh(4, .2, false);
  EXPECT_LT(deviation(RunCase<3>(drop_in<3>(mesh.geometry(false), "0.05"))),
            1e-7);
}



TEST(TranslationMpi, UniformFlowStaysUniformOnAMeshThatAdaptsEveryStep)
{
  for (const auto &[dt, end] :
       {std::make_pair("0.01", "0.1"), std::make_pair("0.1", "1")})
    {
      const RunCase<2> run(drop(dt, end, "0") +
                           adapting_every_step("0", "1", "interface distance"));
      EXPECT_LT(deviation(run), 1e-7) << dt;
      EXPECT_GT(run.last("adaptations"), 5.) << dt;
      EXPECT_EQ(run.last("particles lost"), 0.) << dt;
    }
}
