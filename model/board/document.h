#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/base/ids.h"
#include "model/base/point.h"
#include "model/base/table.h"
#include "model/board/diagnostics.h"
#include "model/geometry/shapes.h"

/// A board as Copperscope holds it: flat tables whose rows are addressed by 32-bit ids (docs/architecture.md).
/// Coordinates are nanometres in the step's own system, x to the right, y up, z up from the lowest face of the bottom
/// copper layer.
namespace model {

/// The five kinds of the paper (Table 1 and Table 3).
enum class ElementKind : std::uint8_t { Line, Arc, Circle, Trail, Area };
inline constexpr std::size_t kElementKindCount = 5;

enum class LayerType : std::uint8_t {
    Signal,
    PowerGround,
    Mixed,
    Dielectric,
    SolderMask,
    SolderPaste,
    SilkScreen,
    Drill,
    Rout,
    Component,
    Mask,
    ConductivePaste,
    Document,
    Profile,        ///< Profile: the step's outline, which we add as a layer of its own
    Body,           ///< the substrate: profile minus holes over the whole stackup; added by us
    ComponentBody,  ///< the bodies of the components of one side (Document::bodies); added by us
    Other
};
enum class LayerSide : std::uint8_t { None, Top, Inner, Bottom, Through };
enum class LayerContext : std::uint8_t { Board, Misc };
/// Where a number comes from.
enum class Source : std::uint8_t {
    Job,      ///< read from the job
    Derived,  ///< computed from other numbers of the job
    Assumed,  ///< a default; a diagnostic names it
    Session   ///< set by the user over what the job says
};

/// What a layer is for beyond its type.
enum class LayerUse : std::uint8_t {
    Plain,         ///< nothing said
    Flex,          ///< flexible copper
    Coverlay,      ///< film or solder mask over flexible copper
    Stiffener,     ///< a plate glued to a flexible part
    Adhesive,      ///< the glue under it
    Backdrill,     ///< drilled from outside to take the plating away again
    DualDiameter,  ///< the wider part of holes that are drilled with two diameters
    Other          ///< anything else; Layer::useName has the word
};

/// Consecutive rows of a table.
struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct Layer {
    std::string name;
    std::string file;  ///< the file it was read from, inside the job, for "file and line"
    LayerType type = LayerType::Other;
    LayerContext context = LayerContext::Board;
    LayerSide side = LayerSide::None;
    bool isNegative = false;   ///< drawn as what is left out: features are the clearances, elements the copper left
    bool isSynthetic = false;  ///< added by us (Body, ComponentBody, solder mask), not a layer of the job
    LayerId openings;          ///< synthetic solder mask: the layer of the job that draws its openings
    Nm z = 0;                  ///< lower face
    Nm thickness = 0;          ///< 0 for layers without a body
    Source thicknessSource = Source::Assumed;
    LayerId spanTop;  ///< drills and routed slots: first and last copper layer passed, top one first
    LayerId spanBottom;
    Range elements;                                         ///< elements of a layer are consecutive rows
    std::uint32_t featureCount = 0;                         ///< what the job draws on it, before tracks are joined
    std::array<std::uint32_t, kElementKindCount> counts{};  ///< elements by kind
    /// The same with those of all copies of other steps (Document::instances) that lie on this layer.
    std::array<std::uint64_t, kElementKindCount> countsWithCopies{};
    LayerUse use = LayerUse::Plain;
    std::string useName;  ///< what the job calls `use`; empty if it says nothing
    ShapeId profile;      ///< where this layer exists (rigid-flex); none: all over the board (Document::profile)
    /// Of a negative layer of a step that others hold copies of: what its features clear outside of its outline, where
    /// copper is that of the step around the copy. None: nothing.
    ShapeId clearedAround;
    /// Layers of one group have one outline, in every step of the job (each step its own); 0: the board's.
    std::uint32_t outlineGroup = 0;
    LayerId opposite;  ///< where this layer of a step lies once the step is flipped; none: its own mirror image

    [[nodiscard]] bool isCopper() const {
        return type == LayerType::Signal || type == LayerType::PowerGround || type == LayerType::Mixed;
    }
    /// Copper of the stackup, not of a drawing.
    [[nodiscard]] bool isBoardCopper() const { return isCopper() && context == LayerContext::Board; }
    /// Does the span of a drill layer hold this one? Layers are in physical order, so a span is a run of rows.
    [[nodiscard]] bool spans(LayerId id) const {
        return spanTop.isValid() && spanBottom.isValid() && spanTop <= id && id <= spanBottom;
    }
};

/// What a job says a layer is made of. Empty or absent: the job does not say.
struct Material {
    std::string name;                          ///< "FR-4", "2x106"
    std::string type;                          ///< of a dielectric: "CORE", "PREPREG"
    std::string form;                          ///< "RIGID", "FLEX"
    std::optional<double> copperOz;            ///< stated weight, ounces per square foot
    std::optional<double> dielectricConstant;  ///< relative, above 1
    std::optional<double> lossTangent;
    std::optional<double> resistivity;  ///< bulk, nΩ·m; copper has 16.8
};

/// What a job says about the build of one layer.
struct LayerFacts {
    std::optional<double> thicknessNm;  ///< its own
    std::optional<double> belowNm;      ///< copper: the dielectric under it, where the job has no row for that
    Material material;
    Material below;
    bool hasMaterial = true;  ///< false: the layer marks an area or a process step, or draws nothing of what it is
    bool isAssumed = false;   ///< `thicknessNm` is no number of the job, but what its program takes without one
};

/// A thickness the user sets over what the job says; `layer` is the name of a StackupRow.
struct ThicknessOverride {
    std::string layer;
    Nm thickness = 0;
    bool operator==(const ThicknessOverride&) const = default;
};

/// All that the heights of a board follow from.
struct StackupFacts {
    std::vector<LayerFacts> layers;      ///< by layer of the job, in document order
    std::optional<double> boardNm;       ///< the job's own thickness of the board
    std::vector<ThicknessOverride> set;  ///< by the user
};

/// One layer of the material the board is made of, surface layers included.
struct StackupRow {
    std::string name;  ///< the layer's; "below TOP" for a dielectric that the job has no row for; unique
    LayerId layer;     ///< none for such a dielectric
    LayerType type = LayerType::Dielectric;
    Nm z = 0;  ///< lower face
    Nm thickness = 0;
    Source source = Source::Assumed;
    Material material;
};

/// The stackup of the board, from the top. Made by model/board/stackup.h; empty for formats that state heights
/// themselves.
struct Stackup {
    std::vector<StackupRow> rows;
    StackupFacts facts;
};

enum ElementFlag : std::uint8_t {
    kHole = 1,       ///< a drilled or routed hole: what is solid is its barrel
    kPlated = 2,     ///< the barrel is copper
    kPad = 4,        ///< drawn as a pad
    kSquarePen = 8,  ///< Line only: drawn with an axis-parallel square pen
    kVia = 16,       ///< plated holes: joins layers
    kPinHole = 32,   ///< plated holes: takes a pin of a component
};

/// What a job says of a hole or of the tool that drills it; a via is plated too.
enum class Plating : std::uint8_t { NotSaid, Plated, NonPlated, Via };

[[nodiscard]] constexpr bool isPlated(Plating plating) {
    return plating == Plating::Plated || plating == Plating::Via;
}

/// What a hole is for. `Plated` is one that has a barrel and of which the job does not say whether a pin or a via is in
/// it.
enum class HoleKind : std::uint8_t { Via, Component, Plated, NonPlated };

/// Of an element with kHole.
[[nodiscard]] constexpr HoleKind holeKind(std::uint8_t flags) {
    return (flags & kPlated) == 0    ? HoleKind::NonPlated
           : (flags & kVia) != 0     ? HoleKind::Via
           : (flags & kPinHole) != 0 ? HoleKind::Component
                                     : HoleKind::Plated;
}

/// Is the element the barrel of a plated hole?
[[nodiscard]] constexpr bool isPlatedHole(std::uint8_t flags) {
    return (flags & kHole) != 0 && (flags & kPlated) != 0;
}

using AttributeSetId = base::Id<struct AttributeSetTag>;

/// Names and values of a feature's attributes, in words, in the order of the record. Few distinct sets serve many
/// elements, so an element holds 4 bytes: ElementTable::attributes.
using AttributeValues = std::vector<std::pair<std::string, std::string>>;

/// One row per element, columns side by side. `geometry` is a row of the table of the element's kind.
struct ElementTable {
    base::Table<ElementKind> kind;
    base::Table<std::uint8_t> flags;
    base::Table<LayerId> layer;
    base::Table<NetId> net;
    base::Table<SubnetId> subnet;  ///< what it is in its net; none where the job does not say
    base::Table<SymbolId> symbol;
    base::Table<std::uint32_t> geometry;
    base::Table<std::uint32_t> firstFeature;  ///< 0-based ordinal of its (first) feature in the layer's file
    base::Table<std::uint32_t> line;          ///< 1-based line of that feature
    base::Table<AttributeSetId> attributes;   ///< of that feature: a row of Document::attributeSets

