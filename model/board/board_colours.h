#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

/// What a finished board looks like from outside: colours that a fabricator lets one choose.
namespace model {

/// Of solder mask and of silkscreen.
enum class BoardColour : std::uint8_t { Green, Red, Blue, Black, White, Yellow, Purple };
/// What covers the copper that solder mask leaves open.
enum class SurfaceFinish : std::uint8_t {
    Gold,   ///< ENIG, ENEPIG, hard gold
    Tin,    ///< HASL, immersion tin or silver
    Copper  ///< bare, or OSP, which is clear
};

/// "green", "gold": words of the command line and of the session file, in the order of the values.
[[nodiscard]] const std::vector<std::string>& boardColourNames();
[[nodiscard]] const std::vector<std::string>& surfaceFinishNames();
[[nodiscard]] std::optional<BoardColour> boardColourNamed(std::string_view name);
[[nodiscard]] std::optional<SurfaceFinish> surfaceFinishNamed(std::string_view name);

/// What is known of a board's colours: read from a job, or chosen by the user.
struct BoardColourChoice {
    std::optional<BoardColour> solderMask{};
    std::optional<BoardColour> silkscreen{};
    std::optional<SurfaceFinish> finish{};
    bool operator==(const BoardColourChoice&) const = default;
};

struct BoardColours {
    BoardColour solderMask = BoardColour::Green;
    BoardColour silkscreen = BoardColour::White;
    SurfaceFinish finish = SurfaceFinish::Gold;
    bool operator==(const BoardColours&) const = default;
};

/// What the names and materials of the job's layers say, as words of their own: "Solder Mask Green", "SILK_WHITE",
/// "ENIG", "surface finish HASL". No format of ours has a field for it.
[[nodiscard]] BoardColourChoice coloursInJob(const Document& document);

/// The user's choice, else the job's, else green mask, white print (black on white and yellow masks) and gold.
[[nodiscard]] BoardColours boardColours(const Document& document, const BoardColourChoice& chosen = {});

/// Is the layer film of a flexible part: coverlay, or a part of the substrate next to flexible copper alone? It is
/// amber polyimide.
[[nodiscard]] bool isFlexibleFilm(const Document& document, const Layer& layer);

}  // namespace model
