#include "model/export/section_export.h"

#include <algorithm>
#include <cmath>

#include "model/text/formatting.h"

namespace model {

namespace {

constexpr double kStroke = 0.15;  // mm
constexpr double kArrow = 1.6;

std::string svgPolygon(const SheetPolygon& polygon) {
    std::string path;
    for (const auto& contour : polygon.contours) {
        path += path.empty() ? "M" : " M";
        for (const auto& [x, y] : contour) {
            path += formatted("%s%.4f,%.4f", path.back() == 'M' ? "" : " ", x, y);
        }
        path += "z";
    }
    return "<path d=\"" + path + formatted("\" fill=\"#%06x\"/>\n", polygon.fill);
}

/// The tip of an arrow that comes from another location.
std::string svgArrow(double x, double y, double fromX, double fromY) {
    const double length = std::max(std::hypot(fromX - x, fromY - y), 1e-9);
    const double ahead = kArrow / length * (fromX - x);
    const double up = kArrow / length * (fromY - y);
    return formatted("<path d=\"M%.3f %.3f L%.3f %.3f L%.3f %.3f z\" fill=\"#000000\"/>\n", x, y, x + ahead - up / 4,
                     y + up + ahead / 4, x + ahead + up / 4, y + up - ahead / 4);
}

std::string svgLine(const SheetLine& line) {
    std::string out =
        formatted("<path d=\"M%.4f %.4f L%.4f %.4f\" stroke=\"#000000\" stroke-width=\"%.2f\"%s/>\n", line.x0, line.y0,
                  line.x1, line.y1, kStroke, line.isDashed ? " stroke-dasharray=\"1 0.8\"" : "");
    if (line.hasArrows) {
        out += svgArrow(line.x0, line.y0, line.x1, line.y1) + svgArrow(line.x1, line.y1, line.x0, line.y0);
    }
    return out;
}

std::string svgText(const SheetText& text) {
    const char* anchor = text.align == SheetAlign::Left     ? ""
                         : text.align == SheetAlign::Middle ? " text-anchor=\"middle\""
                                                            : " text-anchor=\"end\"";
    return formatted("<text x=\"%.3f\" y=\"%.3f\"%s%s%s>", text.x, text.y, anchor,
                     text.isBold ? " font-weight=\"bold\"" : "", text.isItalic ? " font-style=\"italic\"" : "") +
           xmlText(text.text) + "</text>\n";
}

std::string dielectricFields(const Document& board, const SectionPiece& piece) {
    const StackupRow* row = stackupRowOf(board, piece);
    return row != nullptr ? csvField(row->name) + ',' + std::to_string(row->thickness) : ",";
}

void addRows(const BoardIndex& index, const char* what, const std::vector<SectionPiece>& pieces, std::string& out) {
    for (const SectionPiece& piece : pieces) {
        out += std::string(what) + ',' + csvField(index.board->layer(piece.layer).name) + ',' +
               std::to_string(piece.at.copy) + ',' +
               (piece.at.element.isValid() ? std::to_string(piece.at.element.value) : "") + ',' +
               csvField(netOf(index, piece)) +
               formatted(",%.3f,%.3f,%d,%d,%.3f,%.3f,", piece.from, piece.to, piece.bottom, piece.top,
                         piece.upperFrom(), piece.upperTo()) +
               csvField(piece.material == SectionMaterial::Other ? "" : toString(piece.material)) + ',' +
               dielectricFields(*index.board, piece) + "\r\n";
    }
}

}  // namespace

std::string sectionSvg(const Document& board, const Section& section, const SectionPicture& how) {
    const SectionSheet sheet = sectionSheet(board, section, how);
    std::string out = formatted(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"%.4fmm\" height=\"%.4fmm\" "
        "viewBox=\"0 0 %.4f %.4f\" font-family=\"sans-serif\" font-size=\"%g\">\n"
        "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n<g stroke=\"none\" "
        "shape-rendering=\"crispEdges\">\n",
        sheet.width, sheet.height, sheet.width, sheet.height, sheet.fontSize);
    for (const SheetPolygon& polygon : sheet.polygons) {
        out += svgPolygon(polygon);
    }
    out += "</g>\n";
    for (const SheetLine& line : sheet.lines) {
        out += svgLine(line);
    }
    for (const SheetText& text : sheet.texts) {
        out += svgText(text);
    }
    return out + "</svg>\n";
}

std::string sectionCsv(const BoardIndex& index, const Section& section) {
    std::string out =
        "what,layer,copy,element,net,from_nm,to_nm,bottom_nm,top_nm,upper_from_nm,upper_to_nm,material,"
        "dielectric,dielectric_thickness_nm\r\n";
    addRows(index, "solid", section.pieces, out);
    addRows(index, "bore", section.bores, out);
    return out;
}

std::string netOf(const BoardIndex& index, const SectionPiece& piece) {
    if (!piece.at.element.isValid()) {
        return "";
    }
    const Document& step = index.stepOf(piece.at.copy);
    const NetId net = step.elements.net[piece.at.element.row()];
    return net.isValid() ? step.nets[net.row()].name : "";
}

}  // namespace model
