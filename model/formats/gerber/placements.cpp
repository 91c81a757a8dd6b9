#include "model/formats/gerber/placements.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/units.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

enum class Column : std::size_t { Refdes, Value, Package, X, Y, Rotation, Side, Count };
constexpr std::size_t kColumns = static_cast<std::size_t>(Column::Count);

struct ColumnName {
    std::string_view name;  ///< upper case, letters and digits only
    Column column;
};

/// As KiCad, Altium, Allegro, Eagle, PADS, EasyEDA, OrCAD, gEDA and DesignSpark write them; middles before pin 1 and
/// reference points.
constexpr std::array kNames = {
    ColumnName{"REF", Column::Refdes},
    ColumnName{"REFDES", Column::Refdes},
    ColumnName{"DESIGNATOR", Column::Refdes},
    ColumnName{"REFERENCE", Column::Refdes},
    ColumnName{"NAME", Column::Refdes},
    ColumnName{"PART", Column::Refdes},
    ColumnName{"COMPONENT", Column::Refdes},
    ColumnName{"VAL", Column::Value},
    ColumnName{"VALUE", Column::Value},
    ColumnName{"COMMENT", Column::Value},
    ColumnName{"PARTNUMBER", Column::Value},
    ColumnName{"PACKAGE", Column::Package},
    ColumnName{"FOOTPRINT", Column::Package},
    ColumnName{"PATTERN", Column::Package},
    ColumnName{"MIDX", Column::X},
    ColumnName{"CENTERX", Column::X},
    ColumnName{"CENTREX", Column::X},
    ColumnName{"POSX", Column::X},
    ColumnName{"XLOCATION", Column::X},
    ColumnName{"SYMX", Column::X},
    ColumnName{"LOCATIONX", Column::X},
    ColumnName{"X", Column::X},
    ColumnName{"MIDY", Column::Y},
    ColumnName{"CENTERY", Column::Y},
    ColumnName{"CENTREY", Column::Y},
    ColumnName{"POSY", Column::Y},
    ColumnName{"YLOCATION", Column::Y},
    ColumnName{"SYMY", Column::Y},
    ColumnName{"LOCATIONY", Column::Y},
    ColumnName{"Y", Column::Y},
    ColumnName{"ROT", Column::Rotation},
    ColumnName{"ROTATION", Column::Rotation},
    ColumnName{"ANGLE", Column::Rotation},
    ColumnName{"ORIENTATION", Column::Rotation},
    ColumnName{"SIDE", Column::Side},
    ColumnName{"LAYER", Column::Side},
    ColumnName{"TB", Column::Side},
    ColumnName{"MIRROR", Column::Side},
    ColumnName{"BOARDSIDE", Column::Side},
    ColumnName{"TOPBOTTOM", Column::Side},
};

struct Head {
    char separator = 0;
    std::array<std::optional<std::size_t>, kColumns> columns;
    std::size_t count = 0;  ///< of columns, those that are not read among them
    double nmPerUnit = base::kNmPerMm;
    bool hasUnit = false;
    bool isKicad = false;

    [[nodiscard]] bool isGood() const {
        return columns[0].has_value() && columns[static_cast<std::size_t>(Column::X)].has_value() &&
               columns[static_cast<std::size_t>(Column::Y)].has_value();
    }
};

std::vector<std::string> cells(std::string_view line, char separator) {
    std::vector<std::string> result;
    std::string cell;
    bool isQuoted = false;
    const auto end = [&] {
        if (separator != ' ' || !trimmed(cell).empty()) {
            result.emplace_back(trimmed(cell));
        }
        cell.clear();
    };
    for (const char c : line) {
        if (c == '"') {
            isQuoted = !isQuoted;
        } else if (!isQuoted && (c == separator || (separator == ' ' && c == '\t'))) {
            end();
        } else {
            cell += c;
        }
    }
    end();
    return result;
}

