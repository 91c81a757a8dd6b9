// What every kernel works on.
#include "forest.h"
#include "predicates.h"

layout(push_constant, scalar) uniform PushBlock {
    Push push;
};
#define FOREST push.forest.at[0]

// Workgroups lie in rows: one row may hold too few.
uint groupIndex() {
    return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}