    [[nodiscard]] std::size_t size() const { return kind.size(); }
};

/// From lower to upper face.
struct ZRange {
    Nm bottom = 0;
    Nm top = 0;
};

/// The body of a component, an area on the ComponentBody layer of its side. The layer is as thick as the tallest of
/// them; each begins at the layer's face towards the board with a height of its own.
struct Body {
    ElementId element;
    ComponentId component;
    Nm height = 0;
    Source source = Source::Assumed;  ///< of the height

    /// Where it lies in its layer: on that one's lower face, or, where it grows down, from the upper one.
    [[nodiscard]] ZRange heightsIn(const ZRange& layer, bool growsDown) const {
        return growsDown ? ZRange{layer.top - height, layer.top} : ZRange{layer.bottom, layer.bottom + height};
    }
};

/// What other drills have left of the plating of a hole: from copper layer to copper layer. None if nothing is left.
struct PlatedSpan {
    ElementId hole;
    LayerId top;
    LayerId bottom;

    [[nodiscard]] bool joins(LayerId layer) const {
        return top.isValid() && bottom.isValid() && top <= layer && layer <= bottom;
    }
};

/// The features that an area made by painting came from: rows of `PaintedSources::features`.
struct PaintedArea {
    ElementId element;
    std::uint32_t firstFeature = 0;
    std::uint32_t featureCount = 0;
};

/// The sources of areas that several features made together: what negative features left of a positive one, and the
/// pieces of negative layers. All other elements came from their `firstFeature` (trails: from it and those behind it).
struct PaintedSources {
    base::Table<PaintedArea> areas;       ///< by element, rising
    base::Table<std::uint32_t> features;  ///< ordinals in the layer's file, rising within an area

