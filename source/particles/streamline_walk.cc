// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/streamline_walk.templates.h>

THALWEG_INSTANTIATE(Thalweg::StreamlineWalk)
