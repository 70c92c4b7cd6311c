// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/text_file.h>
#include <thalweg/core/trial.h>
#include <thalweg/mesh/geometries/division.h>
#include <thalweg/mesh/geometries/gmsh.h>
#include <thalweg/mesh/geometries/overlap.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>
#include <thalweg/mesh/touching_boundaries.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <filesystem>
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
        Geometries::check_overlap(mesh, what());
        refuse_doubled_nodes(mesh, what());
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
        return "The mesh file '" + excerpt(file_name) + "'";
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


      /// The beginning of messages about files that are no meshes.
      std::string
      refusal() const
      {
        return what() + " cannot be read as a mesh in " + std::to_string(dim) +
               " dimensions";
      }


      /// What is in the file, line ends of other systems replaced.
      std::string
      text() const
      {
        // Nobody has a coarse mesh that is larger.
        constexpr std::size_t most_bytes = 1000000000;
        const bool            is_text    = is_gmsh() || has_outline();
        const std::string     path       = with_home(file_name);
        std::error_code       error;
        AssertThrow(std::filesystem::exists(path, error),
                    dealii::ExcMessage(
                      what() + " cannot be opened. Does it exist, and is its "
                               "path right, seen from the directory where "
                               "the program was started?"));
        const std::string content =
          read_text_file(path, what(), most_bytes).content;
        // Formats that may be binary are left to deal.II.
        return is_text ? plain_lines(content, what()) : content;
      }


      /// Whether outline_of() knows the format.
      bool
      has_outline() const
      {
        using Format = dealii::GridIn<dim>;
        return format() == Format::vtk || format() == Format::ucd ||
               format() == Format::unv || format() == Format::abaqus ||
               format() == Format::xda || format() == Format::dbmesh ||
               format() == Format::tecplot;
      }


      Geometries::MeshOutline
      outline_of(const std::string &content) const
      {
        using Format = dealii::GridIn<dim>;
        switch (format())
          {
            case Format::vtk:
              return Geometries::outline_of_vtk(content, refusal());
            case Format::ucd:
              return Geometries::outline_of_ucd(content, refusal());
            case Format::unv:
              return Geometries::outline_of_unv(content, refusal());
            case Format::xda:
              return Geometries::outline_of_xda(content, dim, refusal());
            case Format::dbmesh:
              return Geometries::outline_of_dbmesh(content, refusal());
            case Format::tecplot:
              return Geometries::outline_of_tecplot(content, dim, refusal());
            default:
              return Geometries::outline_of_abaqus(content, dim, refusal());
          }
      }


      /// Lets deal.II read a mesh.
      void
      read(const std::string &content, dealii::Triangulation<dim> &mesh) const
      {
        using Format = dealii::GridIn<dim>;
        std::istringstream stream(content);
        Format             reader(mesh);
        if (format() == Format::exodusii)
          reader.read_exodusii(with_home(file_name));
        else if (is_gmsh())
          reader.read_msh(stream);
        else
          reader.read(stream, format());
      }


      void
      read(dealii::Triangulation<dim> &mesh) const
      {
        std::string content = text();
        std::string fault;
        if (is_gmsh())
          {
            auto file = Geometries::read_gmsh(content, refusal());
            check(file.outline);
            physical_names = file.names[dim - 1];
            dealii::Tensor<1, 3> moved;
            content = Geometries::gmsh_text(file.outline, dim, moved);
            for (unsigned int d = 0; d < dim; ++d)
              offset[d] = moved[d];
          }
        else
          {
            if (has_outline())
              check(outline_of(content));
            // Ten bytes are a number.
            TrialLimits limits;
            limits.seconds += content.size() / 1000000;
            limits.gigabytes += content.size() / 1e7;
            fault = fault_in_trial(
              [&]() {
                dealii::Triangulation<dim> trial;
                read(content, trial);
              },
              limits);
          }
        if (fault.empty())
          try
            {
              read(content, mesh);
              return;
            }
          catch (const std::exception &exception)
            {
              fault = message_of(exception);
            }
        refuse(fault);
      }


      void
      check(const Geometries::MeshOutline &outline) const
      {
        if (dim == 2)
          Geometries::check_plane(outline.points_of_cells(2), what());
        if (!is_divided && !outline.has_only_cubes(dim))
          Geometries::refuse_shapes(what(), dim);
        if (const std::string cell = dim == 2 ? outline.first_twisted() : "";
            !cell.empty())
          Geometries::refuse_cell(what(), cell);
        Geometries::check_outline(outline, dim, refusal());
      }


      /// Says what deal.II said of the file.
      [[noreturn]] void
      refuse(const std::string &fault) const
      {
        // Of other formats deal.II converts that of Abaqus, and says where.
        AssertThrow(format() != dealii::GridIn<dim>::abaqus ||
                      fault.find("Internal conversion") == std::string::npos,
                    dealii::ExcMessage(
                      refusal() +
                      ": its sets and surfaces do not fit its elements, or "
                      "these are not numbered one after another from 1."));
        const std::string known = "Something went wrong when making cell ";
        if (const auto at = fault.find(known); at != std::string::npos)
          Geometries::refuse_cell(
            what(), std::to_string(std::atoi(&fault[at + known.size()])));
        throw dealii::ExcMessage(
          refusal() +
          ". Is it complete, in ASCII, and made of cells of this "
          "dimension? What went wrong: " +
          bounded_message(fault, 1000));
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
        const auto numbered = names;
        for (const auto &[name, id] : physical_names)
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
      /// The names in the file.
      mutable std::map<std::string, unsigned int> physical_names;
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
