#include "model/export/stackup_export.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "model/board/stackup.h"
#include "model/export/stackup_drawing.h"
#include "model/text/formatting.h"

namespace model {

namespace {

// Pixels. Layers on the left with the holes in them, labels on the right, holes explained below.
constexpr double kMargin = 20;
constexpr double kLine = 18;
constexpr double kHeight = 420;
constexpr double kBoardLeft = kMargin;
constexpr double kBoardWidth = 300;
constexpr double kLabelLeft = kBoardLeft + kBoardWidth + 40;
constexpr double kWidth = 860;
constexpr double kTop = 3 * kLine;
constexpr double kBoreWidth = 12;

struct Ink {
    LayerType type;
    const char* colour;
};
constexpr Ink kInks[] = {{LayerType::Signal, "#c8793a"},     {LayerType::PowerGround, "#c8793a"},
                         {LayerType::Mixed, "#c8793a"},      {LayerType::Dielectric, "#d9cfa6"},
                         {LayerType::SolderMask, "#2f8f5b"}, {LayerType::SolderPaste, "#a9adb4"},
                         {LayerType::SilkScreen, "#f4f2e6"}};

const char* colourOf(LayerType type) {
    for (const Ink& ink : kInks) {
        if (ink.type == type) {
            return ink.colour;
        }
    }
    return "#cccccc";
}

std::string svgBand(const StackupRow& row, const StackupBand& band) {
    std::string out = formatted(
        "<rect x=\"%.1f\" y=\"%.3f\" width=\"%.1f\" height=\"%.3f\" fill=\"%s\" stroke=\"#00000040\" "
        "stroke-width=\"0.5\"/>\n",
        kBoardLeft, kTop + band.top, kBoardWidth, band.bottom - band.top, colourOf(row.type));
    const double middle = kTop + (band.top + band.bottom) / 2;
    out +=
        formatted("<path d=\"M%.1f %.2f h8 L%.1f %.2f h6\" fill=\"none\" stroke=\"#888888\" stroke-width=\"0.7\"/>\n",
                  kBoardLeft + kBoardWidth, middle, kLabelLeft - 10, kTop + band.label);
    const double base = kTop + band.label + 4;
    const char* style = row.source == Source::Assumed ? " font-style=\"italic\"" : "";
    out += svgText(kLabelLeft, base, row.name);
    out += svgText(kLabelLeft + 190, base, lengthText(row.thickness), style);
    out += svgText(kLabelLeft + 270, base, toString(row.source), style);
    out += svgText(kLabelLeft + 340, base, row.material.name);
    return out;
}

std::string svgBore(const StackupBarrel& bore, std::size_t number, std::size_t count) {
    const double x = kBoardLeft + kBoardWidth * (static_cast<double>(number) + 0.5) / static_cast<double>(count);
    const bool isBackdrill = bore.span == HoleSpan::Backdrill;
    const char* wall = bore.isPlated ? "#c8793a" : "#888888";
    return formatted(
               "<rect x=\"%.1f\" y=\"%.3f\" width=\"%.1f\" height=\"%.3f\" fill=\"%s\" stroke=\"%s\" "
               "stroke-width=\"%.1f\"/>\n",
               x - kBoreWidth / 2, kTop + bore.top, kBoreWidth, bore.bottom - bore.top,
               isBackdrill ? "#e8c9c9" : "#ffffff", wall, bore.isPlated ? 3.0 : 1.0) +
           svgText(x, kTop - 6, std::to_string(number + 1), " text-anchor=\"middle\"");
}

std::string csvNumber(const std::optional<double>& value) {
    return value ? formatted("%.6g", *value) : "";
}

std::string titleOf(const Document& document, const StackupDrawing& drawing) {
    const std::string scale =
        drawing.copperTimes > 1.0 ? formatted("copper scale x%g, else to scale", drawing.copperTimes) : "to scale";
    return document.job.name + ": " + lengthText(document.boardThickness) + ", " + scale;
}

}  // namespace

std::string stackupSvg(const Document& document, bool isExaggerated) {
    const StackupDrawing drawing = drawStackup(document, {kHeight, kLine, isExaggerated});
    const double height = kTop + drawing.height + kLine * (static_cast<double>(drawing.bores.size()) + 2.0);
    std::string out = svgStart(kWidth, height);
    out += svgText(kMargin, kLine + 4, titleOf(document, drawing), " font-weight=\"bold\"");
    for (std::size_t i = 0; i < drawing.bands.size(); ++i) {
        out += svgBand(document.stackup.rows[i], drawing.bands[i]);
    }
    for (std::size_t i = 0; i < drawing.bores.size(); ++i) {
        out += svgBore(drawing.bores[i], i, drawing.bores.size());
        out += svgText(kMargin, kTop + drawing.height + kLine * (static_cast<double>(i) + 1.5),
                       std::to_string(i + 1) + "  " + boreText(document, drawing.bores[i]));
    }
    return out + "</svg>\n";
}

std::string stackupCsv(const Document& document) {
    std::string out =
        "order,layer,type,thickness_nm,thickness_source,z_nm,copper_oz,material,material_type,dielectric_constant,"
        "loss_tangent\r\n";
    std::size_t order = 0;
    for (const StackupRow& row : document.stackup.rows) {
        const std::optional<CopperWeight> weight = copperWeightOf(row);
        out += std::to_string(++order) + ',' + csvField(row.name) + ',' + toString(row.type) + ',' +
               std::to_string(row.thickness) + ',' + toString(row.source) + ',' + std::to_string(row.z) + ',' +
               csvNumber(weight ? std::optional(weight->oz) : std::nullopt) + ',' + csvField(row.material.name) + ',' +
               csvField(row.material.type) + ',' + csvNumber(row.material.dielectricConstant) + ',' +
               csvNumber(row.material.lossTangent) + "\r\n";
    }
    return out;
}

base::Status writeStackup(const Document& document, const std::filesystem::path& path, bool isExaggerated) {
    const std::string ending = path.extension().string();
    if (ending != ".svg" && ending != ".csv") {
        return base::Error{base::ErrorCode::BadUsage, path.string() + ": a stackup is written as .svg or .csv"};
    }
    if (document.stackup.rows.empty()) {
        return base::Error{base::ErrorCode::BadUsage,
                           "This board states its heights itself; there is no stackup to write"};
    }
    std::ofstream file(path, std::ios::binary);
    file << (ending == ".svg" ? stackupSvg(document, isExaggerated) : stackupCsv(document));
    file.close();
    if (!file) {
        return base::Error{base::ErrorCode::OutputFailed,
                           path.string() + " cannot be written: " + std::strerror(errno)};
    }
    return base::Done{};
}

}  // namespace model
