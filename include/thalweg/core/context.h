// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_context_h
#define thalweg_core_context_h

#include <thalweg/core/log.h>
#include <thalweg/core/results.h>
#include <thalweg/core/run_lock.h>
#include <thalweg/core/statistics.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <iostream>
#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief What every part of a run shares: processes, log, timers,
   * statistics and the place for results.
   */
  struct Context
  {
    /// @param communicator the processes of this run
    explicit Context(const MPI_Comm communicator)
      : communicator(communicator)
      , is_root(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      , log(is_root)
      , timers(std::cout,
               dealii::TimerOutput::never,
               dealii::TimerOutput::wall_times)
    {}

    MPI_Comm            communicator;
    bool                is_root;
    Log                 log;
    dealii::TimerOutput timers;
    Statistics          statistics;
    /// Whether statistics say what each part of a step does to the energy.
    bool has_energy_budget = false;
    /// Where all files go; empty: no file is written.
    std::string output_directory;
    /// Of the root process, if there are files: keeps the directory for this
    /// run.
    std::unique_ptr<RunLock> lock;
    /// Of the root process: what was written there.
    Results results;
    /// Whether this run goes on from a checkpoint: files in the directory are
    /// then kept, cut to what they were and continued. Set it before anything
    /// is opened.
    bool resumed = false;
    /// Stands as a comment (#) above the header of tables; empty: none.
    std::string table_comment;
  };
} // namespace Thalweg

#endif
