// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/options.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/config.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>
#include <deal.II/base/vectorization.h>

#include <Trilinos_version.h>
#include <boost/program_options.hpp>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    namespace po = boost::program_options;

    po::options_description
    visible_options()
    {
      po::options_description options("Options");
      auto                    add = options.add_options();
      add("set",
          po::value<std::vector<std::string>>()->composing()->value_name(
            "'A/B/C=VALUE'"),
          "override the parameter C in subsection B of section A; may be "
          "given any number of times");
      add("output",
          po::value<std::string>()->value_name("DIR"),
          "write all results to DIR");
      add("resume", "go on from the last checkpoint");
      add("validate",
          "check the input and everything that follows from it without "
          "running; list all faults");
      add("parameters",
          po::value<std::string>()->implicit_value("prm")->value_name("FORMAT"),
          "print the complete documented input, with the settings of FILE.prm "
          "if one is given; --parameters=json and --parameters=markdown print "
          "it in those formats");
      add("help", "print this text");
      add("version", "print the versions of Thalweg and of its libraries");
      return options;
    }


    /// The names of all options, as they are typed.
    std::vector<std::string>
    option_names()
    {
      std::vector<std::string>      names;
      const po::options_description options = visible_options();
      for (const auto &option : options.options())
        names.push_back("--" + option->long_name());
      return names;
    }


    po::variables_map
    parse(const int argc, const char *const *argv)
    {
      po::options_description all = visible_options();
      all.add_options()("file", po::value<std::vector<std::string>>());
      po::positional_options_description positional;
      positional.add("file", -1);

      // Without guessing: an abbreviation may become ambiguous some day.
      using namespace po::command_line_style;
      po::variables_map values;
      po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(positional)
                  .style(unix_style & ~allow_guessing)
                  .run(),
                values);
      return values;
    }


    std::string
    text_of(const po::variables_map &values, const std::string &name)
    {
      return values.count(name) > 0 ? values[name].as<std::string>() : "";
    }


    Options
    gather(const po::variables_map &values)
    {
      Options options;
      if (values.count("file") > 0)
        {
          const auto &files = values["file"].as<std::vector<std::string>>();
          AssertThrow(files.size() == 1,
                      dealii::ExcMessage(
                        "One run has one input file, but there are " +
                        std::to_string(files.size()) + ": '" +
                        joined(files, "', '") +
                        "'. Options take values as in --output DIR and "
                        "--set 'A/B=value'."));
          options.file = files[0];
        }
      if (values.count("set") > 0)
        options.overrides = values["set"].as<std::vector<std::string>>();
      options.output     = text_of(values, "output");
      options.parameters = text_of(values, "parameters");
      options.resume     = values.count("resume") > 0;
      options.validate   = values.count("validate") > 0;
      options.help       = values.count("help") > 0;
      options.version    = values.count("version") > 0;
      return options;
    }
  } // namespace


  Options
  read_options(const int argc, const char *const *argv)
  {
    Options options;
    try
      {
        options = gather(parse(argc, argv));
      }
    catch (const po::unknown_option &error)
      {
        AssertThrow(false,
                    dealii::ExcMessage(
                      "There is no option '" + error.get_option_name() + "'" +
                      did_you_mean(
                        nearest(error.get_option_name(), option_names())) +
                      "\n'thalweg --help' lists the options."));
      }
    catch (const po::error &error)
      {
        AssertThrow(false,
                    dealii::ExcMessage(
                      std::string("The command line is wrong: ") +
                      error.what() + ".\n'thalweg --help' lists the options."));
      }

    const std::vector<std::string> formats = {"prm", "json", "markdown"};
    const std::string             &format  = options.parameters;
    AssertThrow(format.empty() || format == "prm" || format == "json" ||
                  format == "markdown",
                dealii::ExcMessage("'--parameters=" + format +
                                   "' is not possible" +
                                   did_you_mean(nearest(format, formats)) +
                                   "\nThe formats are prm, json and markdown; "
                                   "an input file goes before this option."));
    AssertThrow(options.help || options.version || !format.empty() ||
                  !options.file.empty(),
                dealii::ExcMessage("No input file was given. Write 'thalweg "
                                   "FILE.prm'; 'thalweg --help' says more."));
    return options;
  }


  std::string
  help_text()
  {
    std::ostringstream text;
    text << "Thalweg simulates flows of two fluids with particles on adaptive "
            "meshes.\n\n"
         << "Usage: thalweg FILE.prm [OPTIONS]\n"
         << "       mpirun -np N thalweg FILE.prm [OPTIONS]\n\n"
         << visible_options()
         << "\n'thalweg --parameters' lists everything that FILE.prm can "
            "contain.\n";
    return text.str();
  }


  std::string
  version_text()
  {
    std::ostringstream text;
    text << "Thalweg      " << THALWEG_VERSION << "\ndeal.II      "
         << DEAL_II_PACKAGE_VERSION << "\nTrilinos     "
         << TRILINOS_VERSION_STRING << "\np4est        "
         << DEAL_II_P4EST_VERSION_MAJOR << '.' << DEAL_II_P4EST_VERSION_MINOR
         << '.' << DEAL_II_P4EST_VERSION_SUBMINOR << "\nindex size   "
         << 8 * sizeof(dealii::types::global_dof_index)
         << " bits\nvector width " << dealii::VectorizedArray<double>::size()
         << " double\nbuild type   " << THALWEG_BUILD_TYPE << '\n';
    return text.str();
  }
} // namespace Thalweg
