#pragma once

#include <string>

#include "model/export/section_sheet.h"

/// A section for others: a drawing and a table.
namespace model {

/// The sheet (section_sheet.h) as SVG 1.1 in UTF-8. A unit of its viewBox is a millimetre of paper.
[[nodiscard]] std::string sectionSvg(const Document& board, const Section& section, const SectionPicture& how);

/// A line per piece and then per bore, comma separated (RFC 4180), with headings; lengths in nm. Upper
/// ends differ from the lower ones where a piece leans. Bores have no material, films that are not drawn no element. Of
/// a dielectric the row of the stackup is named, with its thickness: a piece is higher where it fills the space beside
/// copper too.
[[nodiscard]] std::string sectionCsv(const BoardIndex& index, const Section& section);

/// Name of the net of what was cut; empty if it has none.
[[nodiscard]] std::string netOf(const BoardIndex& index, const SectionPiece& piece);

}  // namespace model
