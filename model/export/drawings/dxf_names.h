#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

/// Names and colours as DXF has them.
namespace model {

/// Gives layers of a drawing names that DXF takes, each once: case does not count, some characters are not allowed and
/// become "_", and what is not ASCII is written as \U+XXXX.
class DxfNames {
public:
    [[nodiscard]] std::string unique(std::string_view name);

private:
    std::set<std::string> m_taken{"0"};  ///< with small letters; every drawing has a layer 0
};

/// A text as DXF has it: what is not ASCII as \U+XXXX, and "_" for what ends a line.
[[nodiscard]] std::string dxfText(std::string_view utf8);

/// The number (1 to 255) of the colour of AutoCAD's table that is nearest to 0xRRGGBB.
[[nodiscard]] int dxfColour(std::uint32_t rgb);

}  // namespace model
