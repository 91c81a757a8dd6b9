#pragma once

#include <filesystem>
#include <string>

#include "model/base/length_writer.h"
#include "model/base/result.h"
#include "model/board/document.h"

/// The stackup of a board for others: a drawing and a table. The window writes the drawing as PDF too
/// (ui/stackup/stackup_pdf.h).
namespace model {

/// The sheet (model/export/stackup_sheet.h) as SVG 1.1 in UTF-8.
[[nodiscard]] std::string stackupSvg(const Document& document, bool isExaggerated, const LengthWriter& write = {});
/// A line per row of the stackup with headings, comma separated (RFC 4180); lengths in nm, empty where nothing is
/// known. With zones there is a column of cumulative thickness for each, empty where it does not have the layer or that
/// does not count. `write` is for the texts of findings.
[[nodiscard]] std::string stackupCsv(const Document& document, const LengthWriter& write = {});

/// What a file of that name holds: one of them, as the ending says in letters of either case. Errors: BadUsage for
/// other endings and boards without a stackup.
[[nodiscard]] base::Result<std::string> stackupFile(const Document& document, const std::filesystem::path& path,
                                                    bool isExaggerated, const LengthWriter& write = {});

}  // namespace model
