#pragma once

#include "model/formats/odb/features/surface_parser.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// Reads the outlines of packages and pins: RC x y width height (from the lower left corner), CR x y radius, SQ x y
/// half, and polygons between CT and CE (or right there, without). Each is an island of the sketch it is added to.
class PackageOutlines {
public:
    PackageOutlines(std::string_view path, Diagnostics& diagnostics)
        : m_path(path), m_diagnostics(diagnostics), m_parser(m_contour, path, diagnostics) {}

    /// Takes the line if it is one of these records. Finished outlines go to `into`; nullptr: there is nothing they
    /// could belong to, which is reported.
    bool record(std::string_view line, std::uint32_t number, std::int64_t nmPerUnit, ShapeSketch* into);

private:
    void simple(std::string_view kind, Fields fields, std::uint32_t number, std::int64_t nmPerUnit, ShapeSketch& into);
    void polygon(std::string_view kind, std::string_view line, std::uint32_t number, std::int64_t nmPerUnit,
                 ShapeSketch& into);
    void endContour(std::uint32_t number, ShapeSketch& into);
    void report(std::uint32_t number, std::string_view text);

    std::string_view m_path;
    Diagnostics& m_diagnostics;
    ShapeTable m_contour;
    bool m_isInContour = false;  ///< between CT and CE
    SurfaceParser m_parser;
};

}  // namespace model::odb
