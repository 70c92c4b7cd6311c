// SPDX-License-Identifier: LGPL-2.1-or-later
// The walk through unsteady fields; apart from the steady one, so that the
// compiler's choices there do not depend on this.
#include <thalweg/particles/path_field.h>
#include <thalweg/particles/streamline_walk.templates.h>

namespace Thalweg
{
  template class StreamlineWalk<2, PathField<2, 1>>;
  template class StreamlineWalk<2, PathField<2, 2>>;
  template class StreamlineWalk<3, PathField<3, 1>>;
  template class StreamlineWalk<3, PathField<3, 2>>;
} // namespace Thalweg
