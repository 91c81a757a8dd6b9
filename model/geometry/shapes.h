#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/ids.h"
#include "model/base/point.h"
#include "model/base/table.h"

namespace model {

using base::Box;
using base::Nm;
using base::Point;
using base::PointD;

enum class EdgeKind : std::uint8_t { Line, ArcClockwise, ArcCounterClockwise };

/// A vertex of a path together with the edge that leaves it towards the next vertex. Used by contours (the last edge
/// returns to the first vertex) and by trails (the last node has no edge). An arc whose two ends coincide is a full
/// circle. The two radii of an arc may differ by rounding in the job (odb-notes, Features): both end points are kept,
/// the drawn radius runs evenly from one to the other.
struct PathNode {
    Point point;
    Point centre;  ///< of the arc that leaves; unused for lines
    EdgeKind edge = EdgeKind::Line;
    constexpr bool operator==(const PathNode&) const = default;
};

/// A closed loop of a shape. Its winding in the job is not to be trusted; `isHole` is.
struct Contour {
    std::uint32_t firstNode = 0;
    std::uint32_t nodeCount = 0;
    bool isHole = false;
};

struct Placement;
class ShapeSketch;

/// All regions of a document: islands, each followed by its holes, with exact line and arc edges. A shape is stored
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

    /// Adds the contours in their order.
    ShapeId add(const ShapeSketch& sketch);
    [[nodiscard]] std::size_t size() const { return shapes.size(); }
    [[nodiscard]] std::span<const Contour> contoursOf(ShapeId id) const {
        const Shape& shape = shapes[id.row()];
        return std::span(contours).subspan(shape.firstContour, shape.contourCount);
    }
    [[nodiscard]] std::span<const PathNode> nodesOf(const Contour& contour) const {
        return std::span(nodes).subspan(contour.firstNode, contour.nodeCount);
    }
};

/// A shape under construction, in the same three levels as ShapeTable. Readers fill one and hand it to
/// DocumentBuilder::addShape.
class ShapeSketch {
public:
    /// Starts a contour; nodes added from now on belong to it. The first contour of a sketch must be an island.
    void beginContour(bool isHole);
    void addNode(const PathNode& node) { m_nodes.push_back(node); }
    void addNode(Point point) { m_nodes.push_back({point, {}, EdgeKind::Line}); }
    /// A whole contour that is a circle.
    void addCircle(Point centre, Nm radius, bool isHole);
    void addPolygon(std::span<const Point> points, bool isHole);
    /// All contours of another one, where `placement` lays them; arcs stay arcs.
    void append(const ShapeSketch& other, const Placement& placement);
    void append(const ShapeTable& table, ShapeId shape, const Placement& placement);

    [[nodiscard]] bool isEmpty() const { return m_nodes.empty(); }
    [[nodiscard]] std::size_t contourCount() const { return m_starts.size(); }
    [[nodiscard]] bool isHole(std::size_t contour) const { return m_holes[contour] != 0; }
    [[nodiscard]] std::span<const PathNode> contour(std::size_t index) const;

private:
    void append(std::span<const PathNode> nodes, const Placement& placement);

    std::vector<PathNode> m_nodes;
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
[[nodiscard]] PathNode placed(const PathNode& node, const Placement& placement);

/// Smallest box around one edge, arcs included exactly to 1 nm.
[[nodiscard]] Box boxOfEdge(const PathNode& from, Point to);

/// Smallest box around closed or open path nodes.
[[nodiscard]] Box boxOfPath(std::span<const PathNode> nodes, bool isClosed);

}  // namespace model
