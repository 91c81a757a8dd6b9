#include "model/formats/odb/elements/feature_elements.h"

#include <cmath>
#include <numeric>

#include "model/base/limits.h"
#include "model/formats/common/element_maker.h"
#include "model/formats/odb/symbols/barcode.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::odb {

namespace {

Placement placementOf(const Feature& feature) {
    const double degrees = std::fmod(feature.clockwiseDeg, 360.0);
    return {feature.a, degrees < 0 ? degrees + 360.0 : degrees, feature.isMirrored};
}

formats::DrillHit hitOf(const Feature& feature, bool hasNet) {
    formats::DrillHit hit{feature.plating, {}, hasNet};
    if (feature.kind == FeatureKind::Pad) {
        hit.centre = feature.a;
    } else if (feature.kind == FeatureKind::Line) {
        hit.centre = {std::midpoint(feature.a.x, feature.b.x), std::midpoint(feature.a.y, feature.b.y)};
    }
    return hit;
}

class FeatureElements {
public:
    FeatureElements(DocumentBuilder& builder, SymbolLibrary& symbols, Diagnostics& diagnostics,
                    const FeatureSource& source, const formats::HoleRules* holes)
        : m_builder(builder),
          m_symbols(symbols),
          m_diagnostics(diagnostics),
          m_source(source),
          m_file(*source.file),
          m_isOfHoles(holes != nullptr),
          m_maker(builder, diagnostics, source.path, holes),
          m_resolved(m_file.symbols.size()),
          m_attributes(m_file.attributes.sets.size()) {}

    std::vector<std::uint8_t> run() {
        for (std::size_t i = 0; i < m_file.features.size(); ++i) {
            switch (m_file.features[i].kind) {
                case FeatureKind::Line:
                case FeatureKind::Arc: addTrack(i); break;
                case FeatureKind::Pad: addPad(i); break;
                case FeatureKind::Surface: addSurface(i); break;
                case FeatureKind::Text: addText(i); break;
                case FeatureKind::Barcode: addBarcode(i); break;
                case FeatureKind::Bad: m_maker.endChain(); break;  // reported by the parser
            }
        }
        m_maker.endChain();
        return m_maker.negatives();
    }

private:
    /// A symbol of the file, resolved when it is first used.
    struct Resolved {
        const PadShape* shape = nullptr;
        SymbolId id;
    };

    const Resolved& resolve(const Feature& feature) {
        const SymbolRef& symbol = m_file.symbols[feature.index];
        Resolved& resolved = m_resolved[feature.index];
        if (resolved.shape == nullptr) {
            resolved = {&m_symbols.shape(symbol), m_builder.symbol(symbol.name)};
        }
        if (!resolved.shape->problem.empty()) {
            m_symbols.reportProblem(symbol, *resolved.shape, m_source.path, feature.line);
        }
        return resolved;
    }

    formats::ElementSource sourceOf(std::size_t row, SymbolId symbol = {}) {
        const Feature& feature = m_file.features[row];
        const NetLink link = row < m_source.links.size() ? m_source.links[row] : NetLink{};
        formats::ElementSource source;
        source.origin = {link.net, symbol,     attributesOf(feature), static_cast<std::uint32_t>(row), feature.line,
                         0,        link.subnet};
        source.isNegative = feature.isNegative;
        source.hit = hitOf(feature, link.net.isValid());
        return source;
    }

    /// Sets are put into words once each.
    AttributeSetId attributesOf(const Feature& feature) {
        if (m_source.attributeTypes == nullptr || feature.attributes == FeatureAttributes::kNone) {
            return {};
        }
        AttributeSetId& set = m_attributes[feature.attributes];
        if (!set.isValid()) {
            set = m_builder.attributes(m_file.attributes.values(feature.attributes, *m_source.attributeTypes));
        }
        return set;
    }

    void report(Severity severity, const Feature& feature, std::string_view text) {
        m_diagnostics.report(severity, m_source.path, feature.line, text);
    }

