// First lines of every kernel that works on a whole forest, after #version.
#include "forest.glsl"
#include "access.h"
#include "mesh.h"
#include "insert.h"
#include "flip.h"
#include "constrain.h"
#include "erase.h"
#include "advance.h"

layout(local_size_x = kGroupSize) in;
