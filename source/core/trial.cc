// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/trial.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Thalweg
{
  namespace
  {
    void
    limit(const int resource, const rlim_t value)
    {
      struct rlimit limits;
      if (::getrlimit(resource, &limits) != 0)
        return;
      limits.rlim_cur = std::min(value, limits.rlim_max);
      ::setrlimit(resource, &limits);
    }


    /// The bytes of address space that this process has.
    rlim_t
    address_space()
    {
      std::ifstream file("/proc/self/statm");
      rlim_t        pages = 0;
      file >> pages;
      return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
    }


    /// What the new process does; it never returns.
    [[noreturn]] void
    do_in_child(const std::function<void()> &work,
                const TrialLimits           &limits,
                const int                    pipe)
    {
      for (const int signal : {SIGTERM,
                               SIGINT,
                               SIGSEGV,
                               SIGABRT,
                               SIGFPE,
                               SIGBUS,
                               SIGILL,
                               SIGXCPU,
                               SIGALRM})
        std::signal(signal, SIG_DFL);
      limit(RLIMIT_CORE, 0);
      limit(RLIMIT_CPU, limits.seconds);
      limit(RLIMIT_AS,
            address_space() + static_cast<rlim_t>(limits.gigabytes * 1e9));
      // What waits forever takes no time of a processor.
      ::alarm(20 * limits.seconds);
      // Libraries print what went wrong.
      const int nowhere = ::open("/dev/null", O_WRONLY);
      for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
        ::dup2(nowhere, stream);
      std::string message;
      try
        {
          work();
        }
      catch (const std::bad_alloc &)
        {
          message = "it needs more memory than can be given to it";
        }
      catch (const std::exception &exception)
        {
          message = message_of(exception);
          if (message.empty())
            message = "unknown";
        }
      catch (...)
        {
          message = "unknown";
        }
      const ssize_t written = ::write(pipe, message.data(), message.size());
      ::_exit(written == static_cast<ssize_t>(message.size()) ? 0 : 1);
    }


    std::string
    read_all(const int pipe)
    {
      std::string text;
      char        buffer[4096];
      while (true)
        {
          const ssize_t n = ::read(pipe, buffer, sizeof(buffer));
          if (n < 0 && errno == EINTR)
            continue;
          if (n <= 0)
            return text;
          text.append(buffer, n);
        }
    }


    std::string
    fault_of(const int status, const TrialLimits &limits)
    {
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return "";
      const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
      if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM)
        return "it took longer than " + std::to_string(limits.seconds) + " s";
      return signal == 0
               ? "it ended"
               : "it crashed (" + std::string(::strsignal(signal)) + ")";
    }
  } // namespace



  std::string
  fault_in_trial(const std::function<void()> &work, const TrialLimits &limits)
  {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
      return std::string("no pipe for a trial: ") + std::strerror(errno);
    const pid_t child = ::fork();
    if (child == 0)
      do_in_child(work, limits, ends[1]);
    ::close(ends[1]);
    if (child < 0)
      {
        ::close(ends[0]);
        return std::string("no process for a trial: ") + std::strerror(errno);
      }
    const std::string message = read_all(ends[0]);
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    return message.empty() ? fault_of(status, limits) : message;
  }
} // namespace Thalweg
