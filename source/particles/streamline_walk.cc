#include <thalweg/core/registry.h>
#include <thalweg/particles/streamline_walk.templates.h>

THALWEG_INSTANTIATE(Thalweg::StreamlineWalk)
