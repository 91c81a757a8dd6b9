#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/kicad/board_layers.h"
#include "model/formats/kicad/shapes/dashes.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// How what belongs to a footprint lies on the board: turned counter-clockwise, then moved. Footprints on the back are
/// stored as they are seen from the front, so nothing is ever mirrored.
struct Frame {
    PointD origin;
    double degrees = 0.0;
    [[nodiscard]] PointD apply(PointD local) const;
};

/// A length as a row of integers has it.
[[nodiscard]] Nm asNm(double length);

/// What a board says of all of its items.
struct BoardSettings {
    int version = 0;  ///< 20241229; 3 and 4 for the oldest
    double maskMargin = 0.0;
    double pasteMargin = 0.0;
    double pasteRatio = 0.0;
    double viaDrill = 0.0;                        ///< of vias that name none (KiCad 4)
    std::array<bool, 2> isViaTented{true, true};  ///< top, bottom
    DashRatios dashes;
    std::map<std::string, std::string, std::less<>> variables;  ///< of texts

    /// Before KiCad 6: copper layers have only the names that users gave them, texts a kind instead of a property.
    [[nodiscard]] bool isOld() const { return version < 20'200'000; }
    /// Texts that mark bars as ~CS~, not as ~{CS}.
    [[nodiscard]] bool hasOldBars() const { return version < 20'210'606; }
    /// Before vias and pads said on which layers zones keep their copper (zone_layer_connections).
    [[nodiscard]] bool keepsPadsInFills() const { return version < 20'221'018; }
    /// Zones whose fill is only the middle of what is there, unless they say otherwise.
    [[nodiscard]] bool hasStrokedFills() const { return version < 20'250'210; }
};

/// What a feature is, besides its shape.
struct Origin {
    std::uint32_t line = 0;
    std::int32_t net = formats::kNoRow;
    std::int32_t component = formats::kNoRow;
    std::int32_t pin = formats::kNoRow;
    std::int32_t attributes = formats::kNoRow;
    SubnetKind subnet = SubnetKind::Other;
    Plating plating = Plating::NotSaid;
};

/// What zones say of their fills.
struct ZoneFills {
    bool hasAny = false;                   ///< copper of a zone
    std::vector<std::uint32_t> emptyOnes;  ///< lines of zones that are filled, with nothing
};

/// The job that is being drawn, and what all of its items need: layers, nets, settings, messages. What lies beyond
/// ±1.07 m is reported and left out.
class Canvas {
public:
    Canvas(formats::DrawnJob& job, std::string_view file);

    [[nodiscard]] formats::DrawnJob& job() { return m_job; }
    [[nodiscard]] formats::DrawnStep& step() { return m_job.steps[0]; }
    [[nodiscard]] BoardLayers& layers() { return m_layers; }
    [[nodiscard]] BoardSettings& settings() { return m_settings; }
    [[nodiscard]] ZoneFills& zoneFills() { return m_zoneFills; }
    [[nodiscard]] const std::string& file() const { return m_file; }
    void report(Severity severity, std::uint32_t line, std::string_view text);
    /// Of an item of a kind that is not known.
    void reportNotDrawn(const Item& item);
    /// Of the variants that a board lists, or of what a footprint is in one.
    void reportVariants(const Item& item);

    // ---- nets ----
    /// (net 1 "GND") of the board.
    void declareNet(const Item& net);
    /// Of (net 1 "GND"), (net 1) or (net "GND") of an item; kNoRow for none.
    [[nodiscard]] std::int32_t netOf(const Item& item);
    /// Names stay as they are written, "{slash}" and all (model/text/net_names.h): those of KiCad's exports do too.
    [[nodiscard]] std::int32_t netNamed(std::string_view name);

    // ---- drawing ----
    /// The rows of (layer …) or (layers …) of an item. Layers that the board does not have are reported.
    [[nodiscard]] std::vector<std::int32_t> rowsOf(const Item& item);
    [[nodiscard]] std::int32_t pen(double width);
    [[nodiscard]] std::int32_t symbol(const std::string& key, formats::PadShape shape);
    [[nodiscard]] std::int32_t attributes(const formats::Words& words);
    void drawEdge(std::int32_t row, const Origin& origin, const PathNode& from, Point to, double width);
    void drawPad(std::int32_t row, const Origin& origin, std::int32_t symbol, PointD at, double clockwiseDeg);
    void drawRegion(std::int32_t row, const Origin& origin, ShapeSketch region);
    /// Ordinals of what is drawn on a row from now on begin here.
    [[nodiscard]] std::uint32_t drawnOn(std::int32_t row);
    /// The point on the grid; none if it is out of range, which is reported.
    [[nodiscard]] std::optional<Point> onGrid(PointD p, std::uint32_t line);

private:
    [[nodiscard]] formats::DrawnFeature& add(std::int32_t row, const Origin& origin, formats::DrawnKind kind);

    formats::DrawnJob& m_job;
    std::string m_file;
    BoardLayers m_layers;
    BoardSettings m_settings;
    ZoneFills m_zoneFills;
    std::unordered_map<std::string, std::int32_t> m_netOfName;
    std::unordered_map<std::int64_t, std::int32_t> m_netOfNumber;
    std::unordered_map<std::string, std::int32_t> m_symbols;
    std::unordered_map<Nm, std::int32_t> m_pens;
    std::map<formats::Words, std::int32_t> m_attributes;
};

}  // namespace model::kicad
