# Puts the presets of rules beside this file into model/clearance, as rulePresets() of model/clearance/rule_presets.h.
file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
set(rows "")
foreach(path IN LISTS files)
    cmake_path(GET path STEM name)
    file(READ ${path} text)
    string(APPEND rows "    {\"${name}\", R\"json(${text})json\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rule_presets.cpp CONTENT [[
#include "model/clearance/rule_presets.h"

namespace model {

std::span<const RulePreset> rulePresets() {
    static constexpr RulePreset kPresets[] = {
@rows@    };
    return kPresets;
}

}  // namespace model
]] @ONLY)
target_sources(copperscope_model_clearance PRIVATE ${PROJECT_BINARY_DIR}/rule_presets.cpp)