    /// Empty for elements that were not painted.
    [[nodiscard]] std::span<const std::uint32_t> of(ElementId element) const;
};

/// A track from `a` to `b` with a round pen (square with kSquarePen). `innerWidth` > 0 leaves a barrel (plated slot).
struct LineGeometry {
    Point a;
    Point b;
    Nm width = 0;
    Nm innerWidth = 0;
};

/// A round-pen track along a circular arc from `node.point` around `node.centre` to `end`; equal ends are a full
/// circle. `innerWidth` as for lines.
struct ArcGeometry {
    PathNode node;
    Point end;
    Nm width = 0;
    Nm innerWidth = 0;
};

/// A disc, or a ring when `innerDiameter` > 0. An NPTH has equal diameters: only its wall is there.
struct CircleGeometry {
    Point centre;
    Nm diameter = 0;
    Nm innerDiameter = 0;
};

/// Tracks joined end to end; nodes are consecutive rows of `trailNodes`, the last one without an edge. The width may
/// change from edge to edge, so each edge has its own (`trailWidths`).
struct TrailGeometry {
    std::uint32_t firstNode = 0;
    std::uint32_t nodeCount = 0;
    Nm width = 0;       ///< of the widest track
    Nm innerWidth = 0;  ///< as for lines: a routed slot, plated or not; the same all along
};

/// A shape laid on the board; surfaces lie where they were drawn, pad symbols are placed.
struct AreaGeometry {
    ShapeId shape;
    Placement placement;
};

/// A name and a value, an attribute or a property of the job; rows of Document::strings.
struct Property {
    StringId name;
    StringId value;
};

struct Net {
    std::string name;
    Range properties;
};

/// What a group of a net's elements is.
enum class SubnetKind : std::uint8_t {
    PinPads,  ///< the pads of one component pin
    Via,
    Trace,
    Plane,
    Other
};

enum class PlaneFill : std::uint8_t { NotSaid, Solid, Hatched, Outline };
enum class PlaneCutout : std::uint8_t { NotSaid, Circle, Rectangle, Octagon, Exact };

struct Subnet {
    NetId net;
    SubnetKind kind = SubnetKind::Other;
    PinId pin;                                       ///< PinPads: none if the job names one that is not there
    PlaneFill planeFill = PlaneFill::NotSaid;        ///< Plane
    PlaneCutout planeCutout = PlaneCutout::NotSaid;  ///< Plane: the clearance around what passes it
    Nm planeCutoutSize = 0;                          ///< Plane
};

enum class PinKind : std::uint8_t { Through, Blind, Surface };

/// A pin of a package, in package coordinates: as seen from the top, the component not rotated.
struct PackagePin {
    StringId name;
    PinKind kind = PinKind::Surface;
    Point position;
    ShapeId outline;  ///< none if the job draws none
};

/// A kind of component body. Coordinates are the package's own (Component::placement).
struct Package {
    std::string name;
    Nm pitch = 0;  ///< smallest distance between pin centres; 0 unknown
    Box box;       ///< empty if the job states none
    ShapeId body;  ///< its outline; none if the job draws none
    Range pins;    ///< of Document::packagePins
    Range properties;
};

/// A pin of a component where it lies on the board.
struct Pin {
    StringId name;
    Point position;
    NetId net;
    ComponentId component;
    std::uint32_t packagePin = 0xffffffffu;  ///< row of Document::packagePins; all ones if unknown
};

enum class MountType : std::uint8_t { Unknown, Other, Surface, ThroughHole, PressFit };

struct Component {
    std::string refdes;
    std::string part;
    PackageId package;
    Placement placement;   ///< from package coordinates to the board's; mirrored as the pins are found to lie
    bool isPlaced = true;  ///< false: the job does not say where it lies; `placement` is the middle of its pins
    LayerSide side = LayerSide::Top;
    Nm height = 0;  ///< 0 unknown
    MountType mount = MountType::Unknown;
    bool isPopulated = true;
    Range properties;
    std::uint32_t firstPin = 0;
    std::uint32_t pinCount = 0;
};

/// Elements the job groups, the lines of a text for example.
struct ElementGroup {
    StringId type;  ///< as the job words it: TEXT, PCB
    Range properties;
    Range elements;  ///< of Document::groupElements
};

enum class NetlistKind : std::uint8_t { Design, Reference, Current };
/// On which faces of the board the copper of a point is free of solder mask.
enum class Exposure : std::uint8_t { NotSaid, Exposed, Covered, CoveredOnTop, CoveredOnBottom };

/// A point of a netlist of the job: where a net can be touched. Coordinates are the board's.
struct NetPoint {
    StringId name;  ///< as the netlist writes it
    NetId net;      ///< the net of that name; none if there is none, or for "no net"
    Point position;
    Nm radius = 0;  ///< 0: `width` × `height`
    Nm width = 0;
    Nm height = 0;
    NetlistKind netlist = NetlistKind::Design;
    LayerSide side = LayerSide::None;  ///< Through: both sides
    Exposure exposure = Exposure::NotSaid;
    bool isEnd = true;  ///< an end of its net, not a point in between
    bool isVia = false;
};

/// A row of a drill layer's tool list. Sizes are 0 where the job does not know them.
struct DrillTool {
    LayerId layer;
    int number = 0;
    Plating plating = Plating::NotSaid;
    std::string process;  ///< STANDARD, PHOTO, LASER, PRESS_FIT; empty if not stated
    std::string bit;      ///< name of the drill bit
    Nm finishedSize = 0;  ///< diameter when the hole is plated
    Nm drillSize = 0;     ///< diameter as drilled
    Nm minTolerance = 0;  ///< by how much the finished size may be smaller, and larger
    Nm maxTolerance = 0;
};

/// A copy of another step on this one (a panel). It stays where it is once in memory: its elements are those of the
/// step, laid down by `placement`. A flipped copy lies upside down: `placement` holds the mirroring, and what is on a
/// layer lies on Layer::opposite. See model/board/copies.h for walking over copies of copies.
struct StepInstance {
    std::uint32_t step = 0;  ///< row of Document::steps
    Placement placement;     ///< from the step's coordinates to those of the document that holds the instance
    bool isFlipped = false;
};

/// A part of the board with a stackup of its own: rigid, flexible, stiffened. What a layer is, and at which height, is
/// the same in all zones; they differ in which layers are there.
struct Zone {
    std::string name;
    std::vector<LayerId> layers;  ///< those that are there, rising
    ShapeId shape;

