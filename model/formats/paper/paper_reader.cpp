#include "model/formats/paper/paper_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "model/base/limits.h"
#include "model/base/stopwatch.h"
#include "model/board/document_builder.h"
#include "model/formats/paper/lexer.h"
#include "model/geometry/outlines.h"

namespace model::paper {

namespace {

/// A record that breaks the grammar; caught where the next record begins.
struct SyntaxError {
    std::string text;
};

/// A chain of edges as written: an open or closed path, or one circle.
struct Trail {
    std::vector<PathNode> nodes;  ///< the last node repeats the first one of a closed chain
    std::vector<Nm> widths;       ///< per edge
    std::optional<Nm> radius;     ///< of the circle around nodes[0], if it is one
    CurveTable curves;            ///< what nodes name that are followed by a NURBS

    [[nodiscard]] std::size_t edgeCount() const { return widths.size(); }
};

struct Record {
    bool isShape = false;
    std::uint32_t line = 0;
    std::vector<Trail> contours;  ///< a line has one
};

struct Group {
    std::string type;
    double baseMil = 0.0;
    double thicknessMil = 0.0;
    std::uint32_t line = 0;
    std::vector<Record> records;
};

Nm milToNm(double mil) {
    return static_cast<Nm>(std::llround(mil * base::kNmPerMil));
}

/// One function per kind of record. The format has no description besides the published models.
class Parser {
public:
    Parser(std::string_view text, const std::string& file, Diagnostics& diagnostics, base::Progress& progress)
        : m_lexer(text), m_file(file), m_diagnostics(diagnostics), m_progress(progress) {}

    std::vector<Group> parse() {
        while (!m_lexer.peek().empty() && !m_progress.isCancelled()) {
            if (m_lexer.next() == "LAYERBEGIN") {
                parseLayer();
            } else {
                complain("text outside of a layer was skipped");
            }
        }
        return std::move(m_groups);
    }

private:
    void complain(std::string_view text) { m_diagnostics.report(Severity::Warning, m_file, m_lexer.line(), text); }

    void parseLayer() {
        std::string type;
        double base = 0.0;
        while (true) {
            const std::string_view key = m_lexer.next();
            if (key == "LAYEREND" || key.empty()) {
                return;
            }
            if (key == "LAYERTYPE") {
                type = m_lexer.restOfLine();
            } else if (key == "BASEPLANEHEIGHT") {
                base = tryHeightMil();
            } else if (key == "THICKNESS") {
                m_groups.push_back({type, base, tryHeightMil(), m_lexer.line(), {}});
            } else if (key == "POINTCOUNT" || key == "SEGCOUNT") {
                m_lexer.next();  // counts of what follows: for readers that allocate ahead
            } else if (key == "LINEBEGIN" || key == "SHAPEBEGIN") {
                parseRecord(key == "SHAPEBEGIN");
            } else {
                complain("unknown words inside a layer were skipped");
            }
            m_progress.setFraction(m_lexer.fractionRead());
        }
    }

    void parseRecord(bool isShape) {
        Record record{isShape, m_lexer.line(), {}};
        try {
            if (m_groups.empty()) {
                throw SyntaxError{"a record before the first THICKNESS was left out"};
            }
            expect(isShape ? "SHAPEID" : "LINEID");
            m_lexer.next();
            expect(isShape ? "SHAPEDATA" : "LINEDATA");
            record.contours.push_back(parseTrail());
            if (!isShape && record.contours.front().curves.size() > 0) {
                throw SyntaxError{"a LINE with a NURBS was left out: only edges of a SHAPE may be curves"};
            }
            while (isShape && m_lexer.peek() == "VOIDDATA") {
                m_lexer.next();
                record.contours.push_back(parseTrail());
            }
            expect(isShape ? "SHAPEEND" : "LINEEND");
            m_groups.back().records.push_back(std::move(record));
        } catch (const SyntaxError& error) {
            complain(error.text);
            skipRecord();
        }
    }