/// Names of columns that blanks separate: "Mid X" and "Centre Y" are one.
std::vector<std::string> joinedNames(std::vector<std::string> names) {
    constexpr std::array<std::string_view, 6> kFirst = {"MID", "CENTER", "CENTRE", "REF", "PAD", "POS"};
    std::vector<std::string> joined;
    for (std::string& name : names) {
        const bool isAxis = upperCase(name) == "X" || upperCase(name) == "Y";
        const bool isSecond = !joined.empty() && std::ranges::find(kFirst, upperCase(joined.back())) != kFirst.end();
        if (isAxis && isSecond) {
            joined.back() += " " + name;
        } else {
            joined.push_back(std::move(name));
        }
    }
    return joined;
}

std::string plainName(std::string_view cell) {
    std::string name;
    for (const char c : upperCase(cell.substr(0, cell.find('(')))) {
        if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) {
            name += c;
        }
    }
    for (const std::string_view unit : {"MM", "MIL", "INCH"}) {
        if (name.size() > unit.size() && name.ends_with(unit)) {
            name.resize(name.size() - unit.size());
        }
    }
    return name;
}

std::optional<double> unitIn(std::string_view text) {
    return holds(text, "mil")    ? std::optional(base::kNmPerMil)
           : holds(text, "thou") ? std::optional(base::kNmPerMil)
           : holds(text, "inch") ? std::optional(base::kNmPerInch)
           : holds(text, "mm")   ? std::optional(base::kNmPerMm)
                                 : std::nullopt;
}

static_assert(std::ranges::all_of(kNames, [](const ColumnName& column) {
    const bool hasX = column.name.find('X') != std::string_view::npos;
    const bool hasY = column.name.find('Y') != std::string_view::npos;
    return (column.column != Column::X || hasX) && (column.column != Column::Y || hasY);
}));

/// Every name of a column of locations has its letter in it: few lines of other files need a closer look.
bool mayBeHead(std::string_view line) {
    return line.find_first_of("xX") != std::string_view::npos && line.find_first_of("yY") != std::string_view::npos;
}

Head readHead(std::string_view line) {
    if (!mayBeHead(line)) {
        return {};
    }
    for (const char separator : {',', ';', '\t', '!', ' '}) {
        Head head;
        head.separator = separator;
        std::string_view rest = trimmed(line);
        rest.remove_prefix(rest.starts_with('#') ? 1 : 0);
        const std::vector<std::string> names =
            separator == ' ' ? joinedNames(cells(rest, separator)) : cells(rest, separator);
        head.count = names.size();
        std::array<std::size_t, kColumns> ranks;
        ranks.fill(kNames.size());
        std::optional<std::size_t> component;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto row = std::ranges::find(kNames, plainName(names[i]), &ColumnName::name);
            if (row == kNames.end()) {
                continue;
            }
            const auto column = static_cast<std::size_t>(row->column);
            const auto rank = static_cast<std::size_t>(row - kNames.begin());
            if (rank < ranks[column]) {
                ranks[column] = rank;
                head.columns[column] = i;
            }
            head.isKicad = head.isKicad || row->name == "POSX";  // nobody else calls it so
            if (row->name == "COMPONENT") {
                component = i;
            }
            if (row->column == Column::X && unitIn(names[i])) {
                head.nmPerUnit = *unitIn(names[i]);
                head.hasUnit = true;
            }
        }
        // DesignSpark calls the designator a name, and the kind of part a component.
        std::optional<std::size_t>& value = head.columns[static_cast<std::size_t>(Column::Value)];
        const bool isOfPart = component != head.columns[static_cast<std::size_t>(Column::Refdes)];
        value = value || !isOfPart ? value : component;
        if (head.isGood()) {
            return head;
        }
    }
    return {};
}

LayerSide sideOf(std::string_view cell) {
    const std::string word = upperCase(cell);
    const bool isTop = word.starts_with('T') || word.starts_with('F') || word == "NO" || word == "0" || word == "1";
    const bool isBottom = word.starts_with('B') || word == "YES" || word == "2" || word == "M";
    return isTop ? LayerSide::Top : isBottom ? LayerSide::Bottom : LayerSide::None;
}

