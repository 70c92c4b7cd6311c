#include <thalweg/core/mpi_session.h>

namespace Thalweg
{
  MpiSession::MpiSession()
    : words{{"thalweg", "-skip_petscrc", "-options_left", "no"}}
    , arguments{{words[0].data(),
                 words[1].data(),
                 words[2].data(),
                 words[3].data(),
                 nullptr}}
    , n_arguments(words.size())
    , first(arguments.data())
    // One thread a process.
    , session(n_arguments, first, 1)
  {}
} // namespace Thalweg
