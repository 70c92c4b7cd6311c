// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/surface_chain.h>

#include <algorithm>
#include <numeric>

namespace Thalweg
{
  namespace
  {
    constexpr std::size_t none = static_cast<std::size_t>(-1);


    /// For each segment the one that begins at its end, or none.
    std::vector<std::size_t>
    successors(const std::vector<Segment> &segments)
    {
      std::vector<std::size_t> by_x(segments.size());
      std::iota(by_x.begin(), by_x.end(), 0);
      std::sort(by_x.begin(),
                by_x.end(),
                [&](const std::size_t a, const std::size_t b) {
                  return segments[a].begin[0] < segments[b].begin[0];
                });
      std::vector<std::size_t> next(segments.size(), none);
      for (std::size_t s = 0; s < segments.size(); ++s)
        {
          const dealii::Point<2> &end = segments[s].end;
          // Processes compute the same vertex with different round-off.
          const double tolerance = 1e-6 * end.distance(segments[s].begin);
          auto         candidate =
            std::lower_bound(by_x.begin(),
                             by_x.end(),
                             end[0] - tolerance,
                             [&](const std::size_t a, const double x) {
                               return segments[a].begin[0] < x;
                             });
          for (; candidate != by_x.end() &&
                 segments[*candidate].begin[0] <= end[0] + tolerance;
               ++candidate)
            if (segments[*candidate].begin.distance(end) <= tolerance)
              next[s] = *candidate;
        }
      return next;
    }
  } // namespace


  std::vector<std::vector<std::size_t>>
  chain(const std::vector<Segment> &segments)
  {
    const std::vector<std::size_t> next = successors(segments);
    std::vector<bool>              has_predecessor(segments.size(), false);
    for (const std::size_t s : next)
      if (s != none)
        has_predecessor[s] = true;

    // Open chains by growing x of their beginning, then possible beginnings
    // of closed ones by falling x.
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(),
              order.end(),
              [&](const std::size_t a, const std::size_t b) {
                if (has_predecessor[a] != has_predecessor[b])
                  return !has_predecessor[a];
                const auto &p = segments[a].begin, &q = segments[b].begin;
                if (p[0] != q[0])
                  return has_predecessor[a] ? p[0] > q[0] : p[0] < q[0];
                return p[1] < q[1];
              });
    std::vector<std::vector<std::size_t>> chains;
    std::vector<bool>                     used(segments.size(), false);
    for (const std::size_t first : order)
      {
        if (used[first])
          continue;
        chains.emplace_back();
        for (std::size_t s = first; s != none && !used[s]; s = next[s])
          {
            used[s] = true;
            chains.back().push_back(s);
          }
      }
    return chains;
  }
} // namespace Thalweg
