// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/descriptor.h>
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/pvd_record.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    const std::string header_end   = "<UnstructuredGrid>\n";
    const std::string footer_begin = " </UnstructuredGrid>";

    /// What stands between header and footer of the file that @p text is, where
    /// its cells are. @param place is set to where that begins
    std::string
    piece_of(const std::string &text, std::size_t &place)
    {
      place = text.find(header_end);
      AssertThrow(place != std::string::npos, dealii::ExcInternalError());
      place += header_end.size();
      return text.substr(place, text.rfind(footer_begin) - place);
    }



    bool
    has_points(const std::string &piece)
    {
      return piece.find("NumberOfPoints=\"0\"") == std::string::npos;
    }



    /// MPI counts in int.
    constexpr std::size_t longest_message = 1 << 30;
    constexpr int         tag             = 0;

    void
    send_to_root(const MPI_Comm communicator, const std::string &text)
    {
      const std::uint64_t size = text.size();
      MPI_Send(&size, 1, MPI_UINT64_T, 0, tag, communicator);
      for (std::size_t sent = 0; sent < size; sent += longest_message)
        MPI_Send(text.data() + sent,
                 std::min(longest_message, size - sent),
                 MPI_CHAR,
                 0,
                 tag,
                 communicator);
    }



    std::string
    receive(const MPI_Comm communicator, const unsigned int rank)
    {
      std::uint64_t size = 0;
      MPI_Recv(
        &size, 1, MPI_UINT64_T, rank, tag, communicator, MPI_STATUS_IGNORE);
      std::string text(size, ' ');
      for (std::size_t got = 0; got < size; got += longest_message)
        MPI_Recv(text.data() + got,
                 std::min(longest_message, size - got),
                 MPI_CHAR,
                 rank,
                 tag,
                 communicator,
                 MPI_STATUS_IGNORE);
      return text;
    }



    /// A file that is written piece by piece. What fails is remembered, so that
    /// those that send the pieces need not know of it.
    class PieceWiseFile
    {
    public:
      explicit PieceWiseFile(const std::string &path)
        : path(path)
      {
        attempt([&]() {
          file = std::make_unique<Descriptor>(path + ".part",
                                              O_WRONLY | O_CREAT | O_TRUNC,
                                              "write");
        });
      }

      void
      append(const std::string &text)
      {
        attempt([&]() { file->write(bytes_of(text)); });
      }

      /// Gives the file its name. @throws dealii::ExcMessage if anything failed
      void
      finish()
      {
        attempt([&]() {
          file->close();
          rename_file(path + ".part", path);
        });
        if (failure.empty())
          return;
        std::error_code error;
        std::filesystem::remove(path + ".part", error);
        throw dealii::ExcMessage(failure);
      }

    private:
      template <typename Work>
      void
      attempt(const Work &work)
      {
        if (failure.empty())
          try
            {
              work();
            }
          catch (const dealii::ExcMessage &exception)
            {
              failure = message_of(exception);
            }
      }

      const std::string           path;
      std::unique_ptr<Descriptor> file;
      std::string                 failure;
    };



    /// Writes the pieces of all processes into one file: the root process does,
    /// which gets one after the other, since parallel files do not tell when
    /// the disk is full. Collective.
    /// @throws dealii::ExcMessage on all processes if that fails
    void
    write_together(const MPI_Comm     communicator,
                   const std::string &path,
                   const std::string &own)
    {
      namespace MPI = dealii::Utilities::MPI;
      std::size_t begin;
      std::string piece = piece_of(own, begin);
      const auto  n_full =
        MPI::sum<unsigned int>(has_points(piece), communicator);
      // Programs that read these files want no empty piece to come first.
      if (!has_points(piece) && n_full > 0)
        piece.clear();
      if (MPI::this_mpi_process(communicator) > 0)
        send_to_root(communicator, n_full > 0 ? piece : "");
      on_root(communicator, [&]() {
        PieceWiseFile file(path);
        file.append(own.substr(0, begin));
        file.append(piece);
        for (unsigned int r = 1; r < MPI::n_mpi_processes(communicator); ++r)
          file.append(receive(communicator, r));
        file.append(own.substr(own.rfind(footer_begin)));
        file.finish();
      });
    }
  } // namespace


  void
  PvdRecord::open(Context &context, const std::string &name)
  {
    this->context = &context;
    this->name    = name;
    series.open(context, name, {".pvd"});
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
    std::ostringstream own, record;
    data.write_vtu(own);
    const std::string file =
      name + "_" + dealii::Utilities::int_to_string(n_written, 4);
    on_root(context.communicator, [&]() { series.prepare(n_written == 0); });
    write_together(context.communicator,
                   series.path_of(n_written) + ".0.vtu",
                   own.str());
    files.emplace_back(time, name + "/" + file + ".pvtu");
    on_root(context.communicator, [&]() {
      data.write_pvtu_record(record, {file + ".0.vtu"});
      write_file(series.path_of(n_written) + ".pvtu", record.str());
      write_record(context);
    });
    ++n_written;
  }


  void
  PvdRecord::write_record(const Context &context) const
  {
    std::ostringstream text;
    dealii::DataOutBase::write_pvd_record(text, files);
    write_file(context.output_directory + "/" + name + ".pvd", text.str());
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
    AssertThrow(times.size() == names.size(),
                dealii::ExcMessage("the list of files of '" + name +
                                   "' in it is damaged."));
    if (!archive.is_restoring() || context->output_directory.empty())
      return;
    n_written = n_kept;
    files.clear();
    for (std::size_t i = 0; i < names.size(); ++i)
      files.emplace_back(times[i], names[i]);
    drop_missing_files();
    on_root(context->communicator, [&]() {
      series.drop_from(n_written);
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
  THALWEG_INSTANTIATE_WRITE(1, 2)
  THALWEG_INSTANTIATE_WRITE(1, 3)
  THALWEG_INSTANTIATE_WRITE(0, 3)
#undef THALWEG_INSTANTIATE_WRITE
} // namespace Thalweg
