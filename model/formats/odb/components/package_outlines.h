#pragma once

#include "model/formats/odb/features/surface_parser.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// Reads the outlines of packages and pins: RC x y width height (from the lower left corner), CR x y radius, SQ x y
/// half, and polygons between CT and CE (or right there, without). Each is an island of the sketch it is added to.
class PackageOutlines {
public:
    /// `at` is kept up to date by the caller.
    explicit PackageOutlines(const FileCursor& at) : m_at(at), m_parser(m_contour, at) {}

    /// Takes the line if it is one of these records. Finished outlines go to `into`; nullptr: there is nothing they
    /// could belong to, which is reported.
    bool record(std::string_view line, ShapeSketch* into);

private:
    void simple(std::string_view kind, Fields fields, ShapeSketch& into);
    void polygon(std::string_view kind, std::string_view line, ShapeSketch& into);
    void endContour(ShapeSketch& into);

    const FileCursor& m_at;
    ShapeTable m_contour;
    bool m_isInContour = false;  ///< between CT and CE
    SurfaceParser m_parser;
};

}  // namespace model::odb
