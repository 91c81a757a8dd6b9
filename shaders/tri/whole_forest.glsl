// First lines of every kernel that works on a whole forest, after #version.
#include "forest.glsl"
#include "access.h"
#include "mesh.h"
#include "insert.h"
#include "flip.h"
#include "constrain.h"
#include "erase.h"
#include "advance.h"

#ifndef THREADS_PER_GROUP
#define THREADS_PER_GROUP kGroupSize
#endif
layout(local_size_x = THREADS_PER_GROUP) in;