    [[nodiscard]] bool has(LayerId layer) const { return std::ranges::find(layers, layer) != layers.end(); }
};

struct JobInfo {
    std::string name;
    std::string generator;  ///< save application as the job states it
    std::string version;    ///< of its format, or the format's name
    std::string units;      ///< default unit of the job, "MM" or "INCH"
    std::vector<std::string> steps;
    std::string step;  ///< the one this document holds
};

/// Times of the first two parts of the paper's modelling (Table 4), in milliseconds.
struct ReadTimes {
    double parseMs = 0.0;
    double createMs = 0.0;
};

/// A frozen board. Made by DocumentBuilder only, held as shared_ptr<const Document> and readable from every thread.
/// A panel holds its own elements and copies of other steps, which are documents of their own with nets,
/// components and tables of their own; their layers are the same rows at the same heights.
struct Document {
    JobInfo job;
    std::vector<Layer> layers;  ///< physical order from the top where it is known, then the rest
    base::Table<std::string> symbols;
    ShapeTable shapes;

    ElementTable elements;
    base::Table<LineGeometry> lines;
    base::Table<ArcGeometry> arcs;
    base::Table<CircleGeometry> circles;
    base::Table<TrailGeometry> trails;
    base::Table<PathNode> trailNodes;
    base::Table<Nm> trailWidths;  ///< per trail node: width of the track that leaves it, 0 for the last node of a trail
    base::Table<AreaGeometry> areas;
    PaintedSources painted;
    base::Table<Body> bodies;             ///< by element, rising
    base::Table<PlatedSpan> platedSpans;  ///< by hole, rising; holes that are not here are plated as their layer spans
    base::Table<AttributeValues> attributeSets;  ///< each once

