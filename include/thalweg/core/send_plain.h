// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_send_plain_h
#define thalweg_core_send_plain_h

#include <deal.II/base/mpi.h>

#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Sends lists of plain objects to some ranks. Collective.
   * @param to_send a list for each rank that is to get one
   * @return the list that each rank has sent, the own one included
   */
  template <typename T>
  std::map<unsigned int, std::vector<T>>
  send_plain(const MPI_Comm                                communicator,
             const std::map<unsigned int, std::vector<T>> &to_send)
  {
    static_assert(std::is_trivially_copyable<T>::value,
                  "Only plain memory can be sent like this.");
    std::map<unsigned int, std::vector<char>> bytes_to_send;
    for (const auto &[rank, list] : to_send)
      {
        auto &bytes = bytes_to_send[rank];
        bytes.resize(list.size() * sizeof(T));
        std::memcpy(bytes.data(), list.data(), bytes.size());
      }
    std::map<unsigned int, std::vector<T>> received;
    for (const auto &[rank, bytes] :
         dealii::Utilities::MPI::some_to_some(communicator, bytes_to_send))
      {
        auto &list = received[rank];
        list.resize(bytes.size() / sizeof(T));
        std::memcpy(list.data(), bytes.data(), bytes.size());
      }
    return received;
  }
} // namespace Thalweg

#endif
