#include "model/export/section_sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "model/board/board_heights.h"
#include "model/export/stackup_drawing.h"
#include "model/section/section_labels.h"
#include "model/text/formatting.h"
#include "model/text/utf8.h"

namespace model {

namespace {

// Millimetres of paper.
constexpr double kMargin = 8;
constexpr double kLine = 4.5;
constexpr double kWidest = 250;      ///< of the cut, where the scale is ours to choose
constexpr double kBoardHeight = 50;  ///< about, of the board in the cut; more where its stackup has many rows
constexpr double kTop = kMargin + 4 * kLine;
constexpr double kLabels = 80;
constexpr double kLeast = 0.05;    ///< of a foil: none vanishes
constexpr double kLetter = 1.8;    ///< of a letter, about
constexpr double kBend = 1.6;      ///< width of the mark of a bend
constexpr double kRoomOfBend = 8;  ///< bends closer together have a mark and no line
constexpr double kDot = 0.3;       ///< radius, where a name points to

/// The next smaller of 1, 2, 5, 10, 20, …
double roundNumber(double value) {
    const double ten = std::pow(10.0, std::floor(std::log10(value)));
    return value >= 5 * ten ? 5 * ten : value >= 2 * ten ? 2 * ten : ten;
}

class SheetMaker {
public:
    SheetMaker(const Document& board, const Section& section, const SectionPicture& how)
        : m_board(board), m_section(section), m_how(how) {
        m_drawn = merged(m_section.pieces);
        std::ranges::stable_sort(m_drawn, {}, [](const SectionPiece& piece) { return drawOrderOf(piece.material); });
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
        const ZRange board = boardHeights(m_board);
        m_top = static_cast<double>(board.top);
        m_bottom = static_cast<double>(board.bottom);
        double tallest = m_top;
        double deepest = m_bottom;
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
                m_board.job.name +
                    (m_how.net.empty() ? ": section from " : ": section along net " + m_how.net + ", from ") +
                    positionText(m_section.line.front()) + " to " + positionText(m_section.line.back()) +
                    formatted(" mm, %.7g mm long", base::toMm(m_section.stations.back())),
                SheetAlign::Left, true);
        const double times = m_sheet.scale;
        addText(kMargin, kMargin + 2 * kLine,
                (times >= 1.0 ? formatted("Scale %g : 1", times) : formatted("Scale 1 : %g", 1.0 / times)) +
                    (m_sheet.heightTimes == 1.0 ? ", heights too"
                                                : formatted(", heights %g times larger", m_sheet.heightTimes)));
    }

    void addPolygon(std::vector<std::pair<double, double>> contour, std::uint32_t fill) {
        m_sheet.polygons.push_back({{std::move(contour)}, fill});
    }

    [[nodiscard]] std::vector<std::pair<double, double>> contourOf(const SectionPiece& piece) const {
        const double top = y(piece.top);
        const double bottom = std::max(y(piece.bottom), top + kLeast);
        return {{x(piece.from), bottom}, {x(piece.to), bottom}, {x(piece.upperTo()), top}, {x(piece.upperFrom()), top}};
    }

    /// All that the board is made of; without contours if none of it is a dielectric.
    [[nodiscard]] SheetPolygon underBoard() const {
        SheetPolygon under;
        const auto first =
            std::ranges::find_if(m_drawn, [](const SectionPiece& piece) { return isDielectric(piece.material); });
        for (const SectionPiece& piece : first != m_drawn.end() ? m_drawn : std::vector<SectionPiece>{}) {
            if (isBoard(piece.material)) {
                under.contours.push_back(contourOf(piece));
                under.fill = colourOf(*first, m_how.colours);
            }
        }
        return under;
    }

    static bool isBoard(SectionMaterial material) {
        switch (material) {
            case SectionMaterial::Paste:
            case SectionMaterial::Silkscreen:
            case SectionMaterial::Part:
            case SectionMaterial::Terminal:
            case SectionMaterial::Other: return false;
            default: return true;
        }
    }

