#pragma once

#include <unordered_map>

#include "model/formats/ipc2581/canvas.h"
#include "model/formats/ipc2581/styles.h"

namespace model::ipc2581 {

/// What an Outline stands for: a line drawn around an area, or the area itself (slots).
enum class OutlineMeaning : std::uint8_t { Line, Area };

/// Reads shapes (standard primitives, polygons, lines, texts, references to dictionaries) and draws them on a canvas.
class ShapeReader {
public:
    ShapeReader(Reading& reading, const Dictionaries& dictionaries, Canvas& canvas)
        : m_reading(reading), m_dictionaries(dictionaries), m_canvas(canvas) {}

    /// Draws the shape whose start tag was read last, laid by `turn`; its coordinates are in units of `unitNm`. False
    /// if the element is no shape.
    bool draw(XmlCursor& at, const Turn& turn, double unitNm);
    /// Draws the standard shape of this id. False if no dictionary has it.
    bool drawStandard(std::string_view id, const Turn& turn);

    void setOutlines(OutlineMeaning meaning) { m_outlines = meaning; }
    /// For lines that bring no LineDesc of their own.
    void setPen(const LineStyle& pen) { m_pen = pen; }

    /// The shape of a contour of polygons, Outline or standard shape as a region where `turn` lays it; for profiles and
    /// outlines of packages. Empty if it is none of them.
    [[nodiscard]] ShapeSketch sketch(XmlCursor& at, const Turn& turn, double unitNm);

private:
    struct Polygon {
        Region region;
        Turn own;
        LineStyle line;
        FillStyle fill;
    };
    /// A standard shape of a dictionary that is simply filled.
    struct FilledShape {
        std::int32_t symbol = formats::kNoRow;
        Turn own;
    };

    bool drawLine(XmlCursor& at, const Turn& turn, double unitNm);
    void drawPolyline(XmlCursor& at, const Turn& turn, double unitNm);
    void drawOutline(XmlCursor& at, const Turn& turn, double unitNm);
    void drawContour(XmlCursor& at, const Turn& turn, double unitNm);
    void drawText(XmlCursor& at, const Turn& turn, double unitNm);
    void drawPrimitive(XmlCursor& at, const Turn& turn, double unitNm);
    void drawSpecial(XmlCursor& at, const Turn& turn, double unitNm);
    bool drawUser(const XmlCursor& at, const Turn& turn);
    bool drawReference(const XmlCursor& at, const Turn& turn);
    void paint(const Polygon& polygon, const Turn& turn);
    void paint(std::int32_t symbol, const Turn& turn, const LineStyle& line, const FillStyle& fill);
    void hatch(const ShapeSketch& area, const FillStyle& fill);

    std::int32_t primitiveSymbol(const XmlCursor& at, double unitNm);
    bool drawStandardContour(XmlCursor& at, std::string_view id, const Turn& turn, double unitNm);
    void readPath(XmlCursor& at, double unitNm, Polygon& polygon, Path& path);
    void readPolygon(XmlCursor& at, double unitNm, Polygon& polygon);
    void readCutout(XmlCursor& at, double unitNm, Polygon& polygon);

    Reading& m_reading;
    const Dictionaries& m_dictionaries;
    Canvas& m_canvas;
    OutlineMeaning m_outlines = OutlineMeaning::Line;
    LineStyle m_pen;
    int m_depth = 0;                                             ///< of shapes within shapes
    int m_references = 0;                                        ///< of them, those read through dictionaries
    std::size_t m_expansions = 0;                                ///< shapes read through references
    std::unordered_map<std::string_view, FilledShape> m_filled;  ///< standard shapes by id, without scale
};

}  // namespace model::ipc2581
