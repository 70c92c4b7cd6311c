// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/volume_books.h>

#include <vector>

namespace Thalweg
{
  namespace
  {
    void
    add_to(FluidVolumes &sum, const FluidVolumes &volumes)
    {
      for (unsigned int f = 0; f < 2; ++f)
        sum[f] += volumes[f];
    }
  } // namespace


  FluidVolumes
  sum_over_ranks(const std::vector<FluidVolumes> &volumes_of_cells,
                 const MPI_Comm                   communicator)
  {
    FluidVolumes sum{};
    for (const FluidVolumes &volumes : volumes_of_cells)
      add_to(sum, volumes);
    for (double &volume : sum)
      volume = dealii::Utilities::MPI::sum(volume, communicator);
    return sum;
  }


  FluidVolumes
  VolumeBooks::in() const
  {
    FluidVolumes sum{};
    for (const auto &[id, passage] : boundaries)
      add_to(sum, passage.in);
    return sum;
  }


  FluidVolumes
  VolumeBooks::out() const
  {
    FluidVolumes sum{};
    for (const auto &[id, passage] : boundaries)
      add_to(sum, passage.out);
    return sum;
  }


  FluidVolumes
  VolumeBooks::inside() const
  {
    FluidVolumes volumes = start;
    for (unsigned int f = 0; f < 2; ++f)
      volumes[f] += in()[f] - out()[f] - lost[f];
    return volumes;
  }


  void
  VolumeBooks::add(const VolumeBooks &of_rank, const MPI_Comm communicator)
  {
    std::vector<double> sums{of_rank.lost[0],
                             of_rank.lost[1],
                             of_rank.owed[0],
                             of_rank.owed[1]};
    for (const auto &[id, passage] : of_rank.boundaries)
      for (const FluidVolumes &volumes : {passage.in, passage.out})
        sums.insert(sums.end(), volumes.begin(), volumes.end());
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    auto next = sums.begin();
    for (double &volume : lost)
      volume += *next++;
    for (double &volume : owed)
      volume = *next++;
    for (const auto &[id, passage] : of_rank.boundaries)
      for (FluidVolumes *volumes : {&boundaries[id].in, &boundaries[id].out})
        for (double &volume : *volumes)
          volume += *next++;
  }


  void
  VolumeBooks::keep(const Archive &archive)
  {
    std::vector<double> values{
      start[0], start[1], lost[0], lost[1], owed[0], owed[1]};
    std::vector<unsigned int> ids;
    for (const auto &[id, passage] : boundaries)
      {
        ids.push_back(id);
        for (const FluidVolumes &volumes : {passage.in, passage.out})
          values.insert(values.end(), volumes.begin(), volumes.end());
      }
    archive.value("boundaries", ids);
    archive.value("volumes", values);
    AssertThrow(values.size() == 6 + 4 * ids.size(),
                dealii::ExcMessage("the volumes at boundaries in it are "
                                   "damaged."));
    auto next = values.begin();
    for (double *value :
         {&start[0], &start[1], &lost[0], &lost[1], &owed[0], &owed[1]})
      *value = *next++;
    boundaries.clear();
    for (const unsigned int id : ids)
      for (FluidVolumes *volumes : {&boundaries[id].in, &boundaries[id].out})
        for (double &volume : *volumes)
          volume = *next++;
  }
} // namespace Thalweg