    void skipRecord() {
        for (std::string_view word = m_lexer.peek();
             !word.empty() && word != "LINEBEGIN" && word != "SHAPEBEGIN" && word != "LAYEREND";
             word = m_lexer.peek()) {
            m_lexer.next();
        }
    }

    Trail parseTrail() {
        const double nodeCount = number();
        Trail trail;
        if (m_lexer.peek() == "CIRCLE") {
            parseCircle(trail);
            return trail;
        }
        trail.nodes.push_back({point(), {}, EdgeKind::Line});
        for (double i = 1; i < nodeCount; ++i) {
            parseSegment(trail);
        }
        return trail;
    }

    void parseCircle(Trail& trail) {
        m_lexer.next();
        m_lexer.next();  // id
        trail.widths.push_back(length());
        trail.nodes.push_back({point(), {}, EdgeKind::Line});
        trail.radius = length();
    }

    void parseSegment(Trail& trail) {
        const std::string_view kind = m_lexer.next();
        if (kind == "NURBS") {
            return parseCurve(trail);
        }
        if (kind != "STRAIGHT" && kind != "ARC") {
            throw SyntaxError{"a record with an edge that is neither STRAIGHT, ARC, NURBS nor CIRCLE was left out"};
        }
        m_lexer.next();  // id
        trail.widths.push_back(length());
        PathNode& from = trail.nodes.back();
        if (kind == "ARC") {
            from.centre = point();
        }
        const Point to = point();
        if (kind == "ARC") {
            from.edge = m_lexer.next() == "CW" ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        }
        trail.nodes.push_back({to, {}, EdgeKind::Line});
    }

    /// id, width, degree, number of control points; the weight of the first one, which the chain has come to; x, y and
    /// weight of the others; the knots.
    void parseCurve(Trail& trail) {
        m_lexer.next();  // id
        trail.widths.push_back(length());
        Nurbs curve{static_cast<int>(count(kMostDegree)), {}, {}};
        const std::size_t controls = count(kMostControls);
        curve.controls.push_back({toDouble(trail.nodes.back().point), number()});
        while (curve.controls.size() < controls) {
            const double x = coordinate();
            const double y = coordinate();
            curve.controls.push_back({{x, y}, number()});
        }
        while (curve.knots.size() < controls + static_cast<std::size_t>(curve.degree) + 1) {
            curve.knots.push_back(number());
        }
        const Point to = rounded(curve.controls.back().at);
        curve.controls.back().at = toDouble(to);
        if (const std::string fault = faultIn(curve.view()); !fault.empty()) {
            throw SyntaxError{"a record with a curve " + fault + " was left out"};
        }
        trail.nodes.back() = PathNode::along(trail.nodes.back().point, trail.curves.add(curve.view()));
        trail.nodes.push_back({to, {}, EdgeKind::Line});
    }

    /// A whole number from 0 to `most`.
    std::size_t count(std::size_t most) {
        const double value = number();
        if (!(value >= 0 && value <= static_cast<double>(most)) || value != std::floor(value)) {
            throw SyntaxError{"a record with a curve whose degree or number of control points is not from 0 to " +
                              std::to_string(most) + " was left out"};
        }
        return static_cast<std::size_t>(value);
    }

    void expect(std::string_view word) {
        if (m_lexer.peek() != word) {
            throw SyntaxError{"a record without " + std::string(word) + " was left out"};
        }
        m_lexer.next();
    }

    double number() {
        const std::string_view token = m_lexer.next();
        double value = 0.0;
        const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
        if (error != std::errc{} || end != token.data() + token.size()) {
            throw SyntaxError{"a record with something else where a number belongs was left out"};
        }
        return value;
    }

    double tryHeightMil() {
        try {
            return length() / base::kNmPerMil;
        } catch (const SyntaxError&) {
            complain("a height that is no number was read as 0");
            return 0.0;
        }
    }

