#include "model/export/stackup_sheet.h"

#include <algorithm>

#include "model/board/stackup.h"
#include "model/board/stackup_checks.h"
#include "model/export/stackup_drawing.h"
#include "model/text/formatting.h"
#include "model/text/utf8.h"

namespace model {

namespace {

// Layers on the left with the holes in them, the table on the right, totals, holes and findings below.
constexpr double kMargin = 20;
constexpr double kLine = 18;
constexpr double kHeight = 420;
constexpr double kBoardWidth = 320;
constexpr double kTableLeft = kMargin + kBoardWidth + 40;
constexpr double kTop = 4.5 * kLine;
constexpr double kBoreWidth = 12;
/// A letter takes about so much: what is longer than its column is shortened.
constexpr double kLetter = 6.6;

struct TableColumn {
    const char* heading;
    double width;
    SheetAlign align;
};
constexpr TableColumn kName{"Layer", 160, SheetAlign::Left};
constexpr TableColumn kKind{"Kind", 100, SheetAlign::Left};
constexpr TableColumn kThickness{"Thickness", 75, SheetAlign::Right};
constexpr TableColumn kCumulative{"Cumulative", 95, SheetAlign::Right};
constexpr TableColumn kSource{"From", 60, SheetAlign::Left};
constexpr TableColumn kWeight{"Copper oz", 70, SheetAlign::Right};
constexpr TableColumn kConstant{"Dk", 45, SheetAlign::Right};
constexpr TableColumn kTangent{"Df", 55, SheetAlign::Right};
constexpr TableColumn kMaterial{"Material", 120, SheetAlign::Left};
constexpr double kBetween = 12;

struct Ink {
    StackupKind kind;
    std::uint32_t colour;
};
constexpr Ink kInks[] = {
    {StackupKind::Copper, 0xc8793a},     {StackupKind::Core, 0xcbbf8c},       {StackupKind::Prepreg, 0xe6dfc2},
    {StackupKind::Dielectric, 0xd9cfa6}, {StackupKind::SolderMask, 0x2f8f5b}, {StackupKind::Coverlay, 0xd8962f},
    {StackupKind::Adhesive, 0xf2e3a0},   {StackupKind::Stiffener, 0x9fb08a},  {StackupKind::Finish, 0xe2c65a},
    {StackupKind::Paste, 0xa9adb4},      {StackupKind::Silkscreen, 0xf4f2e6}};

std::uint32_t colourOf(StackupKind kind) {
    const auto* const ink = std::ranges::find(kInks, kind, &Ink::kind);
    return ink == std::end(kInks) ? 0xcccccc : ink->colour;
}

/// "solder mask"
std::string wordsOf(StackupKind kind) {
    std::string words = toString(kind);
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string wordOf(Source source) {
    switch (source) {
        case Source::Job: return "read";
        case Source::Session: return "edited";
        default: return toString(source);
    }
}

std::string numberText(const std::optional<double>& value) {
    return value ? formatted("%.4g", *value) : "";
}

std::string shortened(const std::string& text, double width) {
    const std::size_t end = cutWithin(text, static_cast<std::size_t>(width / kLetter));
    return end == text.size() ? text : text.substr(0, end) + "…";
}

class SheetMaker {
public:
    SheetMaker(const Document& document, bool isExaggerated, const LengthWriter& write)
        : m_document(document), m_write(write), m_drawing(drawStackup(document, {kHeight, kLine, isExaggerated})) {}

    StackupSheet make() {
        if (m_drawing.bands.empty()) {
            return {};
        }
        addTitle();
        addHeadings();
        for (std::size_t row = 0; row < m_drawing.bands.size(); ++row) {
            addBands(row);
            addTableRow(row);
        }
        for (std::size_t bore = 0; bore < m_drawing.bores.size(); ++bore) {
            addBore(bore);
        }
        addBelow();
        m_sheet.width = m_right + kMargin;
        return std::move(m_sheet);
    }

private:
    [[nodiscard]] std::string textOf(Nm length) const { return m_write ? m_write(length) : lengthText(length); }

    void write(double x, double y, std::string text, SheetAlign align = SheetAlign::Left, bool isBold = false,
               bool isItalic = false) {
        m_sheet.texts.push_back({x, y, std::move(text), align, isBold, isItalic});
    }

    /// The next cell of a row of the table.
    void cell(const TableColumn& column, double y, const std::string& text, bool isBold = false,
              bool isItalic = false) {
        write(column.align == SheetAlign::Right ? m_x + column.width : m_x, y, shortened(text, column.width),
              column.align, isBold, isItalic);
        m_x += column.width + kBetween;
        m_right = std::max(m_right, m_x - kBetween);
    }

    [[nodiscard]] bool isWhole() const { return m_document.zones.empty(); }

    void addTitle() {
        const std::string scale = m_drawing.copperTimes > 1.0
                                      ? formatted("copper scale x%g, else to scale", m_drawing.copperTimes)
                                      : "to scale";
        write(kMargin, kLine + 4, m_document.job.name + ": " + textOf(m_document.boardThickness) + ", " + scale,
              SheetAlign::Left, true);
    }

    void addHeadings() {
        const double y = kTop - 0.8 * kLine;
        m_x = kTableLeft;
        for (const TableColumn& column : {kName, kKind, kThickness}) {
            cell(column, y, column.heading, true);
        }
        for (const StackupColumn& column : m_drawing.columns) {
            cell(kCumulative, y, isWhole() ? kCumulative.heading : column.part.name, true);
            if (!isWhole()) {
                const double middle = kMargin + (column.left + column.right) / 2 * kBoardWidth;
                write(middle, y, shortened(column.part.name, (column.right - column.left) * kBoardWidth),
                      SheetAlign::Middle, true);
            }
        }
        for (const TableColumn& column : {kSource, kWeight, kConstant, kTangent, kMaterial}) {
            cell(column, y, column.heading, true);
        }
    }

    void addBands(std::size_t row) {
        const StackupBand& band = m_drawing.bands[row];
        const std::uint32_t colour = colourOf(kindOf(m_document.stackup.rows[row], m_document));
        for (const StackupColumn& column : m_drawing.columns) {
            if (column.part.has[row]) {
                m_sheet.rects.push_back({kMargin + column.left * kBoardWidth, kTop + band.top,
                                         (column.right - column.left) * kBoardWidth, band.bottom - band.top, colour,
                                         0x9a9a9a, 0.5});
            }
        }
        m_sheet.leaders.push_back(
            {kMargin + kBoardWidth, kTop + (band.top + band.bottom) / 2, kTableLeft - 4, kTop + band.label});
    }

    void addTableRow(std::size_t number) {
        const StackupRow& row = m_document.stackup.rows[number];
        const double y = kTop + m_drawing.bands[number].label + 4;
        const bool isAssumed = row.source == Source::Assumed;
        const std::optional<CopperWeight> weight = copperWeightOf(row);
        m_x = kTableLeft;
        cell(kName, y, row.name);
        cell(kKind, y, wordsOf(kindOf(row, m_document)));
        cell(kThickness, y, textOf(row.thickness), false, isAssumed);
        for (const StackupColumn& column : m_drawing.columns) {
            const std::optional<Nm>& sum = column.part.cumulative[number];
            cell(kCumulative, y, sum ? textOf(*sum) : column.part.has[number] ? "" : "–");
        }
        cell(kSource, y, wordOf(row.source), false, isAssumed);
        cell(kWeight, y, weight ? formatted("%.3g", weight->oz) : "", false,
             weight && weight->source == Source::Assumed);
        cell(kConstant, y, numberText(row.material.dielectricConstant));
        cell(kTangent, y, numberText(row.material.lossTangent));
        cell(kMaterial, y, row.material.name);
    }

    void addBore(std::size_t number) {
        const StackupBarrel& bore = m_drawing.bores[number];
        const double x = kMargin + bore.x * kBoardWidth;
        const double width = std::min(kBoreWidth, bore.breadth * kBoardWidth / 2);
        const bool isBackdrill = bore.span == HoleSpan::Backdrill;
        m_sheet.rects.push_back({x - width / 2, kTop + bore.top, width, bore.bottom - bore.top,
                                 isBackdrill ? 0xe8c9c9U : 0xffffffU, bore.isPlated ? 0xc8793aU : 0x888888U,
                                 bore.isPlated ? 3.0 : 1.0});
        write(x, kTop - 6, std::to_string(number + 1), SheetAlign::Middle);
    }

    void addBelow() {
        double y = kTop + m_drawing.height + kLine * 1.5;
        const auto line = [&](const std::string& text, bool isBold = false) {
            write(kMargin, y, text, SheetAlign::Left, isBold);
            y += kLine;
        };
        for (const StackupColumn& column : m_drawing.columns) {
            line((isWhole() ? "" : "Zone " + column.part.name + ": ") + "copper to copper " +
                     textOf(column.part.copperToCopper) + ", overall " + textOf(column.part.overall),
                 true);
        }
        for (std::size_t i = 0; i < m_drawing.bores.size(); ++i) {
            line(std::to_string(i + 1) + "  " + boreText(m_document, m_drawing.bores[i], m_write));
        }
        for (const StackupFinding& finding : checkStackup(m_document, m_write)) {
            line(std::string(finding.severity == Severity::Warning ? "Warning: " : "Note: ") + finding.text);
        }
        m_sheet.height = y + kLine / 2;
    }

    const Document& m_document;
    const LengthWriter& m_write;
    StackupDrawing m_drawing;
    StackupSheet m_sheet;
    double m_x = 0.0;  ///< where the next cell begins
    double m_right = 0.0;
};

}  // namespace

StackupSheet stackupSheet(const Document& document, bool isExaggerated, const LengthWriter& write) {
    return SheetMaker(document, isExaggerated, write).make();
}

}  // namespace model
