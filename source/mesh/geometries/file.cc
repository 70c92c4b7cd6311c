#include <thalweg/mesh/geometries/division.h>
#include <thalweg/mesh/geometries/gmsh.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <fstream>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// A mesh from a file.
    template <int dim>
    class File : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("File name",
                    file_name,
                    "",
                    "The mesh, in a format that its extension tells: " +
                      formats() + ".");
        section.add("Scale",
                    scale,
                    "",
                    "What all coordinates are multiplied with, for example "
                    "0.001 for a file in millimetres.",
                    dealii::Patterns::Double(1e-300));
        section.add("Divide cells",
                    is_divided,
                    "",
                    "Whether each cell is divided into quadrilaterals or "
                    "hexahedra, one at each corner: a triangle into three, a "
                    "tetrahedron into four. Needed for files with such "
                    "cells.");
        section.add("Boundary names",
                    given_names,
                    "",
                    "Names for the boundary ids of the file, for example "
                    "'inlet:1, wall:2'; the numbers stay valid as names. In "
                    "files of Gmsh physical groups have their names already; "
                    "a name given here counts before one in the file.");
      }


      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        check_plane();
        dealii::Triangulation<dim> mesh;
        if (is_divided)
          {
            dealii::Triangulation<dim> whole;
            read(whole);
            Geometries::divide_into_cubes(whole, mesh, what());
          }
        else
          read(mesh);
        Geometries::orient_cells(mesh);
        if (scale != 1.)
          dealii::GridTools::scale(scale, mesh);
        if (offset.norm() > 0.)
          dealii::GridTools::shift(scale * offset, mesh);
        Geometries::copy_coarse_mesh(mesh, triangulation, what());
        name_boundaries(mesh);
      }


      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return names;
      }

    private:
      std::string
      what() const
      {
        return "The mesh file '" + file_name + "'";
      }


      static std::string
      formats()
      {
        return "msh (Gmsh, ASCII), ucd, inp (Abaqus), unv, vtk, vtu, "
               "dbmesh, xda, dat (Tecplot), e (Exodus II)";
      }


      typename dealii::GridIn<dim>::Format
      format() const
      {
        using Format = dealii::GridIn<dim>;
        static const std::map<std::string, typename Format::Format> known = {
          {"msh", Format::msh},
          {"ucd", Format::ucd},
          {"inp", Format::abaqus},
          {"unv", Format::unv},
          {"vtk", Format::vtk},
          {"vtu", Format::vtu},
          {"dbmesh", Format::dbmesh},
          {"xda", Format::xda},
          {"dat", Format::tecplot},
          {"e", Format::exodusii}};
        const auto dot = file_name.rfind('.');
        const auto entry =
          known.find(dot == std::string::npos ? "" : file_name.substr(dot + 1));
        AssertThrow(entry != known.end(),
                    dealii::ExcMessage(what() +
                                       " has an extension that no mesh "
                                       "format is known for. Known: " +
                                       formats() + "."));
        return entry->second;
      }


      void
      read(dealii::Triangulation<dim> &mesh) const
      {
        const auto    mesh_format = format();
        std::ifstream stream(file_name);
        AssertThrow(stream,
                    dealii::ExcMessage(
                      what() + " cannot be opened. Does it exist, and is its "
                               "path right, seen from the directory where "
                               "the program was started?"));
        dealii::GridIn<dim> reader(mesh);
        try
          {
            if (mesh_format == dealii::GridIn<dim>::exodusii)
              reader.read_exodusii(file_name);
            else if (is_gmsh())
              {
                dealii::Tensor<1, 3> moved;
                std::istringstream near(Geometries::near_origin(stream, moved));
                for (unsigned int d = 0; d < dim; ++d)
                  offset[d] = moved[d];
                reader.read_msh(near);
              }
            else
              reader.read(stream, mesh_format);
          }
        catch (const std::exception &exception)
          {
            const std::string reason = Geometries::reason(exception);
            const std::string known  = "Something went wrong when making cell ";
            if (const auto at = reason.find(known); at != std::string::npos)
              Geometries::refuse_cell(what(),
                                      std::to_string(std::stoi(
                                        reason.substr(at + known.size()))));
            AssertThrow(false,
                        dealii::ExcMessage(
                          what() + " cannot be read as a mesh in " +
                          std::to_string(dim) +
                          " dimensions. Is it complete, in ASCII, and made "
                          "of cells of this dimension? deal.II says:\n" +
                          reason));
          }
      }


      /// Refuses meshes of two dimensions in another plane than that of x and
      /// y: of their points only these coordinates are read.
      void
      check_plane() const
      {
        if constexpr (dim == 2)
          {
            dealii::Triangulation<2, 3> surface;
            dealii::GridIn<2, 3>        reader(surface);
            std::ifstream               stream(file_name);
            if (!is_gmsh() || !stream)
              return;
            try
              {
                reader.read_msh(stream);
              }
            catch (const std::exception &)
              {
                return; // read() says what is wrong
              }
            Geometries::check_plane(surface, what());
          }
      }


      bool
      is_gmsh() const
      {
        return format() == dealii::GridIn<dim>::msh;
      }


      /// Adds the names of Gmsh's physical groups that are boundaries.
      void
      add_physical_names() const
      {
        if (!is_gmsh())
          return;
        std::ifstream stream(file_name);
        const auto    numbered = names;
        for (const auto &[name, id] :
             Geometries::physical_names(stream, dim - 1, what()))
          {
            if (numbered.count(std::to_string(id)) == 0)
              continue; // inside of the mesh
            const auto [entry, is_new] = names.emplace(name, id);
            AssertThrow(is_new || entry->second == id,
                        dealii::ExcMessage(
                          what() + " calls its boundary " + std::to_string(id) +
                          " '" + name +
                          "', which is the number of another one. Give it "
                          "another name."));
          }
      }


      void
      name_boundaries(const dealii::Triangulation<dim> &mesh) const
      {
        names = Geometries::numbered_boundaries(mesh);
        std::string numbers;
        for (const auto &[number, id] : names)
          numbers += (numbers.empty() ? "" : ", ") + number;
        const auto numbered = names;
        add_physical_names();
        for (const auto &[name, id] : given_names)
          {
            AssertThrow(numbered.count(std::to_string(id)) > 0,
                        dealii::ExcMessage(
                          what() + " has no boundary " + std::to_string(id) +
                          ", which 'Boundary names' calls '" + name +
                          "'. It has: " + numbers + "."));
            const auto same = numbered.find(name);
            AssertThrow(same == numbered.end() || same->second == id,
                        dealii::ExcMessage(
                          "'Boundary names' calls the boundary " +
                          std::to_string(id) + " '" + name +
                          "', which is the number of another one in '" +
                          file_name + "'. Give it another name."));
            names[name] = id;
          }
      }


      std::string                         file_name  = "mesh.msh";
      double                              scale      = 1.;
      bool                                is_divided = false;
      std::map<std::string, unsigned int> given_names;
      mutable std::map<std::string, dealii::types::boundary_id> names;
      /// What is still missing from the coordinates that were read.
      mutable dealii::Tensor<1, dim> offset;
    };
  } // namespace

  THALWEG_REGISTER(Geometry,
                   File,
                   "file",
                   "a mesh of quadrilaterals or hexahedra from a file, or of "
                   "cells that are divided into such. Boundary and material "
                   "ids are kept; boundaries are "
                   "called by their numbers, by the names of Gmsh's physical "
                   "groups, or by given names.")
} // namespace Thalweg
