#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/shapes/paths.h"
#include "model/formats/ipc2581/styles.h"

namespace model::ipc2581 {

/// Contours of one region: the polygon and its cutouts.
struct Region {
    Path outline;
    std::vector<Path> cutouts;
};

/// Adds what shapes draw to the features of a layer, and symbols and regions to those of its step. Coordinates come in
/// nanometres with the turn that lays them on the board.
class Canvas {
public:
    Canvas(Reading& reading, formats::DrawnStep& step) : m_reading(reading), m_step(step) {}

    /// From now on features are added here. `hasHairlines`: lines without width are drawn
    /// too, very thin.
    void beginLayer(std::vector<formats::DrawnFeature>& features, bool hasHairlines) {
        m_features = &features;
        m_hasHairlines = hasHairlines;
    }
    /// What all features have in common until it is changed: net, attributes, plating, polarity …
    formats::DrawnFeature& ink() { return m_ink; }
    /// Of the features added next, for messages.
    void setLine(std::uint32_t line) { m_ink.line = line; }
    [[nodiscard]] std::size_t count() const { return m_features->size(); }
    formats::DrawnFeature& feature(std::size_t index) { return (*m_features)[index]; }

    void addPad(std::int32_t symbol, const Turn& turn);
    /// The edges of a path, each drawn with the pen. Erasing pens take away; broken lines are drawn solid, which is
    /// reported.
    void stroke(const Path& path, const Turn& turn, const LineStyle& pen);
    /// The outline of a symbol, drawn with the pen.
    void strokeSymbol(std::int32_t symbol, const Turn& turn, const LineStyle& pen);
    void fill(const Region& region, const Turn& turn);
    void addRegion(ShapeSketch sketch);
    /// Like the functions without it, but taking away.
    template <class Draw>
    void clear(const Draw& draw) {
        m_ink.isNegative = !m_ink.isNegative;
        draw();
        m_ink.isNegative = !m_ink.isNegative;
    }

    /// Row of DrawnStep::symbols; -1: there is none of that name.
    [[nodiscard]] std::int32_t findSymbol(const std::string& name) const;
    std::int32_t addSymbol(std::string name, formats::PadShape shape);
    [[nodiscard]] const formats::PadShape& symbol(std::int32_t row) const {
        return m_step.symbols[static_cast<std::size_t>(row)].shape;
    }
    /// A round symbol, in whole nanometres.
    std::int32_t roundSymbol(Nm diameter);
    /// The region's contours where the turn lays them; empty if they have no area, which is reported.
    [[nodiscard]] ShapeSketch sketchOf(const Region& region, const Turn& turn);

private:
    formats::DrawnFeature& add(formats::DrawnKind kind);
    void strokeEdges(const Path& path, const Turn& turn, const LineStyle& pen);
    void strokeEdge(const LaidEdge& edge, const LineStyle& pen);
    void addLine(const LaidEdge& edge, std::int32_t symbol);
    void addBar(const LaidEdge& edge, double width, double beyond);
    [[nodiscard]] bool addContour(ShapeSketch& sketch, const Path& path, const Turn& turn, bool isHole);
    /// Width to draw with in whole nanometres; 0: nothing is drawn.
    Nm penWidth(double width);
    std::int32_t squareSymbol(Nm side);

    Reading& m_reading;
    formats::DrawnStep& m_step;
    std::vector<formats::DrawnFeature>* m_features = nullptr;
    bool m_hasHairlines = false;
    formats::DrawnFeature m_ink;
    std::unordered_map<std::string, std::int32_t> m_symbols;
    std::unordered_map<Nm, std::int32_t> m_rounds;
    std::unordered_map<Nm, std::int32_t> m_squares;
    std::vector<PathNode> m_nodes;  ///< kept from contour to contour
};

}  // namespace model::ipc2581