    Nm length() { return static_cast<Nm>(std::llround(coordinate())); }

    /// In nm; not rounded.
    double coordinate() {
        const double mil = number();
        if (!(std::abs(mil) <= base::kMaxCoordinate / base::kNmPerMil)) {
            throw SyntaxError{"a record with a length or coordinate beyond 1 m was left out"};
        }
        return mil * base::kNmPerMil;
    }

    Point point() {
        const Nm x = length();
        return {x, length()};
    }

    static constexpr std::size_t kMostControls = 100'000;

    Lexer m_lexer;
    const std::string& m_file;
    Diagnostics& m_diagnostics;
    base::Progress& m_progress;
    std::vector<Group> m_groups;
};

/// "Bottom" extrudes downwards from its base, everything else upwards.
double lowerFaceMil(const Group& group) {
    return group.type == "Bottom" ? group.baseMil - group.thicknessMil : group.baseMil;
}

/// "Plane" is the substrate between the copper layers, "MultiLayer" what runs through the whole board (pads and
/// barrels).
LayerType typeOf(const Group& group) {
    return group.type == "Plane" ? LayerType::Dielectric : LayerType::Signal;
}

LayerSide sideOf(const Group& group) {
    if (group.type == "Top") {
        return LayerSide::Top;
    }
    if (group.type == "Bottom") {
        return LayerSide::Bottom;
    }
    return group.type == "MultiLayer" ? LayerSide::Through : LayerSide::Inner;
}

class Builder {
public:
    Builder(DocumentBuilder& out, const std::string& file) : m_out(out), m_file(file) {}

    void addGroup(const Group& group, double lowestMil) {
        Layer layer;
        layer.name = group.type + (m_typesSeen[group.type]++ > 0 ? " " + std::to_string(m_typesSeen[group.type]) : "");
        layer.file = m_file;
        layer.type = typeOf(group);
        layer.side = sideOf(group);
        layer.z = milToNm(lowerFaceMil(group) - lowestMil);
        layer.thickness = milToNm(group.thicknessMil);
        layer.thicknessSource = Source::Job;
        layer.featureCount = static_cast<std::uint32_t>(group.records.size());
        m_out.beginLayer(m_out.addLayer(layer));
        for (std::uint32_t i = 0; i < group.records.size(); ++i) {
            const Record& record = group.records[i];
            DocumentBuilder::Origin origin;
            origin.feature = i;
            origin.line = record.line;
            record.isShape ? addShape(record, origin) : addLine(record, origin);
        }
    }

private:
    void addLine(const Record& record, const DocumentBuilder::Origin& origin) {
        const Trail& trail = record.contours.front();
        if (trail.edgeCount() == 0) {
            m_out.diagnostics().report(Severity::Warning, m_file, record.line, "a LINE without a segment was left out");
        } else if (trail.radius) {
            const Point start{trail.nodes[0].point.x + *trail.radius, trail.nodes[0].point.y};
            m_out.addArc({{start, trail.nodes[0].point, EdgeKind::ArcCounterClockwise}, start, trail.widths[0]},
                         origin);
        } else {
            addTracks(trail, origin);
        }
    }

    void addTracks(const Trail& trail, const DocumentBuilder::Origin& origin) {
        if (trail.edgeCount() > 1) {
            m_out.addTrail(trail.nodes, trail.widths, origin);
        } else if (trail.nodes[0].edge == EdgeKind::Line) {
            m_out.addLine({trail.nodes[0].point, trail.nodes[1].point, trail.widths[0], 0}, origin);
        } else {
            m_out.addArc({trail.nodes[0], trail.nodes[1].point, trail.widths[0]}, origin);
        }
    }

