#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/common/hole_rules.h"
#include "model/formats/common/pad_shape.h"
#include "model/formats/common/text_layout.h"
#include "model/geometry/discretise.h"

namespace model::formats {

/// What a reader knows about the record that an element comes from. `origin.flags` are left to the maker.
struct ElementSource {
    DocumentBuilder::Origin origin;
    bool isNegative = false;
    DrillHit hit;  ///< on layers of holes
};

/// Turns what the files of all formats draw into elements of the builder's current layer:
/// - Tracks with a round pen: Line and Arc; runs of them with one symbol, width, polarity, net and attributes, each
///   starting where the one before ended, are one Trail. Zero-length lines (dots) and full circles stay alone. Straight
///   tracks with a square pen: Line with kSquarePen; all other pens: what they sweep, as an Area.
/// - Pads: Circle for discs and rings, Line for ovals, Area with a shared shape for all others.
/// - Strokes of texts: lines and trails; one Area where they take away from each other.
/// With hole rules every element is a hole. Elements come in the order of the calls; polarity is kept beside them.
class ElementMaker {
public:
    /// `path` is the file, for diagnostics. All must live as long as the maker.
    ElementMaker(DocumentBuilder& builder, Diagnostics& diagnostics, std::string_view path, const HoleRules* holes)
        : m_builder(builder), m_diagnostics(diagnostics), m_path(path), m_holes(holes) {}

    /// One edge drawn with a pen, which must stay where it is.
    void addTrack(const ElementSource& source, const PadShape& pen, PathNode start, Point end);
    /// The shape must stay where it is.
    void addPad(const ElementSource& source, const PadShape& shape, const Placement& placement);
    void addArea(const ElementSource& source, ShapeId shape, const Placement& placement);
    /// One that is a pad.
    void addPadArea(const ElementSource& source, ShapeId shape, const Placement& placement);
    /// Of a text that `placement` lays on the board.
    void addStrokes(const ElementSource& source, std::span<const TextStroke> strokes, const Placement& placement);
    /// Ends the chain of tracks; to be called before whatever else breaks it and when all is added.
    void endChain();

    /// One entry per element added by this maker: 1 when it takes away what was painted before it.
    [[nodiscard]] const std::vector<std::uint8_t>& negatives() const { return m_negatives; }

private:
    struct Chain {
        std::vector<PathNode> nodes;  ///< the last one is the end of the last track
        ElementSource source;         ///< of the first track
        Nm width = 0;
    };

    DocumentBuilder::Origin originOf(const ElementSource& source, int flags) const;
    Hole drill(const ElementSource& source, Nm size, DocumentBuilder::Origin& origin);
    [[nodiscard]] bool continues(const ElementSource& source, Point start, Nm width) const;
    void extend(const ElementSource& source, const PathNode& start, const PathNode& end, Nm width, bool isJoined);
    void addSingleTrack(const ElementSource& source, std::span<const PathNode> nodes, Nm width);
    void addLine(const ElementSource& source, LineGeometry line, int flags);
    void addSweptTrack(const ElementSource& source, const PadShape& pen, const PathNode& start, Point end);
    void addArea(const ElementSource& source, ShapeId shape, const Placement& placement, int flags);
    void addSketch(const ElementSource& source, const ShapeSketch& sketch, const Placement& placement);
    void addDisc(const ElementSource& source, const PadShape& shape, Point centre);
    void addOval(const ElementSource& source, const PadShape& shape, const Placement& placement);
    void addSquareStroke(const ElementSource& source, const TextStroke& stroke, const Placement& placement);
    void paintStrokes(const ElementSource& source, std::span<const TextStroke> strokes, const Placement& placement);
    [[nodiscard]] ShapeId regionOf(const PadShape& shape);
    void note(const ElementSource& source) { m_negatives.push_back(source.isNegative ? 1 : 0); }
    void report(Severity severity, const ElementSource& source, std::string_view text);

    DocumentBuilder& m_builder;
    Diagnostics& m_diagnostics;
    std::string_view m_path;
    const HoleRules* m_holes;
    std::vector<std::uint8_t> m_negatives;
    std::map<const PadShape*, ShapeId> m_regions;
    std::map<const PadShape*, PolygonSet> m_pens;  ///< of tracks that are swept
    Chain m_chain;
};

}  // namespace model::formats
