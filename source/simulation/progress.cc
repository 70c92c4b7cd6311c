// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/simulation/progress.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// A duration as people read it.
    std::string
    duration(const double seconds)
    {
      char text[32];
      if (!std::isfinite(seconds) || seconds < 0)
        return "?";
      const long s = std::lround(seconds);
      if (s < 60)
        std::snprintf(text, sizeof(text), "%ld s", s);
      else if (s < 3600)
        std::snprintf(text, sizeof(text), "%ld min %02ld s", s / 60, s % 60);
      else
        std::snprintf(
          text, sizeof(text), "%ld h %02ld min", s / 3600, s % 3600 / 60);
      return text;
    }



    double
    seconds_since(const std::chrono::steady_clock::time_point &begin)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           begin)
        .count();
    }
  } // namespace



  Progress::Progress(Context &context)
    : context(context)
    , start(Clock::now())
    , last_line(Clock::now() - std::chrono::hours(1))
  {}



  void
  Progress::report(const unsigned int step,
                   const double       time,
                   const double       end_time,
                   const double       dt,
                   const double       courant_number,
                   const std::string &headline,
                   const bool         force)
  {
    if (!has_begun)
      {
        has_begun  = true;
        first_step = step;
        first_time = time - dt;
      }
    if (!force && seconds_since(last_line) < .5)
      return;
    last_line = Clock::now();
    char text[256];
    std::snprintf(text,
                  sizeof(text),
                  "step %6u   t = %9.4g of %.4g s   dt = %8.2e s   "
                  "Co = %5.2f   ",
                  step,
                  time,
                  end_time,
                  dt,
                  courant_number);
    const double left =
      seconds_since(start) * (end_time - time) / (time - first_time);
    context.log.line(text + headline + "   left: " + duration(left));
  }



  void
  Progress::summarize(const unsigned int n_steps)
  {
    const std::string lost = "particles lost in all";
    if (context.statistics.has(lost) && context.statistics.get(lost) > 0)
      {
        std::ostringstream message;
        message << static_cast<std::uint64_t>(context.statistics.get(lost))
                << " particles were lost in all, which should not happen: see "
                   "the column 'particles lost' of the statistics.";
        context.log.warning(message.str());
      }
    const double total = seconds_since(start);
    const auto   times =
      context.timers.get_summary_data(dealii::TimerOutput::total_wall_time);
    context.log.line("");
    const std::string steps =
      std::to_string(n_steps) + " steps" +
      (first_step > 1 ? ", of which this process did " +
                          std::to_string(n_steps + 1 - first_step) + ","
                      : "");
    context.log.line("Ended after " + steps + " and " + duration(total) +
                     ". Wall time by phase:");
    std::ostringstream csv;
    csv << "phase,wall time [s],part\n";
    double rest = total;
    for (const auto &[phase, seconds] : times)
      {
        char text[128];
        std::snprintf(text,
                      sizeof(text),
                      "  %-24s %10.3f s %6.1f %%",
                      phase.c_str(),
                      seconds,
                      100. * seconds / total);
        context.log.line(text);
        csv << phase << ',' << seconds << ',' << seconds / total << '\n';
        rest -= seconds;
      }
    char text[128];
    std::snprintf(text,
                  sizeof(text),
                  "  %-24s %10.3f s %6.1f %%",
                  "everything else",
                  rest,
                  100. * rest / total);
    context.log.line(text);
    csv << "everything else," << rest << ',' << rest / total << '\n';
    if (!context.output_directory.empty())
      on_root(context.communicator, [&]() {
        write_file(context.output_directory + "/timers.csv", csv.str());
      });
  }
} // namespace Thalweg
