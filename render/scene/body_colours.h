#pragma once

#include <array>
#include <glm/glm.hpp>

#include "shaders/shared/board.h"

namespace render {

/// Colours of what bodies of components are made of, sRGB, in the order of model::BodyMaterial from Resistor on:
/// mouldings have the colour of their layer.
inline constexpr std::array<glm::vec3, shader::kMaterialCount> kBodyColours{{
    {0.13F, 0.13F, 0.15F},  // resistor: black glaze
    {0.66F, 0.53F, 0.38F},  // ceramic
    {0.80F, 0.58F, 0.20F},  // tantalum
    {0.27F, 0.27F, 0.28F},  // ferrite
    {0.93F, 0.91F, 0.78F},  // lens of an LED
    {0.86F, 0.83F, 0.74F},  // housing of a connector
    {0.76F, 0.77F, 0.79F},  // tin, aluminium
    {0.83F, 0.68F, 0.34F},  // gold
    {0.92F, 0.92F, 0.90F},  // print
    {0.16F, 0.16F, 0.17F},  // dark print
}};

}  // namespace render
