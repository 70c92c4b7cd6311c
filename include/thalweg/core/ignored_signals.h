// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_ignored_signals_h
#define thalweg_core_ignored_signals_h

namespace Thalweg
{
  /**
   * @brief Notes which signals the one who started the process wants to be
   * ignored, as nohup does with SIGHUP; once, later calls do nothing.
   *
   * Libraries catch signals when they are loaded (UCX below Open MPI 5 does so
   * with SIGHUP): a program calls this before their constructors, from its
   * `.preinit_array`. Without that it is what is so when this library is
   * loaded.
   */
  void
  note_ignored_signals();

  /// Whether a signal was to be ignored when the process started.
  bool
  was_ignored(const int number);
} // namespace Thalweg

#endif
