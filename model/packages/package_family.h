#pragma once

#include "model/packages/package_facts.h"

/// What a component is, told from its pins and, as a hint, from its names.
namespace model {

/// What a part does, after its designator and the name of its package. A hint: it chooses colours and typical heights.
enum class PartKind : std::uint8_t {
    Unknown,
    Resistor,
    Capacitor,
    Inductor,
    Diode,
    Led,
    Transistor,
    Ic,
    Crystal,
    Connector,
    Switch,
    Bare  ///< copper or a hole and nothing soldered on: test point, fiducial, mounting hole, edge fingers, logo
};

/// How the body and the leads of a component lie.
enum class PackageFamily : std::uint8_t {
    None,            ///< nothing stands on the board
    Chip,            ///< two terminals that wrap around its ends
    TwoLeads,        ///< moulded, with a lead at either end: SMA, SOD, tantalum, power inductor
    CanCapacitor,    ///< an electrolytic capacitor that is soldered on the surface
    SmallOutline,    ///< leads on two sides, up to six: SOT-23, SOT-223, SC-70
    DualInLine,      ///< leads on two sides: SOIC, TSSOP
    DualFlat,        ///< terminals under two sides: DFN, SON, chip arrays
    QuadFlat,        ///< leads on four sides: QFP, PLCC
    QuadFlatNoLead,  ///< terminals under four sides: QFN
    Grid,            ///< balls or lands below: BGA, LGA
    Crystal,         ///< a metal can
    Connector,
    Header,       ///< straight pins in a low housing
    Radial,       ///< a can on two pins through the board
    Axial,        ///< lies along the board, a lead at either end bent into a hole
    ThroughDual,  ///< DIP
    ThroughHole,  ///< any other body on pins through the board
    Post,         ///< one pin that stands on the board
    Other
};

/// Where the pins are.
enum class PinLayout : std::uint8_t { None, Single, Pair, Row, TwoRows, FourSides, Grid, Irregular };

/// How the pins lie, and whether they are on two sides along x (left and right) or along y.
struct PinPattern {
    PinLayout layout = PinLayout::None;
    bool isAlongY = false;
    bool hasCentrePad = false;  ///< a large pad in the middle, not counted in the layout
    bool isThrough = false;     ///< most pins go through the board
};

[[nodiscard]] PartKind kindOf(std::string_view refdes, std::string_view package);
/// Does the designator say that two bare pads which solder may join are all there is, as "JP1" does?
[[nodiscard]] bool isJumperName(std::string_view refdes);
[[nodiscard]] PinPattern patternOf(const PackageFacts& facts);

/// `statedHeight` is the job's (0: none): what stands on one pin is a body only if the job gives it a height.
[[nodiscard]] PackageFamily familyOf(const PackageFacts& facts, const PinPattern& pattern, PartKind kind,
                                     Nm statedHeight);

[[nodiscard]] const char* toString(PackageFamily family);  ///< "chip", "SOIC", …

}  // namespace model
