// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/mesh_decision.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Classes a factor of two, and factors of two below the reference that
    /// are told apart from nothing.
    constexpr int per_octave = 32;
    constexpr int octaves    = 20;
    constexpr int top        = per_octave * octaves;
    /// With a target number, cells are coarsened only whose indicator is
    /// smaller by this many classes, a factor of four, than those that are
    /// refined: in a smooth flow halved cells lose about that much.
    constexpr int gap = 2 * per_octave;



    /// The cells of all processes in classes; class 0 has no indicator, and
    /// `top` is that of the reference.
    struct Histogram
    {
      using Counts = std::array<std::uint64_t, top + 1>;

      double        reference = 0.;
      std::uint64_t n_cells = 0, must_refine = 0, must_coarsen = 0;
      Counts        undecided{}, refinable{}, coarsenable{};

      int
      class_of(const double indicator) const
      {
        if (reference <= 0. || indicator <= 0.)
          return 0;
        const double position =
          top + std::round(per_octave * std::log2(indicator / reference));
        return static_cast<int>(
          std::max(0., std::min(static_cast<double>(top), position)));
      }

      static double
      indicator_of(const int c)
      {
        return c == 0 ? 0. : std::exp2((c - top) / double(per_octave));
      }
    };



    /// Classes from `refine_from` on are refined, up to `coarsen_to`
    /// coarsened.
    struct Taken
    {
      int refine_from = top + 1;
      int coarsen_to  = 0;
    };



    enum class Order
    {
      none,
      refine,
      coarsen
    };

    /// What levels alone say of a cell.
    Order
    order(const unsigned char level,
          const unsigned char at_least,
          const unsigned char at_most)
    {
      if (level < at_least)
        return Order::refine;
      return level > at_most ? Order::coarsen : Order::none;
    }



    double
    reference_value(const MPI_Comm            communicator,
                    const DecisionParameters &parameters,
                    const CellWishes         &wishes)
    {
      double largest = 0.;
      for (const double indicator : wishes.indicator)
        largest = std::max(largest, indicator);
      largest = dealii::Utilities::MPI::max(largest, communicator);
      // A threshold is to lie in the middle of a class.
      if (parameters.strategy == MarkingStrategy::threshold &&
          parameters.refine_threshold > 0.)
        {
          double reference = parameters.refine_threshold;
          while (reference < largest)
            reference *= 2.;
          return reference;
        }
      return largest;
    }



    Histogram
    count(const MPI_Comm                    communicator,
          const DecisionParameters         &parameters,
          const std::vector<unsigned char> &level,
          const CellWishes                 &wishes)
    {
      Histogram histogram;
      histogram.reference = reference_value(communicator, parameters, wishes);
      std::vector<std::uint64_t> counts(3 + 3 * (top + 1), 0);
      for (unsigned int c = 0; c < level.size(); ++c)
        {
          const Order what =
            order(level[c], wishes.at_least[c], wishes.at_most[c]);
          ++counts[0];
          counts[1] += what == Order::refine;
          counts[2] += what == Order::coarsen;
          if (what != Order::none)
            continue;
          std::uint64_t *of_class =
            &counts[3 + 3 * histogram.class_of(wishes.indicator[c])];
          ++of_class[0];
          of_class[1] += level[c] < wishes.at_most[c];
          of_class[2] += level[c] > wishes.at_least[c];
        }
      dealii::Utilities::MPI::sum(counts, communicator, counts);
      histogram.n_cells      = counts[0];
      histogram.must_refine  = counts[1];
      histogram.must_coarsen = counts[2];
      for (int c = 0; c <= top; ++c)
        {
          histogram.undecided[c]   = counts[3 + 3 * c];
          histogram.refinable[c]   = counts[4 + 3 * c];
          histogram.coarsenable[c] = counts[5 + 3 * c];
        }
      return histogram;
    }



    /// How many cells there will be, without those that keep neighbours alike.
    double
    predicted_n_cells(const Histogram   &histogram,
                      const Taken       &choice,
                      const unsigned int n_children)
    {
      double n_refined   = histogram.must_refine;
      double n_coarsened = histogram.must_coarsen;
      for (int c = choice.refine_from; c <= top; ++c)
        n_refined += histogram.refinable[c];
      for (int c = 0; c <= choice.coarsen_to; ++c)
        n_coarsened += histogram.coarsenable[c];
      return histogram.n_cells + (n_children - 1.) * n_refined -
             (1. - 1. / n_children) * n_coarsened;
    }



    /// Takes classes from both ends until their weights come nearest to the
    /// fractions of the whole.
    Taken
    choose_fractions(const Histogram          &histogram,
                     const DecisionParameters &parameters)
    {
      const bool of_error =
        parameters.strategy == MarkingStrategy::fraction_of_error;
      std::array<double, top + 1> weight;
      double                      whole = 0.;
      for (int c = 0; c <= top; ++c)
        {
          weight[c] = histogram.undecided[c] *
                      (of_error ? Histogram::indicator_of(c) : 1.);
          whole += weight[c];
        }

      Taken  choice;
      double sum     = 0.;
      double nearest = parameters.refined_fraction * whole;
      for (int c = top; c > 0; --c)
        {
          sum += weight[c];
          const double miss =
            std::abs(sum - parameters.refined_fraction * whole);
          if (weight[c] > 0. && miss < nearest)
            {
              nearest            = miss;
              choice.refine_from = c;
            }
        }
      sum     = weight[0];
      nearest = std::abs(sum - parameters.coarsened_fraction * whole);
      for (int c = 1; c < choice.refine_from && c <= top; ++c)
        {
          sum += weight[c];
          const double miss =
            std::abs(sum - parameters.coarsened_fraction * whole);
          if (weight[c] > 0. && miss < nearest)
            {
              nearest           = miss;
              choice.coarsen_to = c;
            }
        }
      return choice;
    }



    Taken
    choose_target(const Histogram          &histogram,
                  const DecisionParameters &parameters,
                  const unsigned int        n_children)
    {
      Taken  best;
      double nearest = -1.;
      for (int from = top + 1 + gap; from > 0; --from)
        {
          const Taken  choice{std::min(from, top + 1),
                             std::max(0, from - 1 - gap)};
          const double miss =
            std::abs(predicted_n_cells(histogram, choice, n_children) -
                     parameters.target_n_cells);
          if (nearest < 0. || miss < nearest)
            {
              nearest = miss;
              best    = choice;
            }
        }
      return best;
    }



    Taken
    choose(const Histogram          &histogram,
           const DecisionParameters &parameters,
           const unsigned int        n_children)
    {
      Taken choice;
      switch (parameters.strategy)
        {
          case MarkingStrategy::fraction_of_cells:
          case MarkingStrategy::fraction_of_error:
            choice = choose_fractions(histogram, parameters);
            break;
          case MarkingStrategy::target_number:
            choice = choose_target(histogram, parameters, n_children);
            break;
          case MarkingStrategy::threshold:
            choice.refine_from =
              std::max(1, histogram.class_of(parameters.refine_threshold));
            choice.coarsen_to =
              std::min(choice.refine_from - 1,
                       histogram.class_of(parameters.coarsen_threshold));
            break;
        }
      if (parameters.maximal_n_cells > 0)
        {
          const auto too_many = [&]() {
            return predicted_n_cells(histogram, choice, n_children) >
                   parameters.maximal_n_cells;
          };
          while (choice.refine_from <= top && too_many())
            ++choice.refine_from;
          while (choice.coarsen_to < top && too_many())
            ++choice.coarsen_to;
        }
      return choice;
    }
  } // namespace



  std::vector<signed char>
  decide(const MPI_Comm                    communicator,
         const DecisionParameters         &parameters,
         const std::vector<unsigned char> &level,
         const CellWishes                 &wishes,
         const unsigned int                n_children)
  {
    const Histogram histogram = count(communicator, parameters, level, wishes);
    const Taken     choice    = choose(histogram, parameters, n_children);
    std::vector<signed char> decision(level.size(), 0);
    for (unsigned int c = 0; c < level.size(); ++c)
      {
        const Order what =
          order(level[c], wishes.at_least[c], wishes.at_most[c]);
        const int  of_class = histogram.class_of(wishes.indicator[c]);
        const bool refine =
          of_class >= choice.refine_from && level[c] < wishes.at_most[c];
        const bool coarsen =
          of_class <= choice.coarsen_to && level[c] > wishes.at_least[c];
        if (what == Order::refine || (what == Order::none && refine))
          decision[c] = 1;
        else if (what == Order::coarsen || coarsen)
          decision[c] = -1;
      }
    return decision;
  }
} // namespace Thalweg
