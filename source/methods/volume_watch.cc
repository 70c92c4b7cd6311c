// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/volume_watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Whether @p part is above @p notable and has doubled since it was last
    /// said; then it is remembered.
    bool
    must_be_said(const double part, const double notable, double &said)
    {
      if (!(part > notable && part >= 2. * said))
        return false;
      said = part;
      return true;
    }

    std::string
    percent(const double part)
    {
      std::ostringstream text;
      text.precision(3);
      text << 100. * part << " %";
      return text.str();
    }

    std::string
    at(const double time)
    {
      std::ostringstream text;
      text << " (t = " << time << " s). ";
      return text.str();
    }

    const std::string again = " This is said again when it has doubled.";
  } // namespace



  std::vector<std::string>
  VolumeWatch::after_step(const Fluids &fluids, const State &state)
  {
    std::vector<std::string> warnings;
    // Of the fluid of which there has been less.
    const unsigned int rare =
      state.ever[1] > 0 && state.ever[1] < state.ever[0] ? 1 : 0;
    const double smaller =
      state.ever[rare] > 0 ? state.ever[rare] : state.ever[1 - rare];
    const std::string &name       = fluids[rare].name;
    const double       correction = std::abs(state.correction) / smaller;
    if (must_be_said(correction, notable, corrected))
      warnings.push_back(
        "The level set was shifted by " + percent(correction) +
        " of the volume of " + name + " to show what its particles carry" +
        at(state.time) +
        "Layers, jets or drops are thinner than the mesh can show: refine it "
        "there, or reduce 'Time/Courant number'." +
        again);
    const double debt = std::abs(state.debt) / smaller;
    if (must_be_said(debt, notable, missing))
      warnings.push_back(
        percent(debt) + " of the volume of " + name +
        (state.debt > 0 ? " is carried by particles where the mesh shows none"
                        : " is shown by the mesh, but not carried by "
                          "particles") +
        at(state.time) +
        "It is not lost: see 'debt of volume 1' in the statistics. A finer "
        "mesh shows more of it." +
        again);
    if (state.time < second_begins + 1.)
      return warnings;
    const double rate = std::abs(state.correction - old_correction) / smaller /
                        (state.time - second_begins);
    if (must_be_said(rate, notable_rate, restored))
      warnings.push_back("The shift of the level set restores " +
                         percent(rate) + " of the volume of " + name +
                         " a second" + at(state.time) +
                         "The result is not to be trusted where that happens: "
                         "refine the mesh, or reduce 'Time/Courant number'." +
                         again);
    second_begins  = state.time;
    old_correction = state.correction;
    return warnings;
  }



  void
  VolumeWatch::keep(const Archive &archive)
  {
    archive.value("corrected", corrected);
    archive.value("missing", missing);
    archive.value("restored", restored);
    archive.value("second begins", second_begins);
    archive.value("old correction", old_correction);
  }
} // namespace Thalweg
