// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_particle_rows_h
#define thalweg_particles_particle_rows_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace Thalweg
{
  using ParticleId = std::uint64_t;

  /// Where a particle is.
  template <int dim>
  struct ParticlePlace
  {
    dealii::Point<dim> position;  ///< m
    dealii::Point<dim> reference; ///< in its cell
  };

  /**
   * @brief One of the particles in ParticleRows: where it lies in memory, to
   * be handed around by value. Valid until the number of rows changes.
   */
  template <int dim, bool is_const>
  class ParticleReference
  {
  public:
    template <typename T>
    using Maybe = std::conditional_t<is_const, const T, T>;

    ParticleReference(Maybe<ParticleId>         *id,
                      Maybe<ParticlePlace<dim>> *place,
                      Maybe<double>             *row,
                      const unsigned int         n_properties)
      : id_(id)
      , place_(place)
      , row(row)
      , n_properties(n_properties)
    {}

    ParticleId
    id() const
    {
      return *id_;
    }

    Maybe<ParticlePlace<dim>> &
    place() const
    {
      return *place_;
    }

    /// In m.
    const dealii::Point<dim> &
    position() const
    {
      return place_->position;
    }

    /// In the particle's cell.
    const dealii::Point<dim> &
    reference() const
    {
      return place_->reference;
    }

    dealii::ArrayView<Maybe<double>>
    properties() const
    {
      return {row, n_properties};
    }

    /// The next one in memory.
    void
    advance()
    {
      ++id_;
      ++place_;
      row += n_properties;
    }

    /// Whether they are the same.
    bool
    is(const ParticleReference &other) const
    {
      return id_ == other.id_;
    }

    /// How many lie between the first of @p rows and this one.
    template <typename Rows>
    unsigned int
    index_in(const Rows &rows) const
    {
      return id_ - rows.ids();
    }

  private:
    Maybe<ParticleId>         *id_;
    Maybe<ParticlePlace<dim>> *place_;
    Maybe<double>             *row;
    unsigned int               n_properties;
  };

  /// Particles that lie side by side in memory, for loops over them.
  template <int dim, bool is_const>
  class ParticleRange
  {
  public:
    using Reference = ParticleReference<dim, is_const>;

    class Iterator
    {
    public:
      explicit Iterator(const Reference &particle)
        : particle(particle)
      {}

      const Reference &
      operator*() const
      {
        return particle;
      }

      const Reference *
      operator->() const
      {
        return &particle;
      }

      Iterator &
      operator++()
      {
        particle.advance();
        return *this;
      }

      bool
      operator==(const Iterator &other) const
      {
        return particle.is(other.particle);
      }

      bool
      operator!=(const Iterator &other) const
      {
        return !particle.is(other.particle);
      }

    private:
      Reference particle;
    };

    ParticleRange(const Reference &first, const Reference &behind)
      : first(first)
      , behind(behind)
    {}

    Iterator
    begin() const
    {
      return Iterator(first);
    }

    Iterator
    end() const
    {
      return Iterator(behind);
    }

    bool
    empty() const
    {
      return first.is(behind);
    }

  private:
    Reference first, behind;
  };

  /**
   * @brief Particles in flat memory: their numbers, their places, and a row of
   * properties each.
   */
  template <int dim>
  class ParticleRows
  {
  public:
    using Reference      = ParticleReference<dim, false>;
    using ConstReference = ParticleReference<dim, true>;

    explicit ParticleRows(const unsigned int n_properties)
      : n_properties_(n_properties)
    {}

    std::size_t
    size() const
    {
      return ids_.size();
    }

    /// Properties in a row.
    unsigned int
    n_properties() const
    {
      return n_properties_;
    }

    const ParticleId *
    ids() const
    {
      return ids_.data();
    }

    Reference
    operator[](const std::size_t i)
    {
      return {ids_.data() + i,
              places.data() + i,
              properties.data() + i * n_properties_,
              n_properties_};
    }

    ConstReference
    operator[](const std::size_t i) const
    {
      return {ids_.data() + i,
              places.data() + i,
              properties.data() + i * n_properties_,
              n_properties_};
    }

    /// Those from @p begin to before @p end.
    ParticleRange<dim, false>
    range(const std::size_t begin, const std::size_t end)
    {
      return {(*this)[begin], (*this)[end]};
    }

    ParticleRange<dim, true>
    range(const std::size_t begin, const std::size_t end) const
    {
      return {(*this)[begin], (*this)[end]};
    }

    /// Memory stays.
    void
    clear()
    {
      resize(0);
    }

    void
    reserve(const std::size_t n)
    {
      ids_.reserve(n);
      places.reserve(n);
      properties.reserve(n * n_properties_);
    }

    /// New ones have whatever values.
    void
    resize(const std::size_t n)
    {
      ids_.resize(n);
      places.resize(n);
      properties.resize(n * n_properties_);
    }

    /// @return the row of the new one, a copy of @p row, to be changed
    double *
    append(const ParticleId          id,
           const ParticlePlace<dim> &place,
           const double *const       row)
    {
      ids_.push_back(id);
      places.push_back(place);
      properties.insert(properties.end(), row, row + n_properties_);
      return properties.data() + properties.size() - n_properties_;
    }

    /// @return the row of the new one
    double *
    append(const ConstReference &particle)
    {
      AssertDimension(particle.properties().size(), n_properties_);
      return append(particle.id(),
                    {particle.position(), particle.reference()},
                    particle.properties().data());
    }

    /// Makes the number @p to what @p from of @p other is.
    void
    copy(const std::size_t   to,
         const ParticleRows &other,
         const std::size_t   from)
    {
      ids_[to]   = other.ids_[from];
      places[to] = other.places[from];
      std::copy_n(other.properties.begin() + from * n_properties_,
                  n_properties_,
                  properties.begin() + to * n_properties_);
    }

    /// Moves those from @p begin to before @p end to where @p to is the first;
    /// the ranges may overlap.
    void
    shift(const std::size_t begin, const std::size_t end, const std::size_t to)
    {
      move_block(ids_, begin, end, to);
      move_block(places, begin, end, to);
      move_block(properties,
                 begin * n_properties_,
                 end * n_properties_,
                 to * n_properties_);
    }

    void
    swap(ParticleRows &other)
    {
      std::swap(n_properties_, other.n_properties_);
      ids_.swap(other.ids_);
      places.swap(other.places);
      properties.swap(other.properties);
    }

  private:
    template <typename T>
    static void
    move_block(std::vector<T>   &values,
               const std::size_t begin,
               const std::size_t end,
               const std::size_t to)
    {
      const auto first = values.begin();
      if (to < begin)
        std::move(first + begin, first + end, first + to);
      else if (to > begin)
        std::move_backward(first + begin,
                           first + end,
                           first + (to + end - begin));
    }

    unsigned int                    n_properties_;
    std::vector<ParticleId>         ids_;
    std::vector<ParticlePlace<dim>> places;
    std::vector<double>             properties; ///< row by row
  };
} // namespace Thalweg

#endif
