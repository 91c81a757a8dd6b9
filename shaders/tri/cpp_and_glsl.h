// The common part of C++ and GLSL that the kernels of triangulation are written in, so that one source is both the
// compute shader and its oracle: 32-bit words, small vectors, values in and a value out, no pointers. C++ includes it
// in namespace shader::tri.
#ifndef COPPERSCOPE_SHADERS_TRI_CPP_AND_GLSL_H
#define COPPERSCOPE_SHADERS_TRI_CPP_AND_GLSL_H

#ifdef __cplusplus
#include <atomic>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

namespace shader::tri {

using uint = std::uint32_t;
using ivec2 = glm::ivec2;
using uvec2 = glm::uvec2;
using uvec3 = glm::uvec3;
using uvec4 = glm::uvec4;

#define TRI_FN inline
#define TRI_CONST constexpr uint
#define TRI_SIZE(Name, bytes) static_assert(sizeof(Name) == (bytes))

/// 32 x 32 bits: low and high word.
inline uvec2 multiply(uint a, uint b) {
    const std::uint64_t product = std::uint64_t{a} * b;
    return {static_cast<uint>(product), static_cast<uint>(product >> 32)};
}
/// The number of the highest bit; `value` is not 0.
inline uint highestBit(uint value) {
    return static_cast<uint>(std::bit_width(value)) - 1;
}
/// All atomic functions return what was there before.
inline uint atomicMin(uint& slot, uint value) {
    std::atomic_ref<uint> atomic(slot);
    uint old = atomic.load();
    while (value < old && !atomic.compare_exchange_weak(old, value)) {
    }
    return old;
}
inline uint atomicMax(uint& slot, uint value) {
    std::atomic_ref<uint> atomic(slot);
    uint old = atomic.load();
    while (value > old && !atomic.compare_exchange_weak(old, value)) {
    }
    return old;
}
inline uint atomicAdd(uint& slot, uint value) {
    return std::atomic_ref<uint>(slot).fetch_add(value);
}

}  // namespace shader::tri
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#define TRI_FN
#define TRI_CONST const uint
#define TRI_SIZE(Name, bytes)

uvec2 multiply(uint a, uint b) {
    uint high, low;
    umulExtended(a, b, high, low);
    return uvec2(low, high);
}
uint highestBit(uint value) {
    return uint(findMSB(value));
}
#endif
#endif
