#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "model/board/document.h"
#include "model/clearance/rule_file.h"

namespace model {

/// Rules of a project of KiCad 6 and later (.kicad_pro): net classes with their nets, and the minimums that the board
/// must keep. Two nets keep the larger clearance of their classes, and no less than the board's. Checks that the
/// project ignores are off; minimums of 0 ask for nothing. What has no counterpart, or is no length, is left out and
/// named with its line; widths of tracks and sizes of vias of net classes are what KiCad draws new ones with, no
/// minimums; all of it may be. Errors: BadInput.
[[nodiscard]] base::Result<RuleFile> parseKicadProjectRules(std::string_view json);

/// The same of a board of KiCad 4 and 5, which holds them itself: (net_class …) and (setup …).
[[nodiscard]] base::Result<RuleFile> parseKicadBoardRules(std::string_view board);

/// Rules of the project that a board of KiCad belongs to: of the .kicad_pro beside it, with those of the .kicad_dru,
/// which go before them; of an older board its own, if it holds any, whatever lies beside it. Clearances that zones,
/// pads and footprints of the board have of their own are left out, in one entry for all. A file that is damaged is
/// left out and named, and so is the project that custom rules lack. There may be no rules but only what is left out.
/// None for what is no such board, or has nothing of the kind.
[[nodiscard]] std::optional<RuleFile> kicadRulesOf(const std::filesystem::path& board);

/// The same where they are asked for. Errors: BadInput, with the file: one is damaged, or there is none.
[[nodiscard]] base::Result<RuleFile> readKicadRulesOf(const std::filesystem::path& board);

/// The same as they hold for the board that lies there.
[[nodiscard]] std::optional<RuleFile> kicadRulesFor(const std::filesystem::path& path, const Document& board);

/// Of rules of KiCad: takes away those for net classes and names that no net of the board fits, which ask for nothing
/// there, and names them in `unused`; and out of other classes the names that no net has. Projects carry classes from
/// board to board. Patterns that are regular expressions, which KiCad knows too, are left out. A board without nets
/// keeps all: there it is the board that lacks something.
void leaveOutUnusedClasses(RuleFile& file, const Document& board);

}  // namespace model