    void addTrack(std::size_t row) {
        const Feature& feature = m_file.features[row];
        const Resolved& pen = resolve(feature);
        PathNode start{feature.a, feature.centre, EdgeKind::Line};
        if (feature.kind == FeatureKind::Arc) {
            start.edge = feature.isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        }
        m_maker.addTrack(sourceOf(row, pen.id), *pen.shape, start, feature.b);
    }

    void addPad(std::size_t row) {
        const Resolved& symbol = resolve(m_file.features[row]);
        m_maker.addPad(sourceOf(row, symbol.id), *symbol.shape, placementOf(m_file.features[row]));
    }

    void addSurface(std::size_t row) {
        const Feature& feature = m_file.features[row];
        if (m_file.surfaces.shapes[feature.index].contourCount == 0) {
            m_maker.endChain();
            return report(Severity::Warning, feature, "a surface without a usable polygon draws nothing");
        }
        ShapeSketch sketch = sketchOf(m_file.surfaces, ShapeId{std::size_t{feature.index}});
        if (hasTooManyCorners(sketch)) {
            m_maker.endChain();
            return report(Severity::Error, feature,
                          "a contour of " + base::moreThan(base::kMostCorners, "corners") + "; it was left out");
        }
        const ShapeId shape = m_builder.addShape(std::move(sketch));
        const bool isPad = !m_isOfHoles && row < m_source.links.size() && m_source.links[row].isOfPin;
        isPad ? m_maker.addPadArea(sourceOf(row), shape, {}) : m_maker.addArea(sourceOf(row), shape, {});
    }

    void addText(std::size_t row) {
        const Feature& feature = m_file.features[row];
        const TextRecord& record = m_file.texts[feature.index];
        const formats::Font& font = m_symbols.fonts().font(record.font, m_source.path, feature.line);
        const formats::TextLayout layout = layOut(record.line, font);
        if (!layout.problem.empty()) {
            report(Severity::Warning, feature, layout.problem);
        }
        m_maker.addStrokes(sourceOf(row), layout.strokes, placementOf(feature));
    }

    void addBarcode(std::size_t row) {
        const Feature& feature = m_file.features[row];
        const BarcodeRecord& record = m_file.barcodes[feature.index];
        m_maker.endChain();
        if (record.elementWidth <= 0 || record.height <= 0) {
            return report(Severity::Warning, feature, "a barcode without a size draws nothing");
        }
        const formats::Font& font = record.hasString ? m_symbols.fonts().font(record.font, m_source.path, feature.line)
                                                     : formats::standInFont();
        const BarcodeLayout layout = layOut(record, font);
        if (!layout.problem.empty()) {
            report(Severity::Warning, feature, layout.problem);
        }
        if (record.hasString) {
            report(Severity::Info, feature, "a barcode does not say how large its text is; taken as 1.5 mm");
        }
        const formats::ElementSource source = sourceOf(row);
        if (!layout.bars.isEmpty()) {
            m_maker.addArea(source, m_builder.addShape(layout.bars), placementOf(feature));
        }
        m_maker.addStrokes(source, layout.string, placementOf(feature));
    }

    DocumentBuilder& m_builder;
    SymbolLibrary& m_symbols;
    Diagnostics& m_diagnostics;
    const FeatureSource& m_source;
    const FeatureFile& m_file;
    bool m_isOfHoles;
    formats::ElementMaker m_maker;
    std::vector<Resolved> m_resolved;
    std::vector<AttributeSetId> m_attributes;  ///< by set of the file; made when first needed
};

}  // namespace

std::vector<std::uint8_t> addFeatures(DocumentBuilder& builder, SymbolLibrary& symbols, Diagnostics& diagnostics,
                                      const FeatureSource& source, const formats::HoleRules* holes) {
    return FeatureElements(builder, symbols, diagnostics, source, holes).run();
}

}  // namespace model::odb