/// "12.3mm", "484.25mil" or a number in the file's unit; in nm.
std::optional<double> lengthOf(std::string_view cell, double nmPerUnit) {
    constexpr double kFarthest = 1e13;  ///< whatever the unit, no place of a component
    std::string_view rest = cell;
    const std::optional<double> value = takeReal(rest);
    const double length = value.value_or(kFarthest) * unitIn(rest).value_or(nmPerUnit);
    return value && std::abs(length) < kFarthest ? std::optional(length) : std::nullopt;
}

/// A row whose cells blanks separate, with one for each column. Values and packages may have blanks themselves: then
/// there are more words, and the numbers tell how many of them are before the places. What is left over at the end
/// belongs to the last column.
std::vector<std::string> fittedRow(std::vector<std::string> row, const Head& head) {
    if (head.separator != ' ' || row.size() <= head.count) {
        return row;
    }
    const auto at = [&](Column column) { return head.columns[static_cast<std::size_t>(column)]; };
    const std::size_t x = *at(Column::X);
    const std::size_t y = *at(Column::Y);
    const std::size_t wide = std::min({at(Column::Value).value_or(x), at(Column::Package).value_or(x), x});
    std::size_t more = 0;
    const auto isNumber = [&](std::optional<std::size_t> column) {
        return !column || *column <= wide || lengthOf(row[*column + more], base::kNmPerMm).has_value();
    };
    const auto isSide = [&](std::optional<std::size_t> column) {
        return !column || *column <= wide || sideOf(row[*column + more]) != LayerSide::None;
    };
    const auto isPlace = [&] {
        return isNumber(x) && isNumber(y) && isNumber(at(Column::Rotation)) && isSide(at(Column::Side));
    };
    while (more < row.size() - head.count && !isPlace()) {
        ++more;
    }
    const auto join = [&](std::size_t first, std::size_t count) {
        const auto next = row.begin() + static_cast<std::ptrdiff_t>(first) + 1;
        const auto end = next + static_cast<std::ptrdiff_t>(count);
        std::for_each(next, end, [&](const std::string& word) { row[first] += " " + word; });
        row.erase(next, end);
    };
    if (wide < x && isPlace()) {
        join(wide, more);
    }
    if (row.size() > head.count) {
        join(head.count - 1, row.size() - head.count);
    }
    return row;
}

/// The unit that Allegro's placement file begins with ("UUNITS = MILS"); none in other files.
std::optional<double> unitOfAllegro(std::string_view line) {
    if (!line.starts_with("UUNITS")) {
        return std::nullopt;
    }
    return holds(line, "MILS")     ? std::optional(base::kNmPerMil)
           : holds(line, "INCH")   ? std::optional(base::kNmPerInch)
           : holds(line, "MILLIM") ? std::optional(base::kNmPerMm)
           : holds(line, "CENTIM") ? std::optional(10.0 * base::kNmPerMm)
           : holds(line, "MICRON") ? std::optional(base::kNmPerMm / 1000.0)
                                   : std::nullopt;
}

