// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/contact_forces.h>
#include <thalweg/dem/points.h>
#include <thalweg/methods/grain_view.h>
#include <thalweg/postprocess/offered_output.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Contacts of grains for ParaView: lines from center to center.
    template <int dim>
    class GrainContacts : public OfferedSeries<dim, const GrainView>
    {
    public:
      GrainContacts()
        : OfferedSeries<dim, const GrainView>("grains",
                                              "sand: grains",
                                              "contacts")
      {}

    private:
      void
      write(Context &context,
            const std::string &,
            const GrainView &view,
            const Moment    &now,
            PvdRecord       &record) const override
      {
        const auto contacts =
          contact_forces(view.system, view.law, view.materials.n());
        const GrainArrays &grains = view.system.grains();
        LinePatches<dim>   lines({"normal_force", "friction", "overlap"},
                               contacts.size());
        for (std::size_t c = 0; c < contacts.size(); ++c)
          {
            const GrainContact &contact = contacts[c];
            const Vec3         &a       = grains.place[contact.first].x;
            const Vec3         &b       = grains.place[contact.second].x;
            const Vec3          way     = a - b;
            const double        normal =
              dot(contact.force, way) / std::sqrt(norm_square(way));
            lines.set(c,
                      as_point<dim>(a),
                      as_point<dim>(b),
                      {normal,
                       std::sqrt(std::max(
                         0., norm_square(contact.force) - normal * normal)),
                       contact.overlap});
          }
        record.write(context, lines, now.time, now.step);
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   GrainContacts,
                   "contacts",
                   "contacts of grains as lines between their centers, with "
                   "normal force, friction and overlap, for ParaView; writes "
                   "METHOD_contacts.pvd.")
} // namespace Thalweg
