#pragma once

#include <map>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/odb/painting/holes.h"
#include "model/formats/odb/painting/net_links.h"
#include "model/formats/odb/painting/symbols.h"
#include "model/formats/odb/symbols/text_layout.h"
#include "model/geometry/discretise.h"

namespace model::odb {

/// The features of one file on their way to elements.
struct FeatureSource {
    const FeatureFile* file = nullptr;
    std::string_view path;                           ///< for diagnostics
    std::span<const NetLink> links;                  ///< by feature; empty when the file has no nets
    const AttributeTypes* attributeTypes = nullptr;  ///< none: attributes are not kept
};

/// Turns features into elements of the builder's current layer:
/// - L and A with a round symbol: Line and Arc; runs of them with one symbol, polarity, net and attributes, each
///   starting where the one before ended, are one Trail. Zero-length lines (dots) and full circles stay alone. Straight
///   strokes with a square pen: Line with kSquarePen; all other pens: what they sweep, as an Area (swept_strokes.h).
/// - P: Circle for discs and rings, Line for ovals, Area with a shared shape for all others.
/// - S: Area. T: the strokes of its characters, as lines and trails. B: its bars as one Area, its text as strokes.
/// With hole rules every element is a hole. Elements come in the order of their features; polarity is kept beside them.
class ElementMaker {
public:
    ElementMaker(DocumentBuilder& builder, SymbolLibrary& symbols, Diagnostics& diagnostics)
        : m_builder(builder), m_symbols(symbols), m_diagnostics(diagnostics) {}

    void add(const FeatureSource& source, const HoleRules* holes);

    /// One entry per element added by this maker: 1 when it takes away what was painted before it.
    [[nodiscard]] const std::vector<std::uint8_t>& negatives() const { return m_negatives; }

private:
    /// A symbol of the current file, resolved when it is first used.
    struct Resolved {
        const SymbolShape* shape = nullptr;
        SymbolId id;
        PolygonSet pen;  ///< for strokes that are swept; made when first needed
    };
    struct Pending {
        std::vector<PathNode> nodes;  ///< the last one is the end of the last stroke
        std::size_t feature = 0;      ///< of the first stroke
        Nm width = 0;
    };

    Resolved& resolve(std::size_t feature);
    [[nodiscard]] DocumentBuilder::Origin originOf(std::size_t feature);
    [[nodiscard]] NetLink linkOf(std::size_t feature) const;
    [[nodiscard]] AttributeSetId attributesOf(const Feature& feature);
    Hole drill(std::size_t feature, Nm size, DocumentBuilder::Origin& origin);

    void track(std::size_t feature);
    [[nodiscard]] PathNode startOf(std::size_t feature);
    void roundTrack(std::size_t feature, Nm width);
    void extend(std::size_t feature, const PathNode& start, const PathNode& end, Nm width, bool isJoined);
    [[nodiscard]] bool continues(std::size_t feature, const PathNode& start) const;
    void flush();
    void addSingleTrack(std::size_t feature, std::span<const PathNode> nodes, Nm width);
    void addLine(std::size_t feature, LineGeometry line, std::uint8_t flags);
    void squareTrack(std::size_t feature, const Resolved& pen);
    void sweptTrack(std::size_t feature, Resolved& pen);

    void pad(std::size_t feature);
    [[nodiscard]] ShapeId regionOf(const SymbolShape& shape);
    void discPad(std::size_t feature, const SymbolShape& shape);
    void ovalPad(std::size_t feature, const SymbolShape& shape, const Placement& placement);
    void surface(std::size_t feature);
    void text(std::size_t feature);
    void barcode(std::size_t feature);
    void addStrokes(std::size_t feature, std::span<const TextStroke> tracks);
    void squareTextStroke(std::size_t feature, const TextStroke& track, const Placement& placement);
    void paintStrokes(std::size_t feature, std::span<const TextStroke> tracks, const Placement& placement);
    [[nodiscard]] static PolygonSet sweptBy(const TextStroke& track);
    [[nodiscard]] Placement placementOf(std::size_t feature) const;
    void addArea(std::size_t feature, ShapeId shape, const Placement& placement, std::uint8_t flags);
    void note(std::size_t feature) { m_negatives.push_back(m_source.file->features[feature].isNegative ? 1 : 0); }
    void report(Severity severity, std::size_t feature, std::string_view text);

    DocumentBuilder& m_builder;
    SymbolLibrary& m_symbols;
    Diagnostics& m_diagnostics;
    std::vector<std::uint8_t> m_negatives;
    std::map<const SymbolShape*, ShapeId> m_regions;
    std::map<const FeatureFile*, std::vector<ShapeId>> m_surfaces;

    FeatureSource m_source;
    const HoleRules* m_holes = nullptr;
    std::vector<Resolved> m_resolved;
    std::vector<AttributeSetId> m_attributes;  ///< by set of the file; made when first needed
    std::vector<ShapeId>* m_ownSurfaces = nullptr;
    Pending m_pending;
};

}  // namespace model::odb
