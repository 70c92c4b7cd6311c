// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/parameter_file.h>
#include <thalweg/core/section.h>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace Thalweg;

namespace
{
  /// What a small program may declare.
  class ParameterFileTest : public ::testing::Test
  {
  protected:
    ParameterFileTest()
    {
      const Section root(prm);
      const Section time = root.enter("Time");
      time.add("End time",
               end_time,
               "s",
               "When the run ends.",
               dealii::Patterns::Double(0.));
      time.add("Steps", steps, "", "How many at the most.");
      root.enter("Fluids").enter("water").add("Density",
                                              density,
                                              "kg/m^3",
                                              "Mass by volume.");
      root.enter("Solver").add("Model",
                               model,
                               "",
                               "Which one.",
                               dealii::Patterns::Selection(
                                 "fractional step|monolithic"));
    }

    /// The only fault in @p text; empty without one.
    std::string
    fault(const std::string &text, const std::string &option = "")
    {
      ParameterFile input(text, "a.prm");
      if (!option.empty())
        input.override(option);
      const std::vector<std::string> faults = input.apply(prm);
      EXPECT_LE(faults.size(), 1u) << ::testing::PrintToString(faults);
      return faults.empty() ? "" : faults[0];
    }

    dealii::ParameterHandler prm;
    double                   end_time = 1.;
    unsigned int             steps    = 10;
    double                   density  = 1000.;
    std::string              model    = "fractional step";
  };
} // namespace


TEST_F(ParameterFileTest, SetsVariables)
{
  EXPECT_EQ(fault("# comment\n"
                  "subsection Time # another\n"
                  "\tset  End   time= 2.5 # s\r\n"
                  "end\n"
                  "subsection Fluids\n subsection water\n"
                  "  set Density = 9\\\n"
                  "    98\n end\nend\n"
                  "subsection Solver\n set Model = mono\\\n   lithic\nend",
                  "Time/Steps=7"),
            "");
  EXPECT_EQ(end_time, 2.5);
  EXPECT_EQ(steps, 7u);
  EXPECT_EQ(density, 998.);
  EXPECT_EQ(model, "monolithic");
}


TEST_F(ParameterFileTest, OptionOverridesTheFile)
{
  EXPECT_EQ(fault("subsection Time\nset End time = 2\nend", "Time/End time=3"),
            "");
  EXPECT_EQ(end_time, 3.);
  ParameterFile input("set Dimension = 2", "a.prm");
  EXPECT_EQ(input.value("Dimension", "5"), "2");
  EXPECT_EQ(input.value("Other", "5"), "5");
  input.override("Dimension=3");
  EXPECT_EQ(input.value("Dimension", "5"), "3");
}


TEST_F(ParameterFileTest, NamesTheNearestRightName)
{
  EXPECT_EQ(fault("subsection Fluids\nsubsection water\nset Desnity = 1\n"
                  "end\nend"),
            "a.prm:3: unknown parameter 'Fluids/water/Desnity'; did you mean "
            "'Fluids/water/Density'?");
  EXPECT_EQ(fault("set End time = 1"),
            "a.prm:1: unknown parameter 'End time'; did you mean "
            "'Time/End time'?");
  EXPECT_EQ(fault("subsection Tiem\nset End time = 1\nend"),
            "a.prm:1: unknown section 'Tiem'; did you mean 'Time'?");
  EXPECT_EQ(fault("subsection Zzz\nend"), "a.prm:1: unknown section 'Zzz'");
  EXPECT_EQ(fault("", "Tme/End time=1"),
            "--set 'Tme/End time=1': unknown parameter 'Tme/End time'; did "
            "you mean 'Time/End time'?");
  EXPECT_EQ(fault("subsection Solver\nset Model = monolitic\nend"),
            "a.prm:2: 'Solver/Model' is 'monolitic', but must be "
            "'fractional step' or 'monolithic'; did you mean 'monolithic'?");
  EXPECT_EQ(fault("set Time = 1"),
            "a.prm:1: unknown parameter 'Time'; it is a section, write "
            "'subsection Time'");
  EXPECT_EQ(fault("subsection Time\nsubsection Steps\nend\nend"),
            "a.prm:2: unknown section 'Time/Steps'; it is a parameter, write "
            "'set Steps = ...'");
}