    void addShape(const Record& record, const DocumentBuilder::Origin& origin) {
        const std::vector<Trail>& contours = record.contours;
        if (contours.size() == 2 && contours[0].radius && contours[1].radius &&
            contours[0].nodes[0] == contours[1].nodes[0]) {
            // r_outer <= r_inner is a wall without thickness in the paper's code.
            const Nm inner = std::min(*contours[0].radius, *contours[1].radius);
            m_out.addCircle({contours[0].nodes[0].point, 2 * *contours[0].radius, 2 * inner}, origin);
            return;
        }
        ShapeSketch sketch;
        for (std::size_t i = 0; i < contours.size(); ++i) {
            addContour(contours[i], i > 0, record.line, sketch);
        }
        if (sketch.isEmpty()) {
            m_out.diagnostics().report(Severity::Warning, m_file, record.line,
                                       "a SHAPE without an outline was left out");
            return;
        }
        if (hasTooManyCorners(sketch)) {
            m_out.diagnostics().report(
                Severity::Error, m_file, record.line,
                "a contour of " + base::moreThan(base::kMostCorners, "corners") + "; it was left out");
            return;
        }
        m_out.addArea({m_out.addShape(sketch), {}}, origin);
    }

    void addContour(const Trail& trail, bool isHole, std::uint32_t line, ShapeSketch& sketch) {
        if (trail.radius) {
            sketch.addCircle(trail.nodes[0].point, *trail.radius, isHole);
            return;
        }
        PathNodes nodes(trail.nodes, &trail.curves);
        if (nodes.size() < 2) {
            m_out.diagnostics().report(Severity::Warning, m_file, line, "a contour of one point was left out");
            return;
        }
        if (nodes.back().point == nodes.front().point) {
            nodes = {nodes.first(nodes.size() - 1), &trail.curves};
        } else {
            m_out.diagnostics().report(Severity::Info, m_file, line, "an open contour was closed by a straight edge");
        }
        sketch.beginContour(isHole);
        sketch.addNodes(nodes);
    }

    DocumentBuilder& m_out;
    const std::string& m_file;
    std::unordered_map<std::string, int> m_typesSeen;
};

/// The format has no outline: the box around everything stands in for it.
void assumeOutline(DocumentBuilder& out, const std::string& file) {
    Box extent;
    for (std::size_t i = 0; i < out.soFar().elements.size(); ++i) {
        extent.include(out.soFar().boxOf(ElementId{i}));
    }
    if (extent.isEmpty()) {
        return;
    }
    ShapeSketch sketch;
    addBox(sketch, extent);
    out.setProfile(out.addShape(sketch), Source::Assumed);
    out.diagnostics().report(Severity::Info, file, 0,
                             "the format has no board outline: the box around all elements is used");
}

}  // namespace

bool looksLikeModel(std::string_view head) {
    return Lexer(head).next() == "LAYERBEGIN";
}

base::Result<std::shared_ptr<const Document>> readModel(std::string_view text, const std::filesystem::path& path,
                                                        base::Progress& progress) {
    const std::string file = path.filename().string();
    DocumentBuilder out;
    out.job() = {path.stem().string(), "", "paper text format", "MIL", {"board"}, "board"};

    progress.beginPhase("Reading the model");
    const base::Stopwatch parsing;
    const std::vector<Group> groups = Parser(text, file, out.diagnostics(), progress).parse();
    out.times().parseMs = parsing.milliseconds();
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    if (groups.empty()) {
        return base::Error{base::ErrorCode::BadInput, file + ": holds no layer with a height and a thickness"};
    }

    progress.beginPhase("Building the board");
    const base::Stopwatch creating;
    double lowest = lowerFaceMil(groups.front());
    double highest = lowest;
    for (const Group& group : groups) {
        lowest = std::min(lowest, lowerFaceMil(group));
        highest = std::max(highest, lowerFaceMil(group) + group.thicknessMil);
    }
    Builder builder(out, file);
    for (const Group& group : groups) {
        builder.addGroup(group, lowest);
    }
    assumeOutline(out, file);
    out.setBoardThickness(milToNm(highest - lowest));
    out.times().createMs = creating.milliseconds();
    return out.finish();
}

}  // namespace model::paper
