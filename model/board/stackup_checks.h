#pragma once

#include <string>
#include <vector>

#include "model/base/length_writer.h"
#include "model/board/document.h"

/// What of a stackup a fabricator would query, because no such material is made or the job contradicts itself. Only
/// numbers that the job states, that follow from it or that the user set are looked at; what we assume is no finding,
/// also where it replaces an absurd number of the job.
///
/// | check | finds | limit, and where it comes from |
/// |---|---|---|
/// | Sum | copper and dielectric that do not add up to the job's own board thickness | 3.5 % of the copper
/// |     | (kOunceTolerance); more than a tenth of the board is a warning: jobs often count the solder mask |
/// |     | (dielectrics on the outer copper are added where that is nearer) | some jobs count them, others do not |
/// | MaskThickness | a solder mask above 100 µm | dry film, the thickest kind, is sold up to 4 mil |
/// | MaskSides | masks of top and bottom of which one is more than twice as thick | both are made in one process |
/// | CopperThickness | copper outside of 5 to 480 µm | the foils of IPC-4562: 1/8 oz to 14 oz |
/// | DielectricThickness | a dielectric below 12 µm | the thinnest polyimide film is 12.5 µm (0.5 mil) |
/// | DielectricConstant | Dk outside of 1.9 to 13 | from PTFE (2.1) to ceramic-filled laminates (12.9) |
/// | LossTangent | Df above 0.05 | FR-4 has 0.02, polyimide and acrylic adhesive up to 0.04 |
/// | CoreOnCore | copper with a core above and a core below | cores are cured: prepreg must bond them |
/// | Symmetry | copper or dielectric that differs by more than a tenth from what lies as far from the other side | a
/// |          | fabricator's tolerance of a dielectric is ±10 %; boards of unlike halves warp (IPC-2221) |
namespace model {

enum class StackupCheck : std::uint8_t {
    Sum,
    MaskThickness,
    MaskSides,
    CopperThickness,
    DielectricThickness,
    DielectricConstant,
    LossTangent,
    CoreOnCore,
    Symmetry
};
[[nodiscard]] const char* toString(StackupCheck check);  ///< "sum", "mask_thickness", …

struct StackupFinding {
    StackupCheck check = StackupCheck::Sum;
    Severity severity = Severity::Warning;
    std::string text;               ///< a sentence that names the layers; begins with a capital
    std::vector<std::size_t> rows;  ///< of Stackup::rows that it is about; empty: the whole stackup
};

/// In the order of the checks, then of the rows. Symmetry is looked at zone by zone where there are zones. `write` says
/// thicknesses in the texts.
[[nodiscard]] std::vector<StackupFinding> checkStackup(const Document& document, const LengthWriter& write = {});

/// The same as messages about no file.
void reportStackup(const Document& document, Diagnostics& diagnostics);

}  // namespace model
