#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/board/board_colours.h"
#include "model/board/document.h"
#include "model/clearance/design_rules.h"
#include "model/clearance/waivers.h"
#include "model/measure/measurement.h"
#include "model/measure/section_dimension.h"
#include "model/session/saved_nets.h"
#include "model/session/saved_selection.h"

/// What a user has set for a board, over what the job says. It lies in a file of its own beside the job, which is never
/// written to. The file holds only what was changed:
///
///     {"copperscope_session": 1, "job": "amp", "thickness_nm": {"TOP": 70000},
///      "views": [{"name": "U1", "step": "pcb", "layers": ["TOP"], "flat": {"target_mm": [1, 2, 0], "distance_mm": 30,
///                 "yaw_deg": 0, "pitch_deg": -90, "parallel": true, "origin_nm": [50000000, 40000000], "aspect": 1.6},
///                 "solid": {…}, "nets": [["pcb", "CLK"]], "current": "TOP",
///                 "elements": [["TOP", "line", 0, 0, 1500000, 200000]]},
///                {"name": "Clocks", "step": "pcb", "selection": {"nets": [["pcb", "CLK"]],
///                 "elements": [["TOP", "line", 0, 0, 1500000, 200000]]}}],
///      "nets": [{"name": "GND", "step": "pcb", "colour": "#e69f00", "hidden": true}],
///      "desk": {"step": "pcb", "flat": {…}, "solid": {…}, "unit": "mm",
///               "layers": [{"name": "TOP", "visible": true, "opacity_percent": 80, "colour": "#ff8000"}]},
///      "board_colours": {"solder_mask": "blue", "silkscreen": "white", "finish": "gold"},
///      "layer_sets": [{"name": "Power", "layers": ["GND", "VCC"]}],
///      "measurements": [see Measurement], "sections": [see SavedSection],
///      "design_rules": {see model::parseRules}, "waivers": [those of model::parseWaivers]}
namespace model::session {

inline constexpr int kVersion = 1;

/// How a camera sees the board. Lengths are millimetres from the middle of the board, which is another one once its
/// outline changes.
struct Pose {
    std::array<double, 3> target{};
    double distance = 100.0;  ///< from the eye to the target, above 0
    double yawDeg = 0.0;      ///< 0 looks along +y
    double pitchDeg = 0.0;    ///< -90 looks straight down
    bool isParallel = false;
    std::optional<base::Point> origin{};  ///< the middle then, nm of the board; none: a file of an older version
    std::optional<double> aspect{};       ///< width of the view through its height then; none: likewise
    bool operator==(const Pose&) const = default;
};

/// A view or a selection that the user saved.
struct SavedView {
    std::string name;
    std::string step;                 ///< the one it shows
    Pose flat;                        ///< of the 2D view
    Pose solid;                       ///< of the 3D view
    std::vector<std::string> layers;  ///< the visible ones
    /// Then it is a selection, and neither cameras nor layers count.
    std::optional<SavedSelection> selection{};
    /// Highlighted when it was saved. None: the view says nothing of nets, as those of older versions.
    std::vector<NetName> nets{};
    /// The current layer, which lies on top in 2D, "" if there was none. None: as for `nets`.
    std::optional<std::string> current{};
    /// Selected when it was saved, at most kMostSavedElements. With no nets either the view says nothing of both.
    std::vector<SavedElement> elements{};
    bool operator==(const SavedView&) const = default;
};

/// The line of a section that the user saved, and what was measured in it. In a session file:
///
///     {"name": "Section 1", "step": "pcb", "line_nm": [[0, 0], [1000000, 0]],
///      "dimensions": [{"from_nm": [1000, 35000], "from_on": "corner", "to_nm": [2000, 0], "to_on": "upright"}]}
///
/// A location of a dimension is so far along the line and above the bottom, on a corner, an upright or a level edge.
struct SavedSection {
    std::string name;
    std::string step;                ///< the one it was drawn in
    std::vector<base::PointD> line;  ///< two corners at least, nm of the board
    std::vector<SectionDimension> dimensions{};
    bool operator==(const SavedSection&) const = default;
};

/// How a layer is drawn.
struct LayerState {
    std::string layer;
    bool isVisible = true;
    int opacityPercent = 100;
    std::optional<std::uint32_t> rgb{};  ///< 0xrrggbb; none: as the program draws it
    bool operator==(const LayerState&) const = default;
};

/// Layers that the user shows together.
struct LayerSet {
    std::string name;
    std::vector<std::string> layers;
    bool operator==(const LayerSet&) const = default;
};

/// What the window showed when the user saved it.
struct Desk {
    std::string step;
    Pose flat;
    Pose solid;
    std::string unit;  ///< of lengths: "mm", "mil", "in"
    std::vector<LayerState> layers;
    std::string solo{};  ///< the layer that is shown alone; empty: none
    bool operator==(const Desk&) const = default;
};

struct Session {
    std::vector<ThicknessOverride> thicknesses;
    std::vector<SavedView> views;
    std::vector<SavedNet>
        nets{};  ///< also those that this board does not have: nothing is lost when it is written again
    std::optional<Desk> desk{};
    std::vector<Measurement> measurements{};
    std::vector<SavedSection> sections{};
    std::vector<LayerSet> layerSets{};
    BoardColourChoice boardColours{};
    std::optional<RuleTable> designRules{};  ///< none: those that are common
    std::vector<Waiver> waivers{};
    bool operator==(const Session&) const = default;
};

/// What a session file held, as JSON.
struct FileContent;

/// A session as it was found, and what of it was not used, one sentence each.
struct LoadedSession {
    Session session;
    std::vector<std::string> ignored;
    std::shared_ptr<const FileContent> file{};  ///< null where there is none
};

/// What somebody who shows one part of a session, and writes it, knows of the file: enough to keep what other programs
/// write into the same part. Begins with the file as it was read; saving keeps it up to date.
struct KnownPart {
    std::shared_ptr<const FileContent> own{};   ///< has the part as it was last taken from the file or put into it
    std::shared_ptr<const FileContent> file{};  ///< has what the file held of it then, with what others had written
    /// Of what others wrote into the part, the last save has kept something that this program did not hear of before
    /// (it is in the file, and not in what was saved here), has replaced something that was changed here, too.
    bool keepsOthers = false;
    bool replacesOthers = false;
};

/// "<file or folder of the job>.copperscope.json", beside it.
[[nodiscard]] std::filesystem::path sessionPath(const std::filesystem::path& board);

/// Reads the session of a board. A missing file is an empty session. What is not for this board (another job, another
/// version, rows that the stackup does not have, values that are no thickness) is named in `ignored`; nothing is an
/// error.
[[nodiscard]] LoadedSession loadSession(const std::filesystem::path& board, const Document& document);
/// The same of the text of such a file.
[[nodiscard]] LoadedSession parseSession(std::string_view text, const Document& document);

/// Writes one part of the session; the others, and what the file holds and we do not know, are kept. All of the file is
/// written or nothing (a file beside it is written out and then renamed); a session without anything removes it.
/// What another program changed of this part since it was `known` is kept (merge.h): thicknesses, colours and layer
/// sets by name, views, measurements, sections and waivers one by one; rules and desk are replaced as a whole. With
/// null all of the part is replaced.
/// Errors: OutputFailed with the path and the reason when the folder or the disk refuses, or when the file there is of
/// another job, of a later version or no session; it is then as before.
[[nodiscard]] base::Status saveThicknesses(const std::filesystem::path& board, const Document& document,
                                           const std::vector<ThicknessOverride>& thicknesses,
                                           KnownPart* known = nullptr);
[[nodiscard]] base::Status saveViews(const std::filesystem::path& board, const Document& document,
                                     const std::vector<SavedView>& views, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveNets(const std::filesystem::path& board, const Document& document,
                                    const std::vector<SavedNet>& nets, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveDesk(const std::filesystem::path& board, const Document& document, const Desk& desk,
                                    KnownPart* known = nullptr);
[[nodiscard]] base::Status saveMeasurements(const std::filesystem::path& board, const Document& document,
                                            const std::vector<Measurement>& measurements, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveSections(const std::filesystem::path& board, const Document& document,
                                        const std::vector<SavedSection>& sections, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveLayerSets(const std::filesystem::path& board, const Document& document,
                                         const std::vector<LayerSet>& sets, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveBoardColours(const std::filesystem::path& board, const Document& document,
                                            const BoardColourChoice& chosen, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveDesignRules(const std::filesystem::path& board, const Document& document,
                                           const std::optional<RuleTable>& rules, KnownPart* known = nullptr);
[[nodiscard]] base::Status saveWaivers(const std::filesystem::path& board, const Document& document,
                                       const std::vector<Waiver>& waivers, KnownPart* known = nullptr);

/// The document with these thicknesses in it.
[[nodiscard]] std::shared_ptr<const Document> applyThicknesses(std::shared_ptr<const Document> document,
                                                               const std::vector<ThicknessOverride>& thicknesses);

/// Sets `change` in the list; a thickness of 0 takes the row back to what the job says.
void setThickness(std::vector<ThicknessOverride>& list, const ThicknessOverride& change);

}  // namespace model::session
