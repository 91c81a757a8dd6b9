#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/board/copies.h"

namespace model::session {

/// The style that the user set for a net. Nets are saved by name: rows may differ after the job was written again.
struct SavedNet {
    std::string name;
    std::string step;                     ///< the one it is a net of
    std::optional<std::uint32_t> colour;  ///< 0xRRGGBB; none: as its layers
    bool isHidden = false;
    bool operator==(const SavedNet&) const = default;
};

/// Where they are on the board; none for nets of steps that are not on it, and for names that their step does not have.
[[nodiscard]] std::vector<std::optional<BoardNet>> findNets(const StepTree& tree, std::span<const SavedNet> nets);

/// "#1e90ff"; none for anything else.
[[nodiscard]] std::optional<std::uint32_t> colourFrom(std::string_view text);
[[nodiscard]] std::string colourText(std::uint32_t colour);

}  // namespace model::session