TEST_F(ParameterFileTest, RefusesValuesThatDoNotFit)
{
  EXPECT_EQ(fault("subsection Time\nset End time = -1\nend"),
            "a.prm:2: 'Time/End time' is '-1', but must be a number that is "
            "at least 0");
  EXPECT_EQ(fault("subsection Time\nset End time =\nend"),
            "a.prm:2: 'Time/End time' is '', but must be a number that is "
            "at least 0");
  EXPECT_EQ(fault("subsection Time\nset Steps = 2.5\nend"),
            "a.prm:2: 'Time/Steps' is '2.5', but must be a whole number that "
            "is at least 0");
  EXPECT_EQ(end_time, 1.);
  EXPECT_EQ(steps, 10u);
}


TEST_F(ParameterFileTest, RefusesNegativeCounts)
{
  EXPECT_NE(fault("subsection Time\nset Steps = -1\nend"), "");
  EXPECT_EQ(steps, 10u);
}


TEST_F(ParameterFileTest, RefusesRepetition)
{
  EXPECT_EQ(fault("subsection Time\nset Steps = 2\nset Steps = 3\nend"),
            "a.prm:3: 'Time/Steps' is set twice, first to '2' (a.prm:2) and "
            "now to '3'; remove one of them");
}


TEST_F(ParameterFileTest, RefusesBrokenStructure)
{
  EXPECT_EQ(fault("subsection Time\nset Steps = 2\n"),
            "a.prm:1: 'end' is missing for the subsection 'Time' that begins "
            "here");
  EXPECT_EQ(fault("end\n"),
            "a.prm:1: 'end' without a 'subsection' that it could close");
  EXPECT_NE(fault("subsection Time\nste Steps = 2\nend")
              .find("a.prm:2: cannot understand 'ste Steps = 2'"),
            std::string::npos);
  EXPECT_EQ(fault("subsection Time\nset Steps 2\nend"),
            "a.prm:2: cannot understand 'set Steps 2'; write 'set NAME = "
            "VALUE'");
  EXPECT_EQ(fault("subsection Solver\nend\nsubsection\nend"),
            "a.prm:3: 'subsection' needs a name after it");
  EXPECT_EQ(fault("subsection Time\nend\\"),
            "a.prm:2: the last line ends with '\\', but no line follows that "
            "could continue it");
  EXPECT_EQ(fault("", "Time/Steps"),
            "--set 'Time/Steps': write --set 'Section/Subsection/Name=value'");
}


TEST_F(ParameterFileTest, ReportsAllFaultsAndAppliesTheRest)
{
  const ParameterFile            input("subsection Time\n"
                                       " set End tme = 2\n"
                                       " set End time = x\n"
                                       " set Steps = 3\n"
                                       "end\n"
                                       "foo\n",
                            "a.prm");
  const std::vector<std::string> faults = input.apply(prm);
  EXPECT_EQ(faults.size(), 3u);
  EXPECT_EQ(steps, 3u);
  try
    {
      throw_faults(faults);
      FAIL();
    }
  catch (const dealii::StandardExceptions::ExcMessage &error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("3 faults"), std::string::npos);
      for (const char *place : {"a.prm:2:", "a.prm:3:", "a.prm:6:"})
        EXPECT_NE(text.find(place), std::string::npos) << place;
    }
  EXPECT_NO_THROW(throw_faults({}));
}


TEST_F(ParameterFileTest, IncludesFilesBesideItself)
{
  namespace fs             = std::filesystem;
  const fs::path directory = fs::path(::testing::TempDir()) /
                             ("thalweg_prm_" + std::to_string(getpid()));
  fs::create_directories(directory / "base");
  std::ofstream(directory / "a.prm")
    << "include base/b.prm\nsubsection Time\nset Steps = 5\nend\n";
  std::ofstream(directory / "base" / "b.prm")
    << "include c.prm\nsubsection Time\nset Steps = 4\nend\n";
  std::ofstream(directory / "base" / "c.prm")
    << "subsection Time\nset End time = 6\nend\n";
  EXPECT_TRUE(ParameterFile((directory / "a.prm").string()).apply(prm).empty());
  EXPECT_EQ(steps, 5u);
  EXPECT_EQ(end_time, 6.);

  std::ofstream(directory / "base" / "c.prm") << "include c.prm\n";
  std::vector<std::string> faults =
    ParameterFile((directory / "base" / "c.prm").string()).apply(prm);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("includes itself"), std::string::npos) << faults[0];

  fs::remove(directory / "base" / "c.prm");
  faults = ParameterFile((directory / "a.prm").string()).apply(prm);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("b.prm:1: the input file '"), std::string::npos)
    << faults[0];
  fs::remove_all(directory);
}
