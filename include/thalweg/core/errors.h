// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_errors_h
#define thalweg_core_errors_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Thalweg
{
  /// A step failed, on all processes, but may be repeated with half the size: a
  /// solver that did not converge, for example.
  class StepFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// No size of the next step is of use; the state before it is a good one. On
  /// all processes.
  class StepRefused : public dealii::ExcMessage
  {
  public:
    using dealii::ExcMessage::ExcMessage;
  };

  /// The text of @p exception as a user should see it: for deal.II's
  /// exceptions the message alone.
  std::string
  message_of(const std::exception &exception);

  /// Does @p test, and appends the message of what it throws to @p faults.
  void
  collect_fault(std::vector<std::string>    &faults,
                const std::function<void()> &test);

  /**
   * @brief Runs @p program and ends all processes if it fails anywhere.
   *
   * An exception becomes one message on the error stream. If all processes
   * fail together, as they do over bad input, the root process speaks and
   * the function returns; if only some fail, the first of them speaks and
   * aborts the others, which may be waiting for it.
   *
   * @param communicator all processes of the run
   * @param program returns the exit code
   * @return what @p program returned, or 1 after a failure
   */
  int
  run_guarded(const MPI_Comm communicator, const std::function<int()> &program);

  /**
   * @brief Does @p work on the root process alone, and lets all processes
   * fail if it fails.
   * @throws dealii::ExcMessage on every process, with the root's message
   */
  void
  on_root(const MPI_Comm communicator, const std::function<void()> &work);

  /**
   * @brief Does @p work, in which processes do not wait for each other, on
   * all of them, and lets all fail if one fails.
   * @throws dealii::ExcMessage on every process, with the message of the first
   *   that failed
   */
  void
  on_all(const MPI_Comm communicator, const std::function<void()> &work);
} // namespace Thalweg

#endif