/// What gEDA writes below the names of the columns: "# X,Y in mils.  rotation in degrees." None of other lines.
std::optional<double> unitOfGeda(std::string_view line) {
    struct Unit {
        std::string_view name;
        double nm;
    };
    constexpr std::array kUnits = {Unit{"mils", base::kNmPerMil},        Unit{"mil", base::kNmPerMil},
                                   Unit{"dmil", base::kNmPerMil / 10.0}, Unit{"cmil", base::kNmPerMil / 100.0},
                                   Unit{"in", base::kNmPerInch},         Unit{"inches", base::kNmPerInch},
                                   Unit{"mm", base::kNmPerMm},           Unit{"cm", base::kNmPerMm * 10.0},
                                   Unit{"um", base::kNmPerMm / 1'000.0}};
    constexpr std::string_view kBefore = "# X,Y in ";
    const std::string_view rest = line.starts_with(kBefore) ? line.substr(kBefore.size()) : std::string_view();
    const auto found = std::ranges::find(kUnits, rest.substr(0, rest.find_first_of(". ")), &Unit::name);
    return found == kUnits.end() ? std::nullopt : std::optional(found->nm);
}

/// What lists without names begin their rows with: designator, place, rotation. None of other rows.
std::optional<PlacedPart> beginningOf(const std::vector<std::string>& row, double nmPerUnit) {
    if (row.size() < 4) {
        return std::nullopt;
    }
    const std::optional<double> x = lengthOf(row[1], nmPerUnit);
    const std::optional<double> y = lengthOf(row[2], nmPerUnit);
    std::string_view rotation = row[3];
    const std::optional<double> degrees = takeReal(rotation);
    if (!x || !y || !degrees) {
        return std::nullopt;
    }
    PlacedPart part;
    part.refdes = row[0];
    part.position = {*x, *y};
    part.rotationDeg = *degrees;
    return part;
}

/// "R22  3190.0  3675.0  270  m 0402": designator, place, rotation, m if it is on the bottom, package.
std::optional<PlacedPart> partOfAllegro(std::string_view line, double nmPerUnit) {
    const std::vector<std::string> row = cells(line, ' ');
    std::optional<PlacedPart> part = beginningOf(row, nmPerUnit);
    if (part) {
        const bool isOnBottom = row.size() > 4 && row[4] == "m";
        const std::size_t package = isOnBottom ? 5 : 4;
        part->package = package < row.size() ? row[package] : std::string();
        part->side = isOnBottom ? LayerSide::Bottom : LayerSide::Top;
    }
    return part;
}

/// A list without a line with names: a component a row, as `partOf` reads it.
template <class PartOf>
void takeRows(Lines& lines, PartOf partOf, std::string_view path, PlacementFile& file, Diagnostics& diagnostics) {
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        std::optional<PlacedPart> part = partOf(line);
        if (part) {
            part->line = lines.number();
            file.parts.push_back(std::move(*part));
        } else if (!line.empty()) {
            diagnostics.report(Severity::Warning, path, lines.number(),
                               "a row that places no component; it was left out");
        }
    }
}

PlacementFile placementsOfAllegro(Lines& lines, double nmPerUnit, std::string_view path, Diagnostics& diagnostics) {
    PlacementFile file;
    takeRows(
        lines, [&](std::string_view line) { return partOfAllegro(line, nmPerUnit); }, path, file, diagnostics);
    return file;
}

/// Of Eagle's lists of parts to mount, which have no line with names: the side is the ending of the file.
LayerSide sideOfMounts(std::string_view path) {
    const std::string ending = upperCase(path.substr(path.rfind('.') + 1));
    return ending == "MNT" ? LayerSide::Top : ending == "MNB" ? LayerSide::Bottom : LayerSide::None;
}

/// "C1 22.99 -1.65 270 100nF 0402": designator, place, rotation, value, package.
std::optional<PlacedPart> partOfMounts(std::string_view line, LayerSide side) {
    const std::vector<std::string> row = cells(line, ' ');
    const bool isWhole = row.size() > 3 && parseReal(row[3]);  // nothing behind the rotation
    std::optional<PlacedPart> part = isWhole ? beginningOf(row, base::kNmPerMm) : std::nullopt;
    if (part) {
        part->value = row.size() > 5 ? row[4] : std::string();
        part->package = row.size() > 4 ? row.back() : std::string();
        part->side = side;
    }
    return part;
}

PlacementFile placementsOfMounts(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    PlacementFile file;
    file.saysUnit = false;
    const LayerSide side = sideOfMounts(path);
    Lines lines(text);
    takeRows(
        lines, [side](std::string_view line) { return partOfMounts(line, side); }, path, file, diagnostics);
    return file;
}

/// A table with a row of names: what comes before them, and a component a row.
class TableOfPlaces {
public:
    TableOfPlaces(std::string_view path, Diagnostics& diagnostics) : m_path(path), m_diagnostics(diagnostics) {}

    void take(std::string_view line, std::uint32_t number) {
        const bool isRule = line.find_first_not_of("-=") == std::string_view::npos;  // below the names, or empty
        if (!m_head.isGood()) {
            takeHead(line);
        } else if (const std::optional<double> ofGeda = unitOfGeda(line); ofGeda && !m_head.hasUnit) {
            m_head.nmPerUnit = *ofGeda;
            m_head.hasUnit = true;
        } else if (!isRule && line.front() != '#') {
            takeRow(line, number);
        }
    }
    [[nodiscard]] PlacementFile finish() { return std::move(m_file); }

private:
    void takeHead(std::string_view line) {
        m_head = readHead(line);
        if (!m_unit && (holds(line, "unit") || line.starts_with('#'))) {
            m_unit = unitIn(line);
        }
        if (m_head.isGood() && !m_head.hasUnit && m_unit) {
            m_head.nmPerUnit = *m_unit;
        }
    }

    void takeRow(std::string_view line, std::uint32_t number) {
        const std::vector<std::string> row = fittedRow(cells(line, m_head.separator), m_head);
        const auto cell = [&](Column column) {
            const std::optional<std::size_t> at = m_head.columns[static_cast<std::size_t>(column)];
            return at && *at < row.size() ? std::string_view(row[*at]) : std::string_view();
        };
        const std::optional<double> x = lengthOf(cell(Column::X), m_head.nmPerUnit);
        const std::optional<double> y = lengthOf(cell(Column::Y), m_head.nmPerUnit);
        if (!x || !y || cell(Column::Refdes).empty()) {
            m_diagnostics.report(Severity::Warning, m_path, number, "a row that places no component; it was left out");
            return;
        }
        m_file.saysUnit = m_file.saysUnit && (m_head.hasUnit || m_unit || unitIn(cell(Column::X)));
        std::string_view rotation = cell(Column::Rotation);
        const double degrees = takeReal(rotation).value_or(0.0);
        const LayerSide side = sideOf(cell(Column::Side));
        m_file.parts.push_back({std::string(cell(Column::Refdes)),
                                std::string(cell(Column::Value)),
                                std::string(cell(Column::Package)),
                                {*x, *y},
                                m_head.isKicad ? fromFlipAlongX(degrees, side) : degrees,
                                side,
                                number});
    }

    std::string_view m_path;
    Diagnostics& m_diagnostics;
    Head m_head;
    std::optional<double> m_unit;  ///< nm, of what is said before the names
    PlacementFile m_file;
};

}  // namespace

bool looksLikeMounts(std::string_view head, std::string_view name) {
    Lines lines(head);
    return sideOfMounts(name) != LayerSide::None && lines.next() &&
           partOfMounts(trimmed(lines.line()), LayerSide::Top).has_value();
}

bool looksLikePlacements(std::string_view head) {
    if (unitOfAllegro(head.substr(0, head.find('\n')))) {
        return true;
    }
    Lines lines(head);
    for (int i = 0; i < 40 && lines.next(); ++i) {
        if (readHead(lines.line()).isGood()) {
            return true;
        }
    }
    return false;
}

PlacementFile parsePlacements(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    if (looksLikeMounts(text, path)) {
        return placementsOfMounts(text, path, diagnostics);
    }
    TableOfPlaces table(path, diagnostics);
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        const std::optional<double> ofAllegro = lines.number() == 1 ? unitOfAllegro(line) : std::nullopt;
        if (ofAllegro) {
            return placementsOfAllegro(lines, *ofAllegro, path, diagnostics);
        }
        table.take(line, lines.number());
    }
    return table.finish();
}

}  // namespace model::gerber
