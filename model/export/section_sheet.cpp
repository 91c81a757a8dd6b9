#include "model/export/section_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/export/stackup_drawing.h"
#include "model/text/formatting.h"

namespace model {

namespace {

// Millimetres of paper.
constexpr double kMargin = 8;
constexpr double kLine = 4.5;
constexpr double kWidest = 250;      ///< of the cut, where the scale is ours to choose
constexpr double kBoardHeight = 50;  ///< about, of the board in the cut; more where its stackup has many rows
constexpr double kTop = kMargin + 4 * kLine;
constexpr double kLabels = 80;
constexpr double kLeast = 0.05;  ///< of a foil: none vanishes
constexpr double kLetter = 1.8;  ///< of a letter, about

/// The next smaller of 1, 2, 5, 10, 20, …
double roundNumber(double value) {
    const double ten = std::pow(10.0, std::floor(std::log10(value)));
    return value >= 5 * ten ? 5 * ten : value >= 2 * ten ? 2 * ten : ten;
}

class SheetMaker {
public:
    SheetMaker(const Document& board, const Section& section, const SectionPicture& how)
        : m_board(board), m_section(section), m_how(how) {
        chooseScale();
    }

    SectionSheet make() {
        addTitle();
        addPieces();
        addRuns();
        addBends();
        addStackup();
        addDimensions();
        const double below = kTop + std::max(cutHeight(), kLine * static_cast<double>(m_board.stackup.rows.size()));
        addBar(below + kLine);
        double y = addLegend(below + 2.5 * kLine);
        for (const std::string& note : m_section.notes) {
            y = addNote(note, y);
        }
        m_sheet.width = 2 * kMargin + cutWidth() + kLabels;
        m_sheet.height = y + kMargin;
        return std::move(m_sheet);
    }

private:
    void chooseScale() {
        const double length = base::toMm(m_section.stations.back());
        m_sheet.scale = m_how.scale > 0.0 ? m_how.scale : roundNumber(kWidest / length);
        m_top = m_board.boardThickness;
        double tallest = m_top;
        double deepest = 0.0;
        for (const SectionPiece& piece : m_section.pieces) {
            const bool isPart = drawOrderOf(piece.material) == 1 || drawOrderOf(piece.material) == 2;
            (isPart ? tallest : m_top) = std::max<double>(isPart ? tallest : m_top, piece.top);
            (isPart ? deepest : m_bottom) = std::min<double>(isPart ? deepest : m_bottom, piece.bottom);
        }
        const double thickness = std::max(m_top - m_bottom, 1.0);
        m_top = std::clamp(tallest, m_top, m_top + thickness);
        m_bottom = std::clamp(deepest, m_bottom - thickness, m_bottom);
        const double wanted = std::max(kBoardHeight, kLine * static_cast<double>(m_board.stackup.rows.size()));
        const double times = 1.4 * wanted / base::toMm(thickness) / m_sheet.scale;
        m_sheet.heightTimes = m_how.heightTimes > 0.0 ? m_how.heightTimes : std::max(1.0, roundNumber(times));
    }

    [[nodiscard]] double x(double along) const { return kMargin + base::toMm(along) * m_sheet.scale; }
    [[nodiscard]] double y(double z) const {
        return kTop + base::toMm(m_top - std::clamp(z, m_bottom, m_top)) * m_sheet.scale * m_sheet.heightTimes;
    }
    [[nodiscard]] double cutWidth() const { return x(m_section.stations.back()) - kMargin; }
    [[nodiscard]] double cutHeight() const { return y(m_bottom) - kTop; }

    void addText(double x, double y, std::string text, SheetAlign align = SheetAlign::Left, bool isBold = false,
                 bool isItalic = false) {
        m_sheet.texts.push_back({x, y, std::move(text), align, isBold, isItalic});
    }

    static std::string positionText(PointD p) { return formatted("(%.7g, %.7g)", base::toMm(p.x), base::toMm(p.y)); }

    void addTitle() {
        addText(kMargin, kMargin + kLine,
                m_board.job.name + ": section from " + positionText(m_section.line.front()) + " to " +
                    positionText(m_section.line.back()) +
                    formatted(" mm, %.7g mm long", base::toMm(m_section.stations.back())),
                SheetAlign::Left, true);
        const double times = m_sheet.scale;
        addText(kMargin, kMargin + 2 * kLine,
                (times >= 1.0 ? formatted("Scale %g : 1", times) : formatted("Scale 1 : %g", 1.0 / times)) +
                    (m_sheet.heightTimes == 1.0 ? ", heights too"
                                                : formatted(", heights %g times larger", m_sheet.heightTimes)));
    }

    [[nodiscard]] std::uint32_t fillOf(const SectionPiece& piece) const {
        return colourOf(piece.material).value_or(m_how.colours[piece.layer.row()]);
    }

    void addPieces() {
        std::vector<SectionPiece> pieces = merged(m_section.pieces);
        std::ranges::stable_sort(pieces, {}, [](const SectionPiece& piece) { return drawOrderOf(piece.material); });
        for (const SectionPiece& piece : pieces) {
            const double top = y(piece.top);
            const double bottom = std::max(y(piece.bottom), top + kLeast);
            m_sheet.polygons.push_back({{{x(piece.from), bottom},
                                         {x(piece.to), bottom},
                                         {x(piece.upperTo()), top},
                                         {x(piece.upperFrom()), top}},
                                        fillOf(piece)});
            m_shown[static_cast<std::size_t>(piece.material)] = piece;
        }
    }

