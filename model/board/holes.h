#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/board/copies.h"
#include "model/board/document.h"

/// What the holes of a board are: spans, tools, counts.
namespace model {

/// Does a layer of this type hold holes?
constexpr bool isHoles(LayerType type) {
    return type == LayerType::Drill || type == LayerType::Rout;
}

/// Which copper a hole joins or passes.
enum class HoleSpan : std::uint8_t {
    Through,  ///< from the outer copper to the outer copper
    Blind,    ///< from an outer copper layer inwards
    Buried,   ///< between inner copper layers
    Micro,  ///< between neighbouring copper layers, by laser or exposure, no wider than 150 µm (IPC-2226), or called so
    Backdrill  ///< drilled after plating, from outside, to take the plating of a through hole away
};
[[nodiscard]] const char* toString(HoleSpan span);  ///< "through", "blind", …

inline constexpr Nm kMostMicrovia = 150'000;

/// The attribute by which readers keep what a job calls a via: "micro", "blind", "buried". A via that is called a
/// microvia is one if it is between neighbouring copper layers and not through the whole board.
inline constexpr const char* kViaType = "via_type";
inline constexpr const char* kMicroviaType = "micro";

/// Does a hole of this size come from the tool? Tool and symbol sizes are rounded apart, for example 7.988 mil and
/// 202.9 µm, so 1 µm is forgiven, but no more than a tenth of the size.
[[nodiscard]] bool fits(const DrillTool& tool, Nm size);
/// The tool for a hole of this size: one that fits and is of that plating, else any that fits; finished sizes count
/// before drilled ones, then the nearest one counts. nullptr if there is none.
[[nodiscard]] const DrillTool* findTool(std::span<const DrillTool> tools, Nm size, bool isPlated);

/// Holes that are the same to a fabricator. Of the tools that fit, the nearest one in size is theirs; which of several
/// that are equally near drills which hole is not known.
struct DrillRow {
    LayerId layer;
    HoleSpan span = HoleSpan::Through;
    HoleKind kind = HoleKind::NonPlated;
    const char* shape = "round";      ///< "round", "slot" (one straight or curved track), "path" (a rout), "area"
    Nm diameter = 0;                  ///< as drilled, or width of a slot or path; shorter side of an area's box
    Nm open = 0;                      ///< what the plating leaves; as drilled for NPTHs; 0 for areas
    bool isOpenAssumed = false;       ///< no tool says how thick the plating is, so a reader assumed it
    Nm length = 0;                    ///< of all but round holes, as drilled and over their ends; to 100 nm
    const DrillTool* tool = nullptr;  ///< in Document::tools; none if no tool of the layer fits
    bool isCalledMicrovia = false;    ///< by the job, which the element's attribute kViaType says
    std::vector<int> otherTools;      ///< numbers of tools that fit alike: some of the holes may be theirs
    std::uint32_t count = 0;
};

/// Is its diameter the size of a drill or router? Not that of an area, nor of a path that says where and not how wide.
[[nodiscard]] bool hasDrilledSize(const DrillRow& row);
/// The numbers of the tools of a row for people: "1", "1, 2", "1-7, 12, …"; empty if it has none. KiCad 9 lists a tool
/// for every hole.
[[nodiscard]] std::string toolsText(const DrillRow& row);

/// All holes of the document's own drill and rout layers, by layer, span, kind, shape and sizes. Copies of other steps
/// are not counted.
[[nodiscard]] std::vector<DrillRow> drillTable(const Document& document);
/// The same of a board with all copies of steps on it, each hole as often as it is drilled. Steps of a job have tool
/// lists of their own: holes that are alike but for the number of their tool are two rows.
[[nodiscard]] std::vector<DrillRow> drillTableWithCopies(const Document& board);
/// What a row of the table says of one hole.
[[nodiscard]] DrillRow drillRowOf(const Document& document, ElementId hole);
/// Of one hole.
[[nodiscard]] HoleSpan spanOf(const Document& document, ElementId hole);
/// Which elements are plated holes with HoleSpan::Micro, by element.
[[nodiscard]] std::vector<bool> microviasOf(const Document& document);
/// The holes that rows of `drillTableWithCopies` count, in rising order.
[[nodiscard]] std::vector<BoardElement> holesOf(const Document& board, std::span<const DrillRow> rows);

}  // namespace model