    base::Table<Net> nets;
    base::Table<std::uint32_t> netStart;  ///< elements of net n: netElements[netStart[n] .. netStart[n + 1])
    base::Table<ElementId> netElements;
    base::Table<Subnet> subnets;
    base::Table<Package> packages;
    base::Table<PackagePin> packagePins;
    base::Table<Component> components;
    base::Table<Pin> pins;
    base::Table<ElementGroup> groups;
    base::Table<ElementId> groupElements;
    base::Table<NetPoint> netPoints;
    base::Table<Property> properties;
    base::Table<std::string> strings{""};  ///< each once; row 0 is empty
    base::Table<DrillTool> tools;

    std::vector<std::shared_ptr<const Document>> steps;  ///< placed by `instances`, each once
    base::Table<StepInstance> instances;  ///< copies right on this step; those may hold copies themselves
    base::Table<Zone> zones;

    ShapeId profile;  ///< the step's outline; none if the job has none and it could not be derived
    /// Source::Assumed: the box around all copper. It can be shown, but nothing can be held against it.
    Source profileSource = Source::Job;
    Box board;   ///< extent of the profile
    Box extent;  ///< of everything on board layers, copies included, bodies of components left out
    Nm boardThickness = 0;
    Stackup stackup;
    Diagnostics diagnostics;
    ReadTimes times;

