#include "model/export/section_export.h"

#include <algorithm>
#include <cmath>

#include "model/export/stackup_drawing.h"
#include "model/text/formatting.h"

namespace model {

namespace {

// Pixels.
constexpr double kMargin = 20;
constexpr double kLine = 18;
constexpr double kWidth = 1100;       ///< of the cut
constexpr double kBoardHeight = 260;  ///< about, of the board in the cut; more where its stackup has many rows
constexpr double kTop = 4 * kLine;
constexpr double kLabels = 300;

/// From nanometres to pixels.
struct Scale {
    double perNm = 1.0;
    double times = 1.0;  ///< heights
    double top = 0.0;    ///< nm, of all that is drawn
    double bottom = 0.0;

    [[nodiscard]] double x(double along) const { return kMargin + along * perNm; }
    [[nodiscard]] double y(double z) const { return kTop + (top - z) * perNm * times; }
    [[nodiscard]] double height() const { return (top - bottom) * perNm * times; }
};

/// The next smaller of 1, 2, 5, 10, 20, …
double roundNumber(double value) {
    const double ten = std::pow(10.0, std::floor(std::log10(value)));
    return value >= 5 * ten ? 5 * ten : value >= 2 * ten ? 2 * ten : ten;
}

Scale scaleFor(const Document& board, const Section& section, double heightTimes) {
    Scale scale;
    scale.perNm = kWidth / section.stations.back();
    scale.top = board.boardThickness;
    double tallest = scale.top;
    double deepest = 0.0;
    for (const SectionPiece& piece : section.pieces) {
        const bool isPart = board.layer(piece.layer).type == LayerType::ComponentBody;
        (isPart ? tallest : scale.top) = std::max<double>(isPart ? tallest : scale.top, piece.top);
        (isPart ? deepest : scale.bottom) = std::min<double>(isPart ? deepest : scale.bottom, piece.bottom);
    }
    const double thickness = std::max(scale.top - scale.bottom, 1.0);
    scale.top = std::clamp(tallest, scale.top, scale.top + thickness);
    scale.bottom = std::clamp(deepest, scale.bottom - thickness, scale.bottom);
    const double wanted = std::max(kBoardHeight, kLine * static_cast<double>(board.stackup.rows.size()));
    scale.times = heightTimes > 0.0 ? heightTimes : std::max(1.0, roundNumber(1.4 * wanted / thickness / scale.perNm));
    return scale;
}

/// What others lie in or stand upon is drawn first.
int orderOf(const Layer& layer) {
    return layer.type == LayerType::Body || layer.type == LayerType::Dielectric ? 0
           : layer.type == LayerType::ComponentBody                             ? 1
                                                                                : 2;
}

std::string svgPieces(const Document& board, const Section& section, const SectionPicture& how, const Scale& scale) {
    std::vector<SectionPiece> pieces = merged(section.pieces);
    std::ranges::stable_sort(pieces, {}, [&](const SectionPiece& piece) { return orderOf(board.layer(piece.layer)); });
    std::string out;
    for (const SectionPiece& piece : pieces) {
        const double top = scale.y(std::min<double>(piece.top, scale.top));
        const double bottom = scale.y(std::max<double>(piece.bottom, scale.bottom));
        out += formatted("<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"#%06x\"/>\n",
                         scale.x(piece.from), top, (piece.to - piece.from) * scale.perNm, std::max(bottom - top, 0.5),
                         how.colours[piece.layer.row()]);
    }
    return "<g stroke=\"#00000050\" stroke-width=\"0.3\">\n" + out + "</g>\n";
}

/// Names and thicknesses of the stackup's rows.
std::string svgStackup(const Document& board, const Scale& scale) {
    StackupDrawing labels;
    for (const StackupRow& row : board.stackup.rows) {
        const double top = scale.y(double{1} * row.z + row.thickness) - kTop;
        const double bottom = scale.y(row.z) - kTop;
        labels.bands.push_back({top, bottom, (top + bottom) / 2});
    }
    labels.height = std::max(scale.height(), kLine * static_cast<double>(labels.bands.size()));
    spreadLabels(kLine, labels);
    const double right = kMargin + kWidth;
    std::string out;
    for (std::size_t i = 0; i < labels.bands.size(); ++i) {
        const StackupBand& band = labels.bands[i];
        const StackupRow& row = board.stackup.rows[i];
        out += formatted(
            "<path d=\"M%.1f %.2f V%.2f M%.1f %.2f h5 l15 %.2f h5\" fill=\"none\" stroke=\"#888888\" "
            "stroke-width=\"0.7\"/>\n",
            right + 4, kTop + band.top, kTop + band.bottom, right + 4, kTop + (band.top + band.bottom) / 2,
            band.label - (band.top + band.bottom) / 2);
        const char* style = row.source == Source::Assumed ? " font-style=\"italic\"" : "";
        out += svgText(right + 34, kTop + band.label + 4, row.name);
        out += svgText(right + kLabels - 70, kTop + band.label + 4, lengthText(row.thickness), style);
    }
    return out;
}

/// Where the line turns.
std::string svgCorners(const Section& section, const Scale& scale) {
    std::string out;
    for (std::size_t i = 1; i + 1 < section.stations.size(); ++i) {
        out += formatted(
            "<path d=\"M%.2f %.1f V%.1f\" stroke=\"#404040\" stroke-width=\"0.7\" stroke-dasharray=\"4 3\"/>\n",
            scale.x(section.stations[i]), kTop - 8, kTop + scale.height() + 8);
    }
    return out;
}

std::string svgBar(const Scale& scale, double y) {
    const double length = roundNumber(kWidth / 4 / scale.perNm);
    return formatted("<path d=\"M%.1f %.1f v6 h%.2f v-6\" fill=\"none\" stroke=\"#000000\"/>\n", kMargin, y - 6,
                     length * scale.perNm) +
           svgText(kMargin + length * scale.perNm + 8, y + 4, lengthText(static_cast<Nm>(length)));
}

std::string positionText(PointD p) {
    return formatted("(%.4g, %.4g)", base::toMm(p.x), base::toMm(p.y));
}

std::string titleOf(const Document& board, const Section& section, const Scale& scale) {
    return board.job.name + ": section from " + positionText(section.line.front()) + " to " +
           positionText(section.line.back()) +
           formatted(" mm, %.5g mm long, heights %g times", base::toMm(section.stations.back()), scale.times);
}

void addRows(const BoardIndex& index, const char* what, const std::vector<SectionPiece>& pieces, std::string& out) {
    for (const SectionPiece& piece : pieces) {
        out += std::string(what) + ',' + csvField(index.board->layer(piece.layer).name) + ',' +
               std::to_string(piece.at.copy) + ',' + std::to_string(piece.at.element.value) + ',' +
               csvField(netOf(index, piece)) +
               formatted(",%.3f,%.3f,%d,%d\r\n", piece.from, piece.to, piece.bottom, piece.top);
    }
}

}  // namespace

std::string sectionSvg(const Document& board, const Section& section, const SectionPicture& how) {
    const Scale scale = scaleFor(board, section, how.heightTimes);
    const double tall = std::max(scale.height(), kLine * static_cast<double>(board.stackup.rows.size()));
    const double below = kTop + tall + 2 * kLine;
    std::string out =
        svgStart(2 * kMargin + kWidth + kLabels, below + kLine * (static_cast<double>(section.notes.size()) + 2.0));
    out += svgText(kMargin, kLine + 4, titleOf(board, section, scale), " font-weight=\"bold\"");
    out += svgPieces(board, section, how, scale) + svgStackup(board, scale) + svgCorners(section, scale);
    out += svgBar(scale, below);
    for (std::size_t i = 0; i < section.notes.size(); ++i) {
        out += svgText(kMargin, below + kLine * (static_cast<double>(i) + 1.5), section.notes[i]);
    }
    return out + "</svg>\n";
}

std::string sectionCsv(const BoardIndex& index, const Section& section) {
    std::string out = "what,layer,copy,element,net,from_nm,to_nm,bottom_nm,top_nm\r\n";
    addRows(index, "solid", section.pieces, out);
    addRows(index, "bore", section.bores, out);
    return out;
}

std::string netOf(const BoardIndex& index, const SectionPiece& piece) {
    const Document& step = index.stepOf(piece.at.copy);
    const NetId net = step.elements.net[piece.at.element.row()];
    return net.isValid() ? step.nets[net.row()].name : "";
}

}  // namespace model
