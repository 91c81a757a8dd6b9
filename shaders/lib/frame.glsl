// First lines of every shader after #version: extensions, shared structs, push constants.
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "../shared/frame.h"

layout(push_constant, scalar) uniform PushBlock {
    Push push;
};
#define FRAME push.frame.data

bool has(uint flags, uint flag) {
    return (flags & flag) != 0;
}
