// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/options.h>

#include <gtest/gtest.h>

using namespace Thalweg;

namespace
{
  Options
  options(std::vector<const char *> words)
  {
    words.insert(words.begin(), "thalweg");
    return read_options(words.size(), words.data());
  }


  /// What is said of a wrong command line.
  std::string
  complaint(const std::vector<const char *> &words)
  {
    try
      {
        options(words);
      }
    catch (const std::exception &error)
      {
        return message_of(error);
      }
    return "";
  }
} // namespace


TEST(Options, AreRead)
{
  const Options all = options({"a.prm",
                               "--set",
                               "A/B = 1",
                               "--set=C=x=y",
                               "--output",
                               "out",
                               "--resume",
                               "--validate"});
  EXPECT_EQ(all.file, "a.prm");
  EXPECT_EQ(all.overrides, (std::vector<std::string>{"A/B = 1", "C=x=y"}));
  EXPECT_EQ(all.output, "out");
  EXPECT_TRUE(all.resume);
  EXPECT_TRUE(all.validate);
  EXPECT_EQ(all.parameters, "");
  EXPECT_FALSE(all.help || all.version);
  EXPECT_EQ(options({"--parameters"}).parameters, "prm");
  EXPECT_EQ(options({"--parameters=json"}).parameters, "json");
  EXPECT_EQ(options({"a.prm", "--parameters"}).file, "a.prm");
  EXPECT_TRUE(options({"--help"}).help);
  EXPECT_TRUE(options({"--version"}).version);
}


TEST(Options, WrongOnesAreExplained)
{
  EXPECT_NE(complaint({"a.prm", "--validat"}).find("did you mean '--validate'"),
            std::string::npos);
  EXPECT_NE(complaint({"a.prm", "-x"}).find("no option '-x'"),
            std::string::npos);
  EXPECT_NE(complaint({}).find("No input file"), std::string::npos);
  EXPECT_NE(complaint({"a.prm", "b.prm"}).find("'a.prm', 'b.prm'"),
            std::string::npos);
  EXPECT_NE(complaint({"a.prm", "--set"}).find("argument for option '--set'"),
            std::string::npos);
  EXPECT_NE(complaint({"--parameters=jsn"}).find("did you mean 'json'"),
            std::string::npos);
}


TEST(Options, VersionAndHelpNameWhatTheyShould)
{
  for (const char *name :
       {"deal.II", "Trilinos", "p4est", "index size", "vector width", "build"})
    EXPECT_NE(version_text().find(name), std::string::npos) << name;
  EXPECT_NE(help_text().find("--validate"), std::string::npos);
}
