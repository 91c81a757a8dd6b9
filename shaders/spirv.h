#pragma once

#include <cstdint>
#include <span>

#include "spirv_list.h"

/// The compiled shaders: area_cap.vert.glsl is kAreaCapVert. COPPERSCOPE_SHADERS(SHADER) has a row for each that
/// CMakeLists.txt lists: SHADER(its name here, the name of its words).
namespace shader::spirv {

using Code = std::span<const std::uint32_t>;

#define COPPERSCOPE_DECLARE(name, words) extern const Code name;
COPPERSCOPE_SHADERS(COPPERSCOPE_DECLARE)
#undef COPPERSCOPE_DECLARE

}  // namespace shader::spirv
