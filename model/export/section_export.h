#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/section/section.h"

/// A section for others: a drawing and a table.
namespace model {

struct SectionPicture {
    std::vector<std::uint32_t> colours;  ///< of the layers of the board, 0xRRGGBB
    double heightTimes = 0.0;            ///< heights are drawn so many times larger than lengths; 0: as reads well
};

/// SVG 1.1 in UTF-8: the cut to scale, with the heights of the stackup beside it, a bar of round length below, and the
/// notes. Parts are drawn as far as the board's thickness above and below it.
[[nodiscard]] std::string sectionSvg(const Document& board, const Section& section, const SectionPicture& how);

/// A line per piece and then per bore, comma separated (RFC 4180), with headings; lengths in nm.
[[nodiscard]] std::string sectionCsv(const BoardIndex& index, const Section& section);

/// Name of the net of what was cut; empty if it has none.
[[nodiscard]] std::string netOf(const BoardIndex& index, const SectionPiece& piece);

}  // namespace model
