// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/exceptions.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace Thalweg
{
  namespace
  {
    /// Waits for all processes to come here too.
    /// @return whether they did
    bool
    all_fail_too(const MPI_Comm communicator)
    {
      using namespace std::chrono;
      // Processes that fail alone at the same time take turns, so that one
      // message is read and not several at once.
      const auto patience =
        milliseconds(1000) +
        milliseconds(200) *
          std::min(dealii::Utilities::MPI::this_mpi_process(communicator), 20u);
      const auto  start = steady_clock::now();
      MPI_Request request;
      MPI_Ibarrier(communicator, &request);
      int all_here = 0;
      while (all_here == 0 && steady_clock::now() - start < patience)
        {
          MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
          std::this_thread::sleep_for(milliseconds(1));
        }
      return all_here != 0;
    }


    /// Says what MPI says, and ends all processes.
    void
    fail_in_mpi(MPI_Comm *communicator, int *code, ...)
    {
      char text[MPI_MAX_ERROR_STRING] = "";
      int  length                     = 0;
      MPI_Error_string(*code, text, &length);
      std::cerr << "Error on process "
                << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)
                << ": the processes cannot communicate any more. MPI says: "
                << bounded_message(text)
                << "\nHas one of them been killed, or has memory run out?"
                << std::endl;
      MPI_Abort(*communicator, 1);
    }


    /// Lets MPI's faults be reported in words on @p communicator and on what
    /// is made of it.
    void
    explain_mpi(const MPI_Comm communicator)
    {
      MPI_Errhandler handler;
      MPI_Comm_create_errhandler(fail_in_mpi, &handler);
      MPI_Comm_set_errhandler(communicator, handler);
      MPI_Errhandler_free(&handler);
    }


    /// Reports @p message and takes the other processes down.
    void
    fail(const MPI_Comm communicator, const std::string &message)
    {
      const unsigned int n_processes =
        dealii::Utilities::MPI::n_mpi_processes(communicator);
      const bool together = n_processes == 1 || all_fail_too(communicator);
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(communicator);
      if (!together || rank == 0)
        std::cerr << "Error"
                  << (together ? "" : " on process " + std::to_string(rank))
                  << ": " << bounded_message(message) << std::endl;
      if (!together)
        MPI_Abort(communicator, 1);
    }
  } // namespace


  std::string
  message_of(const std::exception &exception)
  {
    if (const auto *own =
          dynamic_cast<const dealii::ExceptionBase *>(&exception))
      {
        std::ostringstream text;
        own->print_info(text);
        const std::string message = trimmed(text.str());
        if (dynamic_cast<const dealii::StandardExceptions::ExcMessage *>(own))
          return message;
        const std::string name = own->get_exc_name();
        return message.empty() ? name : message + "\n(" + name + ")";
      }
    if (dynamic_cast<const std::bad_alloc *>(&exception) != nullptr)
      return "The memory of this machine does not suffice. Use fewer cells or "
             "particles, or more machines.";
    if (const auto *file =
          dynamic_cast<const std::filesystem::filesystem_error *>(&exception))
      return "'" + file->path1().string() +
             "' cannot be used: " + file->code().message() + ".";
    if (dynamic_cast<const std::logic_error *>(&exception) != nullptr)
      return std::string("Something that must not happen has happened inside "
                         "of the program ('") +
             exception.what() +
             "'). Please report this with the input, and look whether it has "
             "something unusual.";
    return exception.what();
  }



  void
  collect_fault(std::vector<std::string>    &faults,
                const std::function<void()> &test)
  {
    try
      {
        test();
      }
    catch (const std::exception &exception)
      {
        faults.push_back(message_of(exception));
      }
  }


  int
  run_guarded(const MPI_Comm communicator, const std::function<int()> &program)
  {
    // A communicator of its own: messages that were under way when the
    // failure came cannot be mistaken for those that settle it.
    explain_mpi(communicator);
    MPI_Comm own;
    MPI_Comm_dup(communicator, &own);
    int code = 1;
    try
      {
        code = program();
      }
    catch (const std::exception &exception)
      {
        fail(own, message_of(exception));
      }
    catch (const int error)
      {
        fail(own, "Trilinos failed with error " + std::to_string(error) + ".");
      }
    catch (...)
      {
        fail(own, "Something failed without saying what.");
      }
    MPI_Comm_free(&own);
    return code;
  }


  namespace
  {
    /// Does @p work. @return its message if it fails
    std::string
    failure_of(const std::function<void()> &work)
    {
      try
        {
          work();
        }
      catch (const std::exception &exception)
        {
          const std::string failure = message_of(exception);
          return failure.empty() ? "unknown" : failure;
        }
      return "";
    }
  } // namespace


  void
  on_root(const MPI_Comm communicator, const std::function<void()> &work)
  {
    std::string failure;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      failure = failure_of(work);
    failure = dealii::Utilities::MPI::broadcast(communicator, failure, 0);
    AssertThrow(failure.empty(), dealii::ExcMessage(failure));
  }


  void
  on_all(const MPI_Comm communicator, const std::function<void()> &work)
  {
    namespace MPI              = dealii::Utilities::MPI;
    std::string        failure = failure_of(work);
    const unsigned int n_ranks = MPI::n_mpi_processes(communicator);
    const unsigned int first =
      MPI::min(failure.empty() ? n_ranks : MPI::this_mpi_process(communicator),
               communicator);
    if (first == n_ranks)
      return;
    failure = MPI::broadcast(communicator, failure, first);
    throw dealii::ExcMessage(failure);
  }
} // namespace Thalweg