    [[nodiscard]] const Layer& layer(LayerId id) const { return layers[id.row()]; }
    [[nodiscard]] const std::string& text(StringId id) const { return strings[id.isValid() ? id.row() : 0]; }
    [[nodiscard]] std::span<const Property> propertiesOf(Range range) const {
        return std::span(properties).subspan(range.first, range.count);
    }
    [[nodiscard]] std::span<const Pin> pinsOf(const Component& component) const {
        return std::span(pins).subspan(component.firstPin, component.pinCount);
    }
    [[nodiscard]] LayerId findLayer(std::string_view name) const;  ///< case does not matter; none if absent
    [[nodiscard]] NetId findNet(std::string_view name) const;      ///< exact; none if absent
    [[nodiscard]] std::span<const ElementId> elementsOf(NetId net) const;
    [[nodiscard]] std::span<const PathNode> nodesOf(const TrailGeometry& trail) const {
        return std::span(trailNodes).subspan(trail.firstNode, trail.nodeCount);
    }
    [[nodiscard]] std::span<const Nm> widthsOf(const TrailGeometry& trail) const {
        return std::span(trailWidths).subspan(trail.firstNode, trail.nodeCount - 1);
    }
    [[nodiscard]] const AttributeValues& attributesOf(ElementId element) const;
    [[nodiscard]] Box boxOf(ElementId element) const;
    /// Those of its layer, except for bodies of components.
    [[nodiscard]] ZRange heightsOf(ElementId element) const;
    [[nodiscard]] const Body* bodyOf(ElementId element) const;  ///< nullptr if it is none
    /// Which copper a plated hole joins: its layer's span, or what other drills have left of it (top none: nothing).
    [[nodiscard]] PlatedSpan platedSpanOf(ElementId hole) const;
    /// The layer of this document on which a copy's elements of its layer `id` lie.
    [[nodiscard]] LayerId layerOfCopy(LayerId id, bool isFlipped) const {
        return isFlipped && layer(id).opposite.isValid() ? layer(id).opposite : id;
    }
    /// Own elements by kind over all layers of the job (not those we add).
    [[nodiscard]] std::array<std::uint32_t, kElementKindCount> elementCounts() const;
    /// The same with those of all copies.
    [[nodiscard]] std::array<std::uint64_t, kElementKindCount> elementCountsWithCopies() const;
};

[[nodiscard]] const char* toString(ElementKind kind);  ///< "line", "arc", …
[[nodiscard]] const char* toString(LayerType type);    ///< as the matrix writes it: "SIGNAL", "POWER_GROUND", …
[[nodiscard]] const char* toString(LayerSide side);    ///< "top", "inner", …
[[nodiscard]] const char* toString(MountType mount);   ///< "unknown", "other", "smt", "through_hole", "press_fit"
[[nodiscard]] const char* toString(LayerUse use);      ///< "plain", "flex", …
[[nodiscard]] const char* toString(HoleKind kind);     ///< "via", "component", "plated", "non_plated"
[[nodiscard]] const char* toString(Source source);     ///< "job", "derived", "assumed", "session"

}  // namespace model
