#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/board/document.h"
#include "model/board/stackup.h"
#include "model/formats/common/net_points.h"
#include "model/formats/common/pad_shape.h"

/// What a job draws and says, whatever its format writes it in. Readers of formats other than ODB++ fill a DrawnJob,
/// and `assemble` (assembly.h) makes the document of it: trails from tracks, copper from paint order, negative planes,
/// holes with their plating, heights, parts with their pins, solids. A reader knows its format, the assembly knows
/// boards; neither knows the other's business.
///
/// Coordinates are nanometres in the step's own system, x to the right, y up. Rows are indices into the vectors of the
/// same job or step; kNoRow stands for "none" or "not said".
namespace model::formats {

inline constexpr std::int32_t kNoRow = -1;

using Words = std::vector<std::pair<std::string, std::string>>;  ///< names and values

enum class DrawnKind : std::uint8_t {
    Line,   ///< from `a` to `b` with the pen `symbol`
    Arc,    ///< the same around `centre`; equal ends are a full circle
    Pad,    ///< `symbol` laid at `a`
    Region  ///< `region` laid at `a`
};

/// One record that draws. Those of a layer are in paint order: a negative one takes away what lies before it.
struct DrawnFeature {
    DrawnKind kind = DrawnKind::Line;
    bool isNegative = false;
    bool isClockwise = false;               ///< Arc: from a to b
    bool isMirrored = false;                ///< Pad, Region: as Placement
    Plating plating = Plating::NotSaid;     ///< on layers of holes
    SubnetKind subnet = SubnetKind::Other;  ///< what it is in its net; PinPads follows from `pin`
    std::int32_t symbol = kNoRow;           ///< DrawnStep::symbols; Line, Arc, Pad
    std::int32_t region = kNoRow;           ///< DrawnStep::regions
    std::int32_t net = kNoRow;              ///< DrawnStep::nets
    std::int32_t component = kNoRow;        ///< DrawnStep::components, for pads of pins
    std::int32_t pin = kNoRow;              ///< DrawnComponent::pins
    std::int32_t attributes = kNoRow;       ///< DrawnStep::attributes
    std::uint32_t line = 0;                 ///< of the layer's file, 1-based
    double clockwiseDeg = 0.0;              ///< Pad, Region
    Point a;
    Point b;
    Point centre;
};

/// A pen or a pad. On layers of holes only round ones are drilled; slots are Lines drawn with a round pen, or regions.
struct DrawnSymbol {
    std::string name;  ///< as the job or the trade calls it: "r500", "RoundRect 1.2 x 0.65 r 0.065"
    PadShape shape;
};

/// A layer of the job, the same in all of its steps. In physical order from the top where that is known (copper,
/// dielectrics, mask, paste, silkscreen), then the rest.
struct DrawnLayer {
    std::string name;
    std::string file;        ///< for "file and line"
    std::uint32_t line = 0;  ///< where `file` lists the layer, 1-based; 0: the file is the layer's own
    LayerType type = LayerType::Other;
    LayerContext context = LayerContext::Board;
    LayerSide side = LayerSide::None;
    bool isNegative = false;        ///< features are what is not copper
    std::int32_t spanTop = kNoRow;  ///< layers of holes: rows of the first and last copper passed; none: all copper
    std::int32_t spanBottom = kNoRow;
    LayerUse use = LayerUse::Plain;
    std::string useName;
    LayerFacts facts;              ///< thickness, material
    std::vector<DrillTool> tools;  ///< layers of holes; DrillTool::layer is set by the assembly
    ShapeSketch outline;           ///< where the layer exists (rigid-flex), in steps without copies; empty: all over
};

struct DrawnPin {
    std::string name;
    Point position;                    ///< on the board: where the job says it is
    std::int32_t net = kNoRow;         ///< DrawnStep::nets
    std::int32_t packagePin = kNoRow;  ///< DrawnPackage::pins
};

struct DrawnPackagePin {
    std::string name;
    PinKind kind = PinKind::Surface;
    Point position;       ///< as seen from the top, the component not rotated
    ShapeSketch outline;  ///< empty if the job draws none
};

struct DrawnPackage {
    std::string name;
    Nm pitch = 0;         ///< 0 unknown
    Box box;              ///< empty if not stated
    ShapeSketch outline;  ///< of its body; empty if not drawn
    std::vector<DrawnPackagePin> pins;
    Words properties;
};

struct DrawnComponent {
    std::string refdes;
    std::string part;
    std::int32_t package = kNoRow;  ///< DrawnStep::packages
    Point position;
    double clockwiseDeg = 0.0;       ///< as Placement: first rotated, then mirrored x to -x
    std::optional<bool> isMirrored;  ///< not said: whichever puts more pins of its side where they are
    bool isPlaced = true;            ///< false: position and rotation are made up from its pins
    LayerSide side = LayerSide::Top;
    Nm height = 0;  ///< 0 unknown
    MountType mount = MountType::Unknown;
    bool isPopulated = true;
    std::vector<DrawnPin> pins;
    Words properties;
    std::uint32_t line = 0;
};

struct DrawnNet {
    std::string name;  ///< unique within the step
    Words properties;
};

struct DrawnGroup {
    std::string type;  ///< TEXT, …
    Words properties;
    std::vector<std::pair<std::int32_t, std::uint32_t>> features;  ///< layer, ordinal of its feature
};

struct DrawnNetlist {
    Netlist netlist;
    NetlistKind kind = NetlistKind::Reference;
    std::string file;
};

struct DrawnZone {
    std::string name;
    std::vector<std::int32_t> layers;  ///< rows of DrawnJob::layers that are there
    ShapeSketch shape;
};

/// A copy of another step on this one.
struct DrawnCopy {
    std::int32_t step = kNoRow;  ///< DrawnJob::steps, behind the one that holds the copy
    Placement placement;
    bool isFlipped = false;  ///< upside down; `placement` holds the mirroring
    std::uint32_t line = 0;
};

struct DrawnStep {
    std::string name;
    std::vector<std::vector<DrawnFeature>> features;  ///< by row of DrawnJob::layers
    std::vector<DrawnSymbol> symbols;
    std::vector<ShapeSketch> regions;
    std::vector<Words> attributes;
    std::vector<DrawnNet> nets;
    std::vector<DrawnPackage> packages;
    std::vector<DrawnComponent> components;
    std::vector<DrawnGroup> groups;
    std::vector<DrawnNetlist> netlists;  ///< compared with the nets of the copper
    std::vector<DrawnZone> zones;
    std::vector<DrawnCopy> copies;
    ShapeSketch profile;         ///< islands and cut-outs; empty: derived from the copper, with a message
    std::string profileFile;     ///< for messages about the profile
    std::string componentsFile;  ///< for messages about components, as their `line`
    std::string copiesFile;      ///< for messages about copies
};

struct DrawnJob {
    JobInfo info;  ///< `steps` and `step` are set by the assembly
    std::vector<DrawnLayer> layers;
    std::optional<double> boardNm;  ///< the job's own thickness of the board
    std::vector<DrawnStep> steps;   ///< the first one is shown; the others are placed by copies
    Diagnostics diagnostics;        ///< of the reading
};

}  // namespace model::formats
