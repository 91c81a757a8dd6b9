#include "shaders/spirv.h"

namespace {
#include "all_spirv.h"
}  // namespace

namespace shader::spirv {

#define COPPERSCOPE_DEFINE(name, words) const Code name(words);
COPPERSCOPE_SHADERS(COPPERSCOPE_DEFINE)
#undef COPPERSCOPE_DEFINE

}  // namespace shader::spirv