    /// What has one colour is filled at once. Under all that the board is made of lies the colour of its first
    /// dielectric, so that the paper does not shine through between neighbours.
    void addPieces() {
        std::vector<std::pair<int, SheetPolygon>> groups;
        for (const SectionPiece& piece : m_drawn) {
            const auto key = std::pair(drawOrderOf(piece.material), colourOf(piece, m_how.colours));
            auto group = std::ranges::find_if(
                groups, [&](const auto& own) { return std::pair(own.first, own.second.fill) == key; });
            if (group == groups.end()) {
                group = groups.insert(groups.end(), {key.first, {{}, key.second}});
            }
            group->second.contours.push_back(contourOf(piece));
        }
        std::ranges::stable_sort(groups, {}, [](const auto& group) { return group.first; });
        SheetPolygon under = underBoard();
        if (!under.contours.empty()) {
            m_sheet.polygons.push_back(std::move(under));
        }
        for (auto& [order, polygon] : groups) {
            m_sheet.polygons.push_back(std::move(polygon));
        }
        addBreaks();
    }

    /// A white zigzag through each part that is higher than the sheet shows.
    void addBreaks() {
        constexpr double kFromEnd = 2.0;
        for (const SectionPiece& piece : m_drawn) {
            const bool isPart = piece.material == SectionMaterial::Part || piece.material == SectionMaterial::Terminal;
            if (isPart && double(piece.top) > m_top) {
                addBreak(x(piece.from), x(piece.to), kTop + kFromEnd);
            }
            if (isPart && double(piece.bottom) < m_bottom) {
                addBreak(x(piece.from), x(piece.to), kTop + cutHeight() - kFromEnd);
            }
        }
    }

    void addBreak(double from, double to, double y) {
        constexpr double kTooth = 0.8;
        const double teeth = std::max(std::round((to - from) / kTooth), 1.0);
        std::vector<std::pair<double, double>> contour;
        for (double i = 0.0; i <= teeth; ++i) {
            contour.emplace_back(from + (to - from) * i / teeth, y + (std::fmod(i, 2.0) == 0.0 ? -kTooth : kTooth));
        }
        for (std::size_t i = contour.size(); i > 0; --i) {
            contour.emplace_back(contour[i - 1].first, contour[i - 1].second + kTooth);
        }
        addPolygon(std::move(contour), 0xffffff);
    }

    /// On which layer an unrolled net runs.
    void addRuns() {
        for (const LayerRun& run : m_how.runs) {
            const double left = x(run.from);
            const double right = x(run.to);
            const double top = kTop - 1.4 * kLine;
            addPolygon({{left, top}, {right, top}, {right, top + kLine}, {left, top + kLine}},
                       m_how.colours[run.layer.row()]);
            m_sheet.lines.push_back({left, top, left, top + kLine});
            const std::string& name = m_board.layer(run.layer).name;
            if (kLetter * static_cast<double>(name.size()) < right - left) {
                addText((left + right) / 2, top + 0.75 * kLine, name, SheetAlign::Middle);
            }
        }
    }

    /// A mark at the upper rim; where there is room a line down too, as in the window.
    void addBends() {
        const std::vector<double> bends = bendsOf(m_section);
        double last = -1e9;
        for (std::size_t i = 0; i < bends.size(); ++i) {
            const double at = x(bends[i]);
            const double next = i + 1 < bends.size() ? x(bends[i + 1]) : 1e9;
            const double top = kTop - 0.3 * kLine;
            if (at - last >= kRoomOfBend && next - at >= kRoomOfBend) {
                m_sheet.lines.push_back({at, top, at, kTop + cutHeight() + 0.3 * kLine, true});
            }
            addPolygon({{at, top + kBend}, {at - kBend / 2, top}, {at + kBend / 2, top}}, 0x000000);
            last = at;
        }
    }

