// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/ignored_signals.h>

#include <csignal>

namespace Thalweg
{
  namespace
  {
    constexpr int most = 64;

    // No constructor may touch these: they are written before any has run.
    bool is_noted = false;
    bool is_ignored[most + 1];

    struct NoteOnLoading
    {
      NoteOnLoading()
      {
        note_ignored_signals();
      }
    } const note_on_loading;
  } // namespace



  void
  note_ignored_signals()
  {
    if (is_noted)
      return;
    is_noted = true;
    for (int number = 1; number <= most; ++number)
      {
        struct sigaction action;
        is_ignored[number] = ::sigaction(number, nullptr, &action) == 0 &&
                             action.sa_handler == SIG_IGN;
      }
  }



  bool
  was_ignored(const int number)
  {
    return number > 0 && number <= most && is_ignored[number];
  }
} // namespace Thalweg
