#include "model/export/stackup_export.h"

#include <algorithm>

#include "model/base/ascii.h"
#include "model/board/stackup.h"
#include "model/board/stackup_checks.h"
#include "model/board/stackup_table.h"
#include "model/export/stackup_sheet.h"
#include "model/text/formatting.h"

namespace model {

namespace {

const char* anchorOf(SheetAlign align) {
    return align == SheetAlign::Left     ? ""
           : align == SheetAlign::Middle ? " text-anchor=\"middle\""
                                         : " text-anchor=\"end\"";
}

std::string svgOf(const SheetRect& rect) {
    return formatted(
        "<rect x=\"%.1f\" y=\"%.3f\" width=\"%.1f\" height=\"%.3f\" fill=\"#%06x\" stroke=\"#%06x\" "
        "stroke-width=\"%.1f\"/>\n",
        rect.x, rect.y, rect.width, rect.height, rect.fill, rect.edge, rect.edgeWidth);
}

std::string svgOf(const SheetLeader& leader) {
    return formatted(
        "<path d=\"M%.1f %.2f h8 L%.1f %.2f h6\" fill=\"none\" stroke=\"#888888\" stroke-width=\"0.7\"/>\n", leader.x0,
        leader.y0, leader.x1 - 6, leader.y1);
}

std::string svgOf(const SheetText& text) {
    const std::string style = std::string(anchorOf(text.align)) + (text.isBold ? " font-weight=\"bold\"" : "") +
                              (text.isItalic ? " font-style=\"italic\"" : "");
    return text.text.empty() ? "" : svgText(text.x, text.y, text.text, style.c_str());
}

template <class Parts>
std::string svgOfAll(const Parts& parts) {
    std::string out;
    for (const auto& part : parts) {
        out += svgOf(part);
    }
    return out;
}

std::string csvNumber(const std::optional<double>& value) {
    return value ? formatted("%.6g", *value) : "";
}

std::string csvHeadings(const std::vector<Substack>& parts) {
    std::string out =
        "order,layer,type,thickness_nm,thickness_source,z_nm,copper_oz,material,material_type,dielectric_constant,"
        "loss_tangent,kind";
    for (const Substack& part : parts) {
        out += ',' + csvField(part.name.empty() ? "cumulative_nm" : "cumulative_nm in " + part.name);
    }
    return out + ",findings\r\n";
}

/// The texts of what was found about a row.
std::string findingsOf(const std::vector<StackupFinding>& findings, std::size_t row) {
    std::vector<std::string> texts;
    for (const StackupFinding& finding : findings) {
        if (std::ranges::find(finding.rows, row) != finding.rows.end()) {
            texts.push_back(finding.text);
        }
    }
    return joined(texts, "; ");
}

std::string csvRow(const Document& document, std::size_t number) {
    const StackupRow& row = document.stackup.rows[number];
    const std::optional<CopperWeight> weight = copperWeightOf(row);
    return std::to_string(number + 1) + ',' + csvField(row.name) + ',' + toString(row.type) + ',' +
           std::to_string(row.thickness) + ',' + toString(row.source) + ',' + std::to_string(row.z) + ',' +
           csvNumber(weight ? std::optional(weight->oz) : std::nullopt) + ',' + csvField(row.material.name) + ',' +
           csvField(row.material.type) + ',' + csvNumber(row.material.dielectricConstant) + ',' +
           csvNumber(row.material.lossTangent) + ',' + toString(kindOf(row, document));
}

}  // namespace

std::string stackupSvg(const Document& document, bool isExaggerated, const LengthWriter& write) {
    const StackupSheet sheet = stackupSheet(document, isExaggerated, write);
    return svgStart(sheet.width, sheet.height) + svgOfAll(sheet.rects) + svgOfAll(sheet.leaders) +
           svgOfAll(sheet.texts) + "</svg>\n";
}

std::string stackupCsv(const Document& document, const LengthWriter& write) {
    const std::vector<Substack> parts = substacksOf(document);
    const std::vector<StackupFinding> findings = checkStackup(document, write);
    std::string out = csvHeadings(parts);
    for (std::size_t row = 0; row < document.stackup.rows.size(); ++row) {
        out += csvRow(document, row);
        for (const Substack& part : parts) {
            out += ',' + (part.cumulative[row] ? std::to_string(*part.cumulative[row]) : "");
        }
        out += ',' + csvField(findingsOf(findings, row)) + "\r\n";
    }
    return out;
}

base::Result<std::string> stackupFile(const Document& document, const std::filesystem::path& path, bool isExaggerated,
                                      const LengthWriter& write) {
    const std::string ending = base::lowerCase(path.extension().string());
    if (ending != ".svg" && ending != ".csv") {
        return base::Error{base::ErrorCode::BadUsage, path.string() + ": a stackup is written as .svg or .csv"};
    }
    if (document.stackup.rows.empty()) {
        return base::Error{base::ErrorCode::BadUsage,
                           "This board states its heights itself; there is no stackup to write"};
    }
    return ending == ".svg" ? stackupSvg(document, isExaggerated, write) : stackupCsv(document, write);
}

}  // namespace model
