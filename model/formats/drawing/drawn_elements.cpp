#include "model/formats/drawing/drawn_elements.h"

#include <cmath>
#include <numeric>

#include "model/base/limits.h"
#include "model/formats/common/element_maker.h"
#include "model/geometry/outlines.h"

namespace model::formats {

namespace {

template <class Rows>
bool holds(const Rows& rows, std::int32_t row) {
    return row >= 0 && static_cast<std::size_t>(row) < rows.size();
}

Placement placementOf(const DrawnFeature& feature) {
    const double degrees = std::fmod(feature.clockwiseDeg, 360.0);
    return {feature.a, degrees < 0 ? degrees + 360.0 : degrees, feature.isMirrored};
}

Point between(Point a, Point b) {
    return {std::midpoint(a.x, b.x), std::midpoint(a.y, b.y)};
}

class DrawnElements {
public:
    DrawnElements(DocumentBuilder& builder, DrawnNets& nets, Diagnostics& diagnostics, const DrawnSource& source,
                  const HoleRules* holes)
        : m_builder(builder),
          m_nets(nets),
          m_diagnostics(diagnostics),
          m_source(source),
          m_step(*source.step),
          m_maker(builder, diagnostics, source.path, holes),
          m_symbols(m_step.symbols.size()),
          m_regions(m_step.regions.size()),
          m_attributes(m_step.attributes.size()) {}

    std::vector<std::uint8_t> run() {
        for (std::size_t i = 0; i < m_source.features.size(); ++i) {
            add(i);
        }
        m_maker.endChain();
        return m_maker.negatives();
    }

private:
    void report(Severity severity, const DrawnFeature& feature, std::string_view text) {
        m_diagnostics.report(severity, m_source.path, feature.line, text);
    }

    void add(std::size_t row) {
        const DrawnFeature& feature = m_source.features[row];
        if (feature.kind == DrawnKind::Region) {
            return addRegion(row, feature);
        }
        if (!holds(m_step.symbols, feature.symbol)) {
            m_maker.endChain();
            return report(Severity::Warning, feature, "a feature names a symbol that is not there; it draws nothing");
        }
        const PadShape& shape = shapeOf(feature);
        if (feature.kind == DrawnKind::Pad) {
            return m_maker.addPad(sourceOf(row, feature), shape, placementOf(feature));
        }
        PathNode start{feature.a, feature.centre, EdgeKind::Line};
        if (feature.kind == DrawnKind::Arc) {
            start.edge = feature.isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        }
        m_maker.addTrack(sourceOf(row, feature), shape, start, feature.b);
    }

    void addRegion(std::size_t row, const DrawnFeature& feature) {
        m_maker.endChain();
        const bool isKnown = holds(m_step.regions, feature.region);
        if (!isKnown || m_step.regions[static_cast<std::size_t>(feature.region)].isEmpty()) {
            return report(Severity::Warning, feature,
                          isKnown ? "a region without a usable polygon draws nothing"
                                  : "a feature names a region that is not there; it draws nothing");
        }
        if (hasTooManyCorners(m_step.regions[static_cast<std::size_t>(feature.region)])) {
            return report(Severity::Error, feature,
                          "a contour of " + base::moreThan(base::kMostCorners, "corners") + "; it was left out");
        }
        ShapeId& shape = m_regions[static_cast<std::size_t>(feature.region)];
        if (!shape.isValid()) {
            shape = m_builder.addShape(m_step.regions[static_cast<std::size_t>(feature.region)]);
        }
        m_maker.addArea(sourceOf(row, feature), shape, placementOf(feature));
    }

    /// What is wrong with a symbol is said where it is used.
    const PadShape& shapeOf(const DrawnFeature& feature) {
        const DrawnSymbol& symbol = m_step.symbols[static_cast<std::size_t>(feature.symbol)];
        if (!symbol.shape.problem.empty()) {
            report(Severity::Warning, feature, "symbol " + symbol.name + ": " + symbol.shape.problem);
        }
        return symbol.shape;
    }

    ElementSource sourceOf(std::size_t row, const DrawnFeature& feature) {
        reportMissing(feature);
        const DrawnLink link = m_nets.linkOf(feature, m_source.layer);
        ElementSource source;
        source.origin = {
            link.net, symbolOf(feature), attributesOf(feature), static_cast<std::uint32_t>(row), feature.line,
            0,        link.subnet};
        source.isNegative = feature.isNegative;
        source.hit = hitOf(feature, link.net.isValid());
        return source;
    }

    void reportMissing(const DrawnFeature& feature) {
        if (feature.net != kNoRow && !m_nets.net(feature.net).isValid()) {
            report(Severity::Warning, feature, "a feature names a net that is not there; it has none");
        }
        const bool hasPin = feature.component != kNoRow || feature.pin != kNoRow;
        if (hasPin && (!holds(m_step.components, feature.component) ||
                       !holds(m_step.components[static_cast<std::size_t>(feature.component)].pins, feature.pin))) {
            report(Severity::Warning, feature, "a feature names a pin that is not there; it belongs to none");
        }
        if (feature.attributes != kNoRow && !holds(m_step.attributes, feature.attributes)) {
            report(Severity::Warning, feature, "a feature names attributes that are not there; it has none");
        }
    }

    SymbolId symbolOf(const DrawnFeature& feature) {
        if (feature.kind == DrawnKind::Region) {
            return {};
        }
        SymbolId& id = m_symbols[static_cast<std::size_t>(feature.symbol)];
        if (!id.isValid()) {
            id = m_builder.symbol(m_step.symbols[static_cast<std::size_t>(feature.symbol)].name);
        }
        return id;
    }

    AttributeSetId attributesOf(const DrawnFeature& feature) {
        if (!holds(m_attributes, feature.attributes)) {
            return {};
        }
        AttributeSetId& set = m_attributes[static_cast<std::size_t>(feature.attributes)];
        if (!set.isValid()) {
            set = m_builder.attributes(m_step.attributes[static_cast<std::size_t>(feature.attributes)]);
        }
        return set;
    }

    /// A hole of a via is a via, whichever way the job says so.
    [[nodiscard]] DrillHit hitOf(const DrawnFeature& feature, bool hasNet) const {
        DrillHit hit{feature.plating, {}, hasNet, feature.subnet == SubnetKind::Via};
        switch (feature.kind) {
            case DrawnKind::Pad: hit.centre = feature.a; break;
            case DrawnKind::Line: hit.centre = between(feature.a, feature.b); break;
            case DrawnKind::Arc: break;
            case DrawnKind::Region: hit.centre = middleOf(feature); break;
        }
        return hit;
    }

    [[nodiscard]] std::optional<Point> middleOf(const DrawnFeature& feature) const {
        const ShapeId shape = m_regions[static_cast<std::size_t>(feature.region)];
        const Box box = m_builder.shapes().shapes[shape.row()].box;
        return placementOf(feature).apply(box.middle());
    }

    DocumentBuilder& m_builder;
    DrawnNets& m_nets;
    Diagnostics& m_diagnostics;
    const DrawnSource& m_source;
    const DrawnStep& m_step;
    ElementMaker m_maker;
    std::vector<SymbolId> m_symbols;  ///< by row of the step, made when first used, as the others
    std::vector<ShapeId> m_regions;
    std::vector<AttributeSetId> m_attributes;
};

}  // namespace

std::vector<std::uint8_t> addDrawn(DocumentBuilder& builder, DrawnNets& nets, Diagnostics& diagnostics,
                                   const DrawnSource& source, const HoleRules* holes) {
    return DrawnElements(builder, nets, diagnostics, source, holes).run();
}

}  // namespace model::formats