    /// Names and thicknesses of the stackup's rows, in its order, each pointing to where the row ends.
    void addStackup() {
        struct Label {
            std::size_t row;
            std::optional<RowMark> mark;
            double height;  ///< of what is named, from the top of the cut
        };
        const SectionWindow window{0.0, m_section.stations.back(), m_bottom, m_top};
        std::vector<Label> rows;
        for (std::size_t i = 0; i < m_board.stackup.rows.size(); ++i) {
            const StackupRow& row = m_board.stackup.rows[i];
            const std::optional<RowMark> mark = markOf(m_board, m_drawn, i, window);
            rows.push_back({i, mark, y(mark ? mark->z : double{1} * row.z + row.thickness / 2.0) - kTop});
        }
        StackupDrawing labels;
        for (const Label& row : rows) {
            labels.bands.push_back({row.height, row.height, row.height});
        }
        labels.height = std::max(cutHeight(), kLine * static_cast<double>(labels.bands.size()));
        spreadLabels(kLine, labels);
        const double right = kMargin + cutWidth();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const StackupRow& row = m_board.stackup.rows[rows[i].row];
            const double label = kTop + labels.bands[i].label;
            if (rows[i].mark) {
                addLeader(x(rows[i].mark->along), kTop + rows[i].height, right, label);
            }
            const bool isAssumed = row.source == Source::Assumed;
            addText(right + 11, label + 1, row.name, SheetAlign::Left, false, isAssumed);
            addText(right + kLabels, label + 1, lengthText(row.thickness), SheetAlign::Right, false, isAssumed);
        }
    }

    void addLeader(double x, double y, double right, double label) {
        addPolygon({{x - kDot, y}, {x, y + kDot}, {x + kDot, y}, {x, y - kDot}}, 0x000000);
        m_sheet.lines.push_back({x, y, right + 3, y});
        m_sheet.lines.push_back({right + 3, y, right + 9, label});
        m_sheet.lines.push_back({right + 9, label, right + 10, label});
    }

    /// Below one another where they would overlap.
    void addDimensions() {
        struct Box {
            double left, right, y;
        };
        std::vector<Box> taken;
        for (const SheetDimension& own : m_how.dimensions) {
            const auto [from, to] = own.dimension.ends();
            m_sheet.lines.push_back({x(from.along), y(from.z), x(to.along), y(to.z), own.isStale, true});
            const bool isUpright = own.dimension.isUpright();
            const double left = (x(from.along) + x(to.along)) / 2 + (isUpright ? 2.0 : 0.0);
            const double half = kLetter * static_cast<double>(own.text.size()) / 2;
            Box box{isUpright ? left : left - half, isUpright ? left + 2 * half : left + half,
                    (y(from.z) + y(to.z)) / 2 + (isUpright ? 1.0 : kLine)};
            while (std::ranges::any_of(taken, [&](const Box& other) {
                return box.left < other.right && other.left < box.right && std::abs(box.y - other.y) < kLine;
            })) {
                box.y += kLine;
            }
            taken.push_back(box);
            addText(left, box.y, own.text, isUpright ? SheetAlign::Left : SheetAlign::Middle, true);
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
                const bool isLongWord = blank == std::string::npos || blank <= from;
                end = isLongWord ? from + cutWithin(std::string_view(note).substr(from), room) : blank;
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
        for (const SectionLegendRow& row : legendOf(m_drawn, m_how.colours)) {
            const std::string name = toString(row.material);
            const double part = std::max(kSwatch / static_cast<double>(row.colours.size()), 1.2);
            const double swatch = part * static_cast<double>(row.colours.size());
            const double wide = swatch + 2.0 + kLetter * static_cast<double>(name.size()) + 3.0;
            if (left + wide > kMargin + cutWidth() + kLabels && left > kMargin) {
                left = kMargin;
                y += kLine;
            }
            const double top = y - kSwatch;
            for (std::size_t i = 0; i < row.colours.size(); ++i) {
                const double from = left + part * static_cast<double>(i);
                addPolygon({{from, top}, {from + part, top}, {from + part, y}, {from, y}}, row.colours[i]);
            }
            addText(left + swatch + 1.5, y, name);
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
    std::vector<SectionPiece> m_drawn;  ///< what others lie in comes first
};

}  // namespace

SectionSheet sectionSheet(const Document& board, const Section& section, const SectionPicture& how) {
    return SheetMaker(board, section, how).make();
}

}  // namespace model
