#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/board/document.h"

/// The stackup as one reviews it: what each layer is, which parts of the board have it, and how thick the board is down
/// to it.
namespace model {

enum class StackupKind : std::uint8_t {
    Copper,
    Core,
    Prepreg,
    Dielectric,  ///< core or prepreg: the job does not say
    SolderMask,
    Coverlay,
    Adhesive,
    Stiffener,
    Finish,  ///< a mask or conductive paste that has "finish" in its name: no type of ODB++ stands for it
    ConductivePaste,
    Paste,
    Silkscreen,
    OtherMask
};
[[nodiscard]] const char* toString(StackupKind kind);  ///< "copper", "core", … "other_mask"

[[nodiscard]] StackupKind kindOf(const StackupRow& row, const Document& document);
[[nodiscard]] constexpr bool isDielectric(StackupKind kind) {
    return kind == StackupKind::Core || kind == StackupKind::Prepreg || kind == StackupKind::Dielectric;
}

/// The stackup of a part of the board: of a zone, or of all of it where there are none. Vectors have an entry per row
/// of Stackup::rows.
///
/// Copper, dielectrics, solder mask, coverlay, adhesive and stiffener count for the thickness. Paste, silkscreen,
/// finish and ink do not (they are only here and there), nor does coverlay between copper layers of this part, which is
/// within the dielectric there.
struct Substack {
    std::string name;  ///< of the zone; empty: the whole board
    std::vector<bool> has;
    std::vector<std::optional<Nm>> cumulative;  ///< from the top down to the row's lower face; none: does not count
    Nm copperToCopper = 0;                      ///< as thicknessOf, which it is for the whole board
    Nm overall = 0;                             ///< with all that counts
};

/// At least one, in the order of the zones; none for boards without a stackup. A row that no zone has is in all of
/// them; a dielectric that the job has no layer for is where the copper above and below it is (decision 45).
[[nodiscard]] std::vector<Substack> substacksOf(const Document& document);

}  // namespace model
