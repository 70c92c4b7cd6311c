#include <thalweg/core/registry.h>
#include <thalweg/particles/particle_journeys.h>
#include <thalweg/particles/streamline_convection.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Who wants to know.
    struct Question
    {
      unsigned int rank;
      unsigned int index;
    };

    /// An answer on its way to the rank that asked.
    template <int dim>
    struct Answer
    {
      unsigned int               index;
      dealii::types::boundary_id boundary;
      std::array<double, dim>    position;
      std::array<double, dim>    velocity;
      double                     level_set;
    };

    /// Counts those that did not arrive.
    template <int dim>
    void
    count_missing(const std::vector<Traveller<dim, Particle<dim>>> &travellers,
                  ConvectionReport                                 &report)
    {
      for (const auto &[walker, particle] : travellers)
        if (walker.fate == Fate::left)
          {
            const double level_set =
              particle.properties[Population<dim>::level_set_offset];
            ++report.left[walker.boundary][level_set < 0 ? 0 : 1];
          }
        else if (walker.fate == Fate::lost)
          ++report.n_lost;
    }

    /// A field's values at reference coordinates of a cell.
    template <int dim, int n_components, std::size_t n>
    std::array<double, n_components>
    interpolate(const std::array<double, n>   &nodal,
                const std::array<double, dim> &reference)
    {
      std::array<double, n_components> value{};
      for (unsigned int v = 0; v < (1 << dim); ++v)
        {
          double shape = 1;
          for (unsigned int d = 0; d < dim; ++d)
            shape *= (v >> d) & 1 ? reference[d] : 1. - reference[d];
          for (unsigned int c = 0; c < n_components; ++c)
            value[c] += shape * nodal[v * n_components + c];
        }
      return value;
    }

    template <int dim>
    Answer<dim>
    answer(const StreamlineWalk<dim> &walk,
           const Walker<dim>         &walker,
           const unsigned int         index,
           const CellVelocity<dim>   &velocity,
           const CellField<dim, 1>   &level_set)
    {
      Answer<dim> answer;
      answer.index    = index;
      answer.boundary = walker.fate == Fate::left
                          ? walker.boundary
                          : dealii::numbers::invalid_boundary_id;

      const dealii::Point<dim> position = walk.position(walker);
      for (unsigned int d = 0; d < dim; ++d)
        answer.position[d] = position[d];
      answer.velocity =
        interpolate<dim, dim>(velocity[walker.cell], walker.reference);
      answer.level_set =
        interpolate<dim, 1>(level_set[walker.cell], walker.reference)[0];
      return answer;
    }

    template <int dim>
    Foot<dim>
    to_foot(const Answer<dim> &answer, const bool found)
    {
      Foot<dim> foot;
      for (unsigned int d = 0; d < dim; ++d)
        foot.position[d] = answer.position[d];
      foot.velocity  = answer.velocity;
      foot.level_set = answer.level_set;
      foot.boundary  = answer.boundary;
      foot.found     = found;
      return foot;
    }
  } // namespace


  void
  ConvectionParameters::declare_parameters(const Section &section)
  {
    section.add("Integrator",
                integrator,
                "",
                "How streamlines are integrated: `rk2` is the midpoint rule, "
                "`rk4` the classical scheme of fourth order.",
                dealii::Patterns::Selection("rk2|rk4"));
    section.add("Substep Courant number",
                substep_courant_number,
                "",
                "The greatest part of a cell that a particle may cross in "
                "one substep of the integrator. Time steps may have any "
                "Courant number; this only sets how finely the way of the "
                "particles is resolved.",
                dealii::Patterns::Double(1e-3, 1.));
  }


  std::uint64_t
  ConvectionReport::n_left() const
  {
    std::uint64_t n = 0;
    for (const auto &[boundary, counts] : left)
      n += counts[0] + counts[1];
    return n;
  }


  ConvectionReport
  ConvectionReport::sum(const MPI_Comm communicator) const
  {
    namespace MPI = dealii::Utilities::MPI;
    ConvectionReport total;
    total.n_moved         = MPI::sum(n_moved, communicator);
    total.n_lost          = MPI::sum(n_lost, communicator);
    total.n_substeps      = MPI::sum(n_substeps, communicator);
    total.n_cells_crossed = MPI::sum(n_cells_crossed, communicator);
    for (const auto &of_rank : MPI::all_gather(communicator, left))
      for (const auto &[boundary, counts] : of_rank)
        for (unsigned int i = 0; i < 2; ++i)
          total.left[boundary][i] += counts[i];
    return total;
  }


  template <int dim>
  StreamlineConvection<dim>::StreamlineConvection(
    const Mesh<dim>                                      &mesh,
    const ConvectionParameters                           &parameters,
    const std::map<dealii::types::boundary_id, WallKind> &walls)
    : mesh_(mesh)
  {
    AssertThrow(parameters.substep_courant_number > 0 &&
                  parameters.substep_courant_number <= 1,
                dealii::ExcMessage(
                  "The 'Substep Courant number' of the particles must be "
                  "greater than 0 and not above 1, for example 0.5."));
    AssertThrow(parameters.integrator == "rk2" ||
                  parameters.integrator == "rk4",
                dealii::ExcMessage("The particles' 'Integrator' must be 'rk2' "
                                   "or 'rk4', not '" +
                                   parameters.integrator + "'."));
    settings.scheme  = parameters.integrator == "rk2" ? StreamlineScheme::rk2
                                                      : StreamlineScheme::rk4;
    settings.substep = parameters.substep_courant_number;
    settings.walls   = walls;
  }


  template <int dim>
  ConvectionReport
  StreamlineConvection<dim>::move(Population<dim>         &population,
                                  const CellVelocity<dim> &velocity,
                                  const double             dt) const
  {
    Assert(dt >= 0, dealii::ExcMessage("Particles only go forward in time."));
    const StreamlineWalk<dim> walk(mesh_.graph(), velocity, settings, 1.);

    WalkEffort effort;
    auto       travellers = depart(population, walk, dt, effort);
    walk_on_other_ranks(walk,
                        mesh_.triangulation().get_communicator(),
                        travellers,
                        effort);
    const std::size_t n_stored = arrive(population, walk, travellers);

    ConvectionReport report;
    report.n_moved         = travellers.size();
    report.n_substeps      = effort.n_substeps;
    report.n_cells_crossed = effort.n_cells_crossed;
    if (n_stored < travellers.size())
      count_missing<dim>(travellers, report);
    return report;
  }


  template <int dim>
  std::vector<Foot<dim>>
  StreamlineConvection<dim>::trace_back(
    const std::vector<unsigned int>       &cells,
    const std::vector<dealii::Point<dim>> &reference_points,
    const CellVelocity<dim>               &velocity,
    const CellField<dim, 1>               &level_set,
    const double                           dt) const
  {
    AssertDimension(cells.size(), reference_points.size());
    const MPI_Comm communicator = mesh_.triangulation().get_communicator();
    const StreamlineWalk<dim> walk(mesh_.graph(), velocity, settings, -1.);

    std::vector<Traveller<dim, Question>> travellers;
    travellers.reserve(cells.size());
    for (unsigned int i = 0; i < cells.size(); ++i)
      travellers.push_back(
        {Walker<dim>::start(cells[i], reference_points[i], dt),
         {dealii::Utilities::MPI::this_mpi_process(communicator), i}});
    WalkEffort effort;
    for (auto &traveller : travellers)
      walk.walk(traveller.walker, effort);
    walk_on_other_ranks(walk, communicator, travellers, effort);

    std::map<unsigned int, std::vector<Answer<dim>>> answers;
    for (const auto &[walker, question] : travellers)
      if (walker.fate != Fate::lost)
        answers[question.rank].push_back(
          answer(walk, walker, question.index, velocity, level_set));

    std::vector<Foot<dim>> feet;
    feet.reserve(cells.size());
    for (unsigned int i = 0; i < cells.size(); ++i)
      feet.push_back(
        to_foot(answer(walk,
                       Walker<dim>::start(cells[i], reference_points[i], dt),
                       i,
                       velocity,
                       level_set),
                false));
    for (const auto &[rank, list] : send_plain(communicator, answers))
      for (const Answer<dim> &a : list)
        feet[a.index] = to_foot(a, true);
    return feet;
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::StreamlineConvection)
