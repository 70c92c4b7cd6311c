// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_mesh_made_geometry_h
#define tests_mesh_made_geometry_h

#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <memory>
#include <sstream>
#include <string>

#include "support/complaint.h"

/// The geometry @p model with parameters set from "name = value" lines.
template <int dim>
struct Made
{
  Made(const std::string &model, const std::string &settings)
    : geometry(
        Thalweg::Registry<Thalweg::Geometry<dim>>::entries().at(model).make())
  {
    const Thalweg::Section root(prm);
    geometry->declare_parameters(root);
    std::string        input;
    std::istringstream lines(settings);
    for (std::string line; std::getline(lines, line);)
      input += "set " + line + "\n";
    prm.parse_input_from_string(input);
  }

  /// The mesh on one process.
  void
  create()
  {
    geometry->create(mesh);
  }

  /// What create() complains about.
  std::string
  error()
  {
    return complaint_of([this]() { create(); });
  }

  double
  boundary_measure(const std::string &name) const
  {
    double     sum = 0;
    const auto id  = geometry->boundary_names().at(name);
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        sum += face->measure();
    return sum;
  }

  dealii::ParameterHandler                prm;
  std::unique_ptr<Thalweg::Geometry<dim>> geometry;
  dealii::Triangulation<dim>              mesh;
};


/// Whether @p part stands somewhere in @p text.
inline bool
contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

#endif