    /// On which layer an unrolled net runs.
    void addRuns() {
        for (const LayerRun& run : m_how.runs) {
            const double left = x(run.from);
            const double right = x(run.to);
            const double top = kTop - 1.4 * kLine;
            m_sheet.polygons.push_back({{{left, top}, {right, top}, {right, top + kLine}, {left, top + kLine}},
                                        m_how.colours[run.layer.row()]});
            m_sheet.lines.push_back({left, top, left, top + kLine});
            const std::string& name = m_board.layer(run.layer).name;
            if (kLetter * static_cast<double>(name.size()) < right - left) {
                addText((left + right) / 2, top + 0.75 * kLine, name, SheetAlign::Middle);
            }
        }
    }

    void addBends() {
        for (const double bend : bendsOf(m_section)) {
            m_sheet.lines.push_back({x(bend), kTop - 0.3 * kLine, x(bend), kTop + cutHeight() + 0.3 * kLine, true});
        }
    }

    /// Names, thicknesses and heights of the stackup's rows.
    void addStackup() {
        StackupDrawing labels;
        for (const StackupRow& row : m_board.stackup.rows) {
            const double top = y(double{1} * row.z + row.thickness) - kTop;
            const double bottom = y(row.z) - kTop;
            labels.bands.push_back({top, bottom, (top + bottom) / 2});
        }
        labels.height = std::max(cutHeight(), kLine * static_cast<double>(labels.bands.size()));
        spreadLabels(kLine, labels);
        const double right = kMargin + cutWidth();
        for (std::size_t i = 0; i < labels.bands.size(); ++i) {
            const StackupBand& band = labels.bands[i];
            const StackupRow& row = m_board.stackup.rows[i];
            const double middle = kTop + (band.top + band.bottom) / 2;
            const double label = kTop + band.label;
            m_sheet.lines.push_back({right + 1, kTop + band.top, right + 1, kTop + band.bottom});
            m_sheet.lines.push_back({right + 1, middle, right + 3, middle});
            m_sheet.lines.push_back({right + 3, middle, right + 9, label});
            m_sheet.lines.push_back({right + 9, label, right + 10, label});
            const bool isAssumed = row.source == Source::Assumed;
            addText(right + 11, label + 1, row.name, SheetAlign::Left, false, isAssumed);
            addText(right + kLabels, label + 1, lengthText(row.thickness), SheetAlign::Right, false, isAssumed);
        }
    }

    void addDimensions() {
        for (const auto& [dimension, text] : m_how.dimensions) {
            const auto [from, to] = dimension.ends();
            m_sheet.lines.push_back({x(from.along), y(from.z), x(to.along), y(to.z), false, true});
            const double aside = dimension.isUpright() ? 2.0 : 0.0;
            addText((x(from.along) + x(to.along)) / 2 + aside, (y(from.z) + y(to.z)) / 2 + (aside > 0.0 ? 1.0 : kLine),
                    text, aside > 0.0 ? SheetAlign::Left : SheetAlign::Middle, true);
        }
    }

    void addBar(double y) {
        const double length = roundNumber(base::toMm(m_section.stations.back()) / 4);
        const double right = kMargin + length * m_sheet.scale;
        m_sheet.lines.push_back({kMargin, y, right, y});
        m_sheet.lines.push_back({kMargin, y - 1.5, kMargin, y});
        m_sheet.lines.push_back({right, y - 1.5, right, y});
        addText(right + 2, y, lengthText(static_cast<Nm>(std::llround(length * base::kNmPerMm))));
    }

    /// In as many lines as it needs; the height of the last one.
    double addNote(const std::string& note, double y) {
        const auto room = static_cast<std::size_t>((cutWidth() + kLabels) / kLetter);
        for (std::size_t from = 0; from < note.size();) {
            std::size_t end = note.size();
            if (end - from > room) {
                const std::size_t blank = note.rfind(' ', from + room);
                end = blank == std::string::npos || blank <= from ? from + room : blank;
            }
            addText(kMargin, y += kLine, note.substr(from, end - from));
            from = end + (end < note.size() && note[end] == ' ' ? 1 : 0);
        }
        return y;
    }

    /// What was drawn of which material; the height of its last line.
    double addLegend(double y) {
        constexpr double kSwatch = 2.5;
        double left = kMargin;
        for (const std::optional<SectionPiece>& piece : m_shown) {
            if (!piece || piece->material == SectionMaterial::Other) {
                continue;
            }
            const std::string name = toString(piece->material);
            const double wide = kSwatch + 2.0 + kLetter * static_cast<double>(name.size()) + 3.0;
            if (left + wide > kMargin + cutWidth() + kLabels && left > kMargin) {
                left = kMargin;
                y += kLine;
            }
            const double top = y - kSwatch;
            m_sheet.polygons.push_back(
                {{{left, top}, {left + kSwatch, top}, {left + kSwatch, y}, {left, y}}, fillOf(*piece)});
            addText(left + kSwatch + 1.5, y, name);
            left += wide;
        }
        return y;
    }

    const Document& m_board;
    const Section& m_section;
    const SectionPicture& m_how;
    SectionSheet m_sheet;
    double m_top = 0.0;  ///< nm, of all that is drawn
    double m_bottom = 0.0;
    std::array<std::optional<SectionPiece>, kSectionMaterialCount> m_shown;  ///< one of each material
};

}  // namespace

SectionSheet sectionSheet(const Document& board, const Section& section, const SectionPicture& how) {
    return SheetMaker(board, section, how).make();
}

}  // namespace model
