#pragma once

#include <cstdint>
#include <string_view>

#include "model/formats/odb/text/records.h"
#include "model/geometry/shapes.h"

namespace model::odb {

/// Collects the polygons of one S record into a ShapeTable: OB begins one, OS and OC add an edge, OE ends it. The
/// letter I or H decides between island and hole, never the winding (odb-notes, Features). Polygons that are left open
/// are closed by a straight edge; those without any area are left out; both are reported.
class SurfaceParser {
public:
    /// `at` is kept up to date by the caller.
    SurfaceParser(ShapeTable& table, const FileCursor& at) : m_table(table), m_at(at) {}

    void beginSurface();
    /// Takes one O… record. False when the line is none.
    bool record(std::string_view line);
    /// Row of the finished shape, which is empty when no polygon was usable.
    std::uint32_t endSurface();

private:
    void beginPolygon(Fields fields);
    void segment(Fields fields);
    void curve(Fields fields);
    void endPolygon();
    bool canAdd(const Fields& fields);
    void addEdge(EdgeKind kind, Point centre, Point end);
    void dropPolygon();

    ShapeTable& m_table;
    const FileCursor& m_at;
    std::uint32_t m_firstContour = 0;
    std::uint32_t m_firstNode = 0;
    bool m_isHole = false;
    bool m_isOpen = false;    ///< between OB and OE
    bool m_isBroken = false;  ///< the current polygon has an unreadable record
    bool m_hasIsland = false;
};

}  // namespace model::odb
