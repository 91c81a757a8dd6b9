#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "model/base/ids.h"
#include "model/base/point.h"
#include "model/base/table.h"
#include "model/geometry/curve_table.h"

namespace model {

using base::Box;
using base::Nm;
using base::Point;
using base::PointD;

/// Only contours of shapes have curves: NURBS of any degree (nurbs.h).
enum class EdgeKind : std::uint8_t { Line, ArcClockwise, ArcCounterClockwise, Curve };

constexpr bool isArc(EdgeKind kind) {
    return kind == EdgeKind::ArcClockwise || kind == EdgeKind::ArcCounterClockwise;
}

/// A vertex of a path together with the edge that leaves it towards the next vertex. Used by contours (the last edge
/// returns to the first vertex) and by trails (the last node has no edge). An arc whose two ends coincide is a full
/// circle. The two radii of an arc may differ by rounding in the job (odb-notes, Features): both end points are kept,
/// the drawn radius runs evenly from one to the other.
struct PathNode {
    Point point;
    Point centre;  ///< of the arc that leaves; unused for lines, curves hide their row in it
    EdgeKind edge = EdgeKind::Line;
    constexpr bool operator==(const PathNode&) const = default;

    /// The edge that leaves is the curve in this row of the table that comes with the path. Its first control point is
    /// `point`, its last one the next node's.
    static constexpr PathNode along(Point point, std::uint32_t row) {
        return {point, {static_cast<Nm>(row), 0}, EdgeKind::Curve};
    }
    [[nodiscard]] constexpr std::uint32_t curve() const { return static_cast<std::uint32_t>(centre.x); }
};

/// The nodes of a path with the table that its curves are rows of. As long as what both belong to stays as it is.
struct PathNodes : std::span<const PathNode> {
    const CurveTable* curves = nullptr;  ///< null: no edge is a curve

    template <std::convertible_to<std::span<const PathNode>> Nodes>
    PathNodes(const Nodes& nodes, const CurveTable* table = nullptr)  // NOLINT(google-explicit-constructor)
        : std::span<const PathNode>(nodes), curves(table) {}

    /// Where the edge ends that leaves a node of a closed path.
    [[nodiscard]] Point endOf(std::size_t node) const { return (*this)[node + 1 < size() ? node + 1 : 0].point; }
    [[nodiscard]] NurbsView curveAt(std::size_t node) const { return (*curves)[(*this)[node].curve()]; }
};

/// A closed loop of a shape. Its winding in the job is not to be trusted; `isHole` is.
struct Contour {
    std::uint32_t firstNode = 0;
    std::uint32_t nodeCount = 0;
    bool isHole = false;
};

struct Placement;
class ShapeSketch;

/// All regions of a document: islands, each followed by its holes, with exact edges. A shape is stored
/// once, however many pads use it. Rows are ShapeId.
struct ShapeTable {
    struct Shape {
        std::uint32_t firstContour = 0;
        std::uint32_t contourCount = 0;
        Box box;
    };
    base::Table<Shape> shapes;
    base::Table<Contour> contours;
    base::Table<PathNode> nodes;
    CurveTable curves;

    /// Adds the contours in their order.
    ShapeId add(const ShapeSketch& sketch);
    [[nodiscard]] std::size_t size() const { return shapes.size(); }
    [[nodiscard]] std::span<const Contour> contoursOf(ShapeId id) const {
        const Shape& shape = shapes[id.row()];
        return std::span(contours).subspan(shape.firstContour, shape.contourCount);
    }
    [[nodiscard]] PathNodes nodesOf(const Contour& contour) const {
        return {std::span(nodes).subspan(contour.firstNode, contour.nodeCount), &curves};
    }
};

/// A shape under construction, in the same three levels as ShapeTable. Readers fill one and hand it to
/// DocumentBuilder::addShape.
class ShapeSketch {
public:
    /// Starts a contour; nodes added from now on belong to it. The first contour of a sketch must be an island.
    void beginContour(bool isHole);
    /// Not for curves.
    void addNode(const PathNode& node);
    void addNode(Point point) { m_nodes.push_back({point, {}, EdgeKind::Line}); }
    /// A node whose edge is a curve; its ends become `point` and `end`, which is the node to come.
    void addCurve(Point point, const NurbsView& curve, Point end);
    /// One of the nodes of a path, or all, in the contour that is begun.
    void addNode(const PathNodes& path, std::size_t node);
    void addNodes(const PathNodes& path);
    /// A whole contour that is a circle.
    void addCircle(Point centre, Nm radius, bool isHole);
    void addPolygon(std::span<const Point> points, bool isHole);
    /// All contours of another one, where `placement` lays them; arcs stay arcs, curves curves.
    void append(const ShapeSketch& other, const Placement& placement);
    void append(const ShapeTable& table, ShapeId shape, const Placement& placement);

    [[nodiscard]] bool isEmpty() const { return m_nodes.empty(); }
    [[nodiscard]] std::size_t contourCount() const { return m_starts.size(); }
    [[nodiscard]] bool isHole(std::size_t contour) const { return m_holes[contour] != 0; }
    [[nodiscard]] PathNodes contour(std::size_t index) const;
    [[nodiscard]] const CurveTable& curves() const { return m_curves; }

private:
    void append(const PathNodes& path, const Placement& placement);

    std::vector<PathNode> m_nodes;
    CurveTable m_curves;
    std::vector<std::uint32_t> m_starts;
    std::vector<std::uint8_t> m_holes;
};

/// How a shape lies on the board: p' = origin + Mₓᵐ · R_cw(angle) · p — rotated clockwise first, then mirrored x → −x
/// (odb-notes, Features).
struct Placement {
    Point origin;
    double clockwiseDeg = 0.0;
    bool isMirrored = false;

    [[nodiscard]] PointD apply(PointD p) const;
    [[nodiscard]] Point apply(Point p) const;
    /// The box around a placed box.
    [[nodiscard]] Box boxOf(const Box& box) const;
    /// The placement that first does `inner`, then this one.
    [[nodiscard]] Placement after(const Placement& inner) const;
};

[[nodiscard]] bool isIdentity(const Placement& placement);
/// Not for curves: ShapeSketch::append places those.
[[nodiscard]] PathNode placed(const PathNode& node, const Placement& placement);

/// Smallest box around one line or arc, exactly to 1 nm.
[[nodiscard]] Box boxOfEdge(const PathNode& from, Point to);

/// Smallest box around closed or open path nodes; curves are exact to 1 nm too.
[[nodiscard]] Box boxOfPath(const PathNodes& nodes, bool isClosed);

}  // namespace model
