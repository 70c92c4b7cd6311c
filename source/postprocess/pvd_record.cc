#include <thalweg/core/errors.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/pvd_record.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>

namespace Thalweg
{
  void
  PvdRecord::open(Context &context, const std::string &name)
  {
    this->context = &context;
    this->name    = name;
    if (context.output_directory.empty())
      return;
    const std::string directory = context.output_directory + "/" + name;
    on_root(context.communicator, [&]() {
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      AssertThrow(!error,
                  dealii::ExcMessage("Cannot create the directory '" +
                                     directory + "': " + error.message() +
                                     "."));
    });
  }


  template <int dim, int spacedim>
  void
  PvdRecord::write(const Context                           &context,
                   dealii::DataOutInterface<dim, spacedim> &data,
                   const double                             time,
                   const unsigned int                       step)
  {
    if (context.output_directory.empty())
      return;
    dealii::DataOutBase::VtkFlags flags;
    flags.time  = time;
    flags.cycle = step;
    flags.compression_level =
      dealii::DataOutBase::VtkFlags::ZlibCompressionLevel::best_speed;
    flags.physical_units = {{"velocity", "m/s"},
                            {"pressure", "Pa"},
                            {"level_set", "m"},
                            {"density", "kg/m^3"}};
    data.set_flags(flags);
    const std::string file =
      data.write_vtu_with_pvtu_record(context.output_directory + "/" + name +
                                        "/",
                                      name,
                                      n_written++,
                                      context.communicator,
                                      4,
                                      1);
    files.emplace_back(time, name + "/" + file);
    on_root(context.communicator, [&]() { write_record(context); });
  }


  void
  PvdRecord::write_record(const Context &context) const
  {
    const std::string path = context.output_directory + "/" + name + ".pvd";
    const std::string temporary = path + ".new";
    std::ofstream     stream(temporary, std::ios::trunc);
    dealii::DataOutBase::write_pvd_record(stream, files);
    stream.close();
    AssertThrow(stream,
                dealii::ExcMessage("Cannot write to '" + temporary +
                                   "'. May you write there, and is the disk "
                                   "full?"));
    std::filesystem::rename(temporary, path);
  }


  void
  PvdRecord::keep(const Archive &archive, const bool without_last)
  {
    const unsigned int       n_dropped = without_last && !files.empty();
    unsigned int             n_kept    = n_written - n_dropped;
    std::vector<double>      times;
    std::vector<std::string> names;
    for (std::size_t i = 0; i + n_dropped < files.size(); ++i)
      {
        times.push_back(files[i].first);
        names.push_back(files[i].second);
      }
    archive.value("times", times);
    archive.value("files", names);
    archive.value("number", n_kept);
    if (!archive.is_restoring() || context->output_directory.empty())
      return;
    n_written = n_kept;
    files.clear();
    for (std::size_t i = 0; i < names.size(); ++i)
      files.emplace_back(times[i], names[i]);
    drop_missing_files();
    on_root(context->communicator, [&]() {
      if (!files.empty())
        write_record(*context);
      else
        std::filesystem::remove(context->output_directory + "/" + name +
                                ".pvd");
    });
  }


  void
  PvdRecord::drop_missing_files()
  {
    std::vector<unsigned int> is_there(files.size());
    on_root(context->communicator, [&]() {
      for (std::size_t i = 0; i < files.size(); ++i)
        is_there[i] = std::filesystem::exists(context->output_directory + "/" +
                                              files[i].second);
    });
    is_there =
      dealii::Utilities::MPI::broadcast(context->communicator, is_there);
    std::vector<std::pair<double, std::string>> found;
    for (std::size_t i = 0; i < files.size(); ++i)
      if (is_there[i] != 0)
        found.push_back(files[i]);
    if (found.size() < files.size())
      context->log.warning("Of the " + std::to_string(files.size()) +
                           " files that '" + context->output_directory + "/" +
                           name + ".pvd' lists, " +
                           std::to_string(files.size() - found.size()) +
                           " are gone; it goes on without them.");
    files = found;
  }


#define THALWEG_INSTANTIATE_WRITE(dim, spacedim)                            \
  template void PvdRecord::write(const Context &,                           \
                                 dealii::DataOutInterface<dim, spacedim> &, \
                                 const double,                              \
                                 const unsigned int);
  THALWEG_INSTANTIATE_WRITE(2, 2)
  THALWEG_INSTANTIATE_WRITE(3, 3)
  THALWEG_INSTANTIATE_WRITE(0, 2)
  THALWEG_INSTANTIATE_WRITE(0, 3)
#undef THALWEG_INSTANTIATE_WRITE
} // namespace Thalweg
