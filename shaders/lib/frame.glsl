// First lines of every shader after #version: shared structs, push constants.
#include "../shared/frame.h"

layout(push_constant, scalar) uniform PushBlock {
    Push push;
};
#define FRAME push.frame.data
#define SHADOWS push.shadows
