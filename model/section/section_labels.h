#pragma once

#include <optional>
#include <vector>

#include "model/section/section_piece.h"

/// What is written beside a section, in the window and on sheets.
namespace model {

/// A material that is drawn, with its colours from the top, 0xRRGGBB: those of several layers, or one of its own.
struct SectionLegendRow {
    SectionMaterial material = SectionMaterial::Other;
    std::vector<std::uint32_t> colours;
};

/// The colour of a piece; `layers` has one for every layer.
[[nodiscard]] std::uint32_t colourOf(const SectionPiece& piece, const std::vector<std::uint32_t>& layers);
/// In the order of SectionMaterial, what is none of them left out.
[[nodiscard]] std::vector<SectionLegendRow> legendOf(const std::vector<SectionPiece>& drawn,
                                                     const std::vector<std::uint32_t>& layers);

/// A part of a section that is in sight, nm.
struct SectionWindow {
    double from = 0.0;
    double to = 0.0;
    double bottom = 0.0;
    double top = 0.0;
};

/// Where a row of the stackup is seen, so that its name can point there.
struct RowMark {
    double along = 0.0;  ///< the last location at which it is
    double z = 0.0;      ///< half way up what is in sight of it
    Nm bottom = 0;       ///< the row's lower face there, which is another in some zones of a rigid-flex board
};
/// None: nothing of it is in sight. `row`: of Stackup::rows.
[[nodiscard]] std::optional<RowMark> markOf(const Document& board, const std::vector<SectionPiece>& drawn,
                                            std::size_t row, const SectionWindow& window);

}  // namespace model
