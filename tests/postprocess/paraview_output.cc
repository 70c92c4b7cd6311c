// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/pvd_record.h>

#include "fixture.h"
#include "support/put_particle.h"

namespace
{
  /// What stands in a file after all processes have written.
  std::string
  written(const std::string &path)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    return content(path);
  }


  /// The number behind `name="` in @p text.
  int
  attribute(const std::string &text, const std::string &name)
  {
    const auto position = text.find(name + "=\"");
    return position == std::string::npos
             ? -1
             : std::stoi(text.substr(position + name.size() + 2));
  }


  template <int dim>
  void
  check_output()
  {
    State<dim>         state(section("Refinement", {"Global levels = 3"}));
    const unsigned int n_particles = 3 * state.mesh.graph().n_owned_cells();
    for (unsigned int p = 0; p < n_particles; ++p)
      {
        dealii::Point<dim> xi;
        for (unsigned int d = 0; d < dim; ++d)
          xi[d] = 0.25 * (1 + p % 3);
        put_particle(*state.population, p / 3, xi, .5 * p);
      }
    const auto fields    = state.run("fields");
    const auto particles = state.run("particles");

    const std::string &directory = state.context.output_directory;
    const std::string  record    = written(directory + "/fields.pvd");
    EXPECT_NE(record.find("file=\"fields/fields_0000."), std::string::npos)
      << record;
    EXPECT_FALSE(std::filesystem::exists(directory + "/fields.pvd.new"));
    const std::string vtu = written(directory + "/fields/fields_0000.0.vtu");
    for (const std::string name :
         {"velocity", "pressure", "level_set", "density", "subdomain"})
      EXPECT_NE(vtu.find("Name=\"" + name + "\""), std::string::npos) << name;

    const std::string cloud =
      written(directory + "/particles/particles_0000.0.vtu");
    for (const std::string name :
         {"id", "velocity", "level_set", "volume", "fluid"})
      EXPECT_NE(cloud.find("Name=\"" + name + "\""), std::string::npos) << name;
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
      {
        EXPECT_EQ(attribute(vtu, "NumberOfCells"), dim == 2 ? 64 : 512);
        EXPECT_EQ(attribute(cloud, "NumberOfPoints"), dim == 2 ? 192 : 1536);
      }
  }
} // namespace


TEST(ParaviewOutputMpi, HasFieldsAndParticles)
{
  check_output<2>();
  check_output<3>();
}


TEST(ParaviewOutputMpi, NamesTheDirectoryThatCannotBeCreated)
{
  Thalweg::Context context(MPI_COMM_WORLD);
  context.output_directory = "/dev/null";
  Thalweg::PvdRecord record;
  try
    {
      record.open(context, "fields");
      FAIL() << "A file is no directory.";
    }
  catch (const std::exception &exception)
    {
      EXPECT_NE(std::string(exception.what()).find("/dev/null/fields"),
                std::string::npos);
    }
}
