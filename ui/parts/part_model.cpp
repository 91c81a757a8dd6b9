#include "ui/parts/part_model.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "model/board/layers.h"
#include "model/index/attributes.h"
#include "model/index/pin_names.h"
#include "model/nets/net_statistics.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

constexpr std::string_view kHeight = ".comp_height";  // has a column of its own
const QLatin1String kValue("value");

QString sideText(model::LayerSide side) {
    return side == model::LayerSide::Bottom ? PartModel::tr("Bottom") : PartModel::tr("Top");
}

/// Of an attribute of forEachAttribute.
QString valueText(const std::string& value) {
    return value.empty() ? PartModel::tr("yes") : QString::fromStdString(value);
}

QString shortened(const QStringList& names) {
    constexpr qsizetype kMost = 12;
    const QString text = names.mid(0, kMost).join(QStringLiteral(", "));
    return names.size() > kMost ? PartModel::tr("%1 and %L2 more").arg(text).arg(names.size() - kMost) : text;
}

/// In italics, as all that is assumed, where the job does not say where the component lies.
Cell inPlace(Cell cell, const model::Component& component) {
    if (!component.isPlaced) {
        QFont font;
        font.setItalic(true);
        cell.font = font;
    }
    return cell;
}

/// While an attribute is chosen its column is called as it is.
std::vector<Column> columnsFor(const QString& attribute) {
    return {
        {PartModel::tr("Designator"), PartModel::tr("Reference designator")},
        {PartModel::tr("Part"), PartModel::tr("Part name or number in the job")},
        {attribute.isEmpty() ? PartModel::tr("Attributes") : attribute,
         PartModel::tr("The attribute chosen above the table, or all of them; a filter looks through all either way")},
        {PartModel::tr("Package"), PartModel::tr("Name of the package")},
        {PartModel::tr("Side"),
         PartModel::tr(
             "Side of the board it is mounted on; within a rigid-flex board the inner layer that it stands on")},
        {PartModel::tr("X"),
         PartModel::tr("Position of its origin, in the coordinates of the step; in italics: not in the job, the middle "
                       "of its pins"),
         kNumber | kLength},
        {PartModel::tr("Y"),
         PartModel::tr("Position of its origin, in the coordinates of the step; in italics: not in the job, the middle "
                       "of its pins"),
         kNumber | kLength},
        {PartModel::tr("Rotation cw"), PartModel::tr("Clockwise, as the job states it; empty where it does not"),
         kNumber},
        {PartModel::tr("Height"),
         PartModel::tr("As the job states it; empty where it does not: bodies have an assumed height then, and "
                       "components that are bare copper or a hole have no body"),
         kNumber | kLength},
        {PartModel::tr("Pins"), PartModel::tr("Pins of the component"), kNumber},
        {PartModel::tr("Fitted"), PartModel::tr("Whether it is assembled: the job may say that it is not populated")},
        {PartModel::tr("Step"), PartModel::tr("The step it is on; seen in all its copies")}};
}

}  // namespace

PartModel::PartModel(QObject* parent) : TableModel(columnsFor({}), parent) {}

void PartModel::setBoard(std::shared_ptr<const model::Document> board) {
    beginResetModel();
    m_board = std::move(board);
    m_steps = m_board ? model::distinctSteps(*m_board) : std::vector<const model::Document*>();
    sortRows();
    findMounted();
    listAttributeNames();
    setColumns(columnsFor(attribute()));
    m_ranks = {};
    endResetModel();
    emit headerDataChanged(Qt::Horizontal, Attributes, Attributes);
}

void PartModel::sortRows() {
    m_rows.clear();
    std::vector<std::string> names;
    std::vector<BoardPart> parts;
    for (std::uint32_t step = 0; step < m_steps.size(); ++step) {
        for (std::size_t row = 0; row < m_steps[step]->components.size(); ++row) {
            parts.push_back({step, model::ComponentId{row}});
            names.push_back(m_steps[step]->components[row].refdes);
        }
    }
    const std::vector<std::uint32_t> places = model::ranksOf(names);
    m_rows.resize(parts.size());
    for (std::size_t at = 0; at < parts.size(); ++at) {
        m_rows[places[at]] = parts[at];
    }
}

void PartModel::findMounted() {
    m_mounted.clear();
    for (std::uint32_t step = 0; step < m_steps.size(); ++step) {
        for (const model::Body& body : m_steps[step]->bodies) {
            if (const model::LayerId layer = model::mountingLayerOf(*m_steps[step], body); layer.isValid()) {
                m_mounted.emplace(BoardPart{step, body.component}, layer);
            }
        }
    }
}

void PartModel::listAttributeNames() {
    std::set<std::string, decltype(&model::isNamedBefore)> names(&model::isNamedBefore);
    for (const model::Document* step : m_steps) {
        std::set<model::StringId> ids;
        for (const model::Component& component : step->components) {
            for (const model::Property& property : step->propertiesOf(component.properties)) {
                if (!step->text(property.value).empty()) {
                    ids.insert(property.name);
                }
            }
        }
        std::ranges::transform(ids, std::inserter(names, names.end()), [&](auto id) { return step->text(id); });
    }
    m_attributeNames.clear();
    for (const std::string& name : names) {
        m_attributeNames += QString::fromStdString(name);
    }
    m_attribute = names.contains(m_attribute) ? m_attribute : std::string();
}

QString PartModel::rankedText(int row, int column) const {
    if (column == Attributes) {
        return attributeTextsOf(row).join(QStringLiteral(" · "));
    }
    return QString::fromStdString(column == Part ? componentAt(row).part : packageOf(row));
}

const std::vector<std::uint32_t>& PartModel::ranks(int column) const {
    std::vector<std::uint32_t>& ranks = m_ranks[static_cast<std::size_t>(column)];
    if (ranks.size() != m_rows.size()) {
        std::vector<std::string> texts;
        for (int row = 0; row < rows(); ++row) {
            texts.push_back(rankedText(row, column).toStdString());
        }
        ranks = model::ranksOf(texts);
    }
    return ranks;
}

void PartModel::setAttribute(const QString& name) {
    const std::string chosen = m_attributeNames.contains(name) ? name.toStdString() : std::string();
    if (std::exchange(m_attribute, chosen) != chosen) {
        m_ranks[Attributes].clear();
        setColumns(columnsFor(attribute()));
        emit headerDataChanged(Qt::Horizontal, Attributes, Attributes);
        announceChange();
    }
}

std::optional<int> PartModel::rowOf(const BoardPart& part) const {
    const auto found = std::ranges::find(m_rows, part);
    return found == m_rows.end() ? std::nullopt : std::optional(static_cast<int>(found - m_rows.begin()));
}

bool PartModel::hasSeveralSteps() const {
    return std::ranges::any_of(m_rows, [&](const BoardPart& part) { return part.step != m_rows.front().step; });
}

QStringList PartModel::designators() const {
    QStringList names;
    for (int row = 0; row < rows(); ++row) {
        names += QString::fromStdString(componentAt(row).refdes);
    }
    return names;
}

QString PartModel::sideOf(int row) const {
    const auto mounted = m_mounted.find(partAt(row));
    return mounted != m_mounted.end() ? QString::fromStdString(stepOf(partAt(row)).layer(mounted->second).name)
                                      : sideText(componentAt(row).side);
}

const model::Component& PartModel::componentAt(int row) const {
    const BoardPart part = partAt(row);
    return stepOf(part).components[part.component.row()];
}

std::string PartModel::packageOf(int row) const {
    const model::PackageId package = componentAt(row).package;
    return package.isValid() ? stepOf(partAt(row)).packages[package.row()].name : std::string();
}

std::vector<std::pair<QString, QString>> PartModel::attributesOf(int row) const {
    std::vector<std::pair<QString, QString>> attributes;
    model::forEachAttribute(stepOf(partAt(row)), componentAt(row),
                            [&](const std::string& name, const std::string& value) {
                                attributes.emplace_back(QString::fromStdString(name), valueText(value));
                            });
    return attributes;
}

QString PartModel::valueOf(int row) const {
    for (const auto& [name, value] : attributesOf(row)) {
        if (name.compare(kValue, Qt::CaseInsensitive) == 0) {
            return value;
        }
    }
    return {};
}

QStringList PartModel::attributeTextsOf(int row) const {
    QStringList texts;
    model::forEachAttribute(
        stepOf(partAt(row)), componentAt(row), [&](const std::string& name, const std::string& value) {
            if (!isOneAttribute() && name != kHeight) {
                texts += QStringLiteral("%1: %2").arg(QString::fromStdString(name), valueText(value));
            } else if (isOneAttribute() && name == m_attribute) {
                texts += valueText(value);
            }
        });
    return texts;
}

QString PartModel::stepNameOf(int row) const {
    return QString::fromStdString(stepOf(partAt(row)).job.step);
}

Cell PartModel::cell(int row, int column) const {
    const model::Component& component = componentAt(row);
    switch (column) {
        case Designator: return {.text = QString::fromStdString(component.refdes), .order = row};
        case Part:
        case Attributes:
        case Package: return {rankedText(row, column)};
        case Side: return {sideOf(row)};
        case X: return inPlace(length(component.placement.origin.x), component);
        case Y: return inPlace(length(component.placement.origin.y), component);
        case Rotation:
            return component.isPlaced
                       ? Cell{angleText(component.placement.clockwiseDeg), component.placement.clockwiseDeg}
                       : Cell{.text = QString(), .order = -1.0};
        case Height: return component.height > 0 ? length(component.height) : Cell{.text = QString(), .order = 0.0};
        case Pins: return count(component.pinCount);
        case Fitted: return {component.isPopulated ? tr("yes") : tr("no")};
        default: return {stepNameOf(row)};
    }
}

QVariant PartModel::order(int row, int column) const {
    const bool isRanked = column == Part || column == Attributes || column == Package;
    return isRanked ? QVariant(ranks(column)[static_cast<std::size_t>(row)]) : QVariant();
}

QString PartModel::searchText(int row) const {
    const model::Component& component = componentAt(row);
    QStringList texts{QString::fromStdString(component.refdes), QString::fromStdString(component.part),
                      QString::fromStdString(packageOf(row)), sideOf(row)};
    for (const auto& [name, value] : attributesOf(row)) {
        texts << name << value;
    }
    return texts.join('\t');
}

QString PartModel::tip(int row, int column) const {
    const model::Component& component = componentAt(row);
    if (column == Pins) {
        return shortened(netNames(stepOf(partAt(row)), model::netsOf(stepOf(partAt(row)), component)));
    }
    QStringList lines{QString::fromStdString(component.refdes)};
    if (!component.isPlaced && (column == X || column == Y || column == Rotation)) {
        lines += tr("The job does not say where it lies: this is the middle of its pins");
    }
    if (column == Side && m_mounted.contains(partAt(row))) {
        lines += tr("Stands on the inner layer %1, facing the %2").arg(sideOf(row), sideText(component.side).toLower());
    }
    for (const auto& [name, value] : attributesOf(row)) {
        lines += QStringLiteral("%1: %2").arg(name, value);
    }
    return lines.join('\n');
}

bool PartModel::hasHeights() const {
    return std::ranges::any_of(
        m_rows, [&](const BoardPart& part) { return stepOf(part).components[part.component.row()].height > 0; });
}

QStringList PartModel::missing(const std::vector<int>& shown) const {
    if (m_rows.empty()) {
        return m_board ? QStringList{tr("The job has no components")} : QStringList();
    }
    int heights = 0;
    int outlines = 0;
    int places = 0;
    for (const int row : shown) {
        const model::Component& component = componentAt(row);
        const bool isDrawn =
            component.package.isValid() && stepOf(partAt(row)).packages[component.package.row()].body.isValid();
        heights += component.height > 0 ? 0 : 1;
        outlines += isDrawn ? 0 : 1;
        places += component.isPlaced ? 0 : 1;
    }
    QStringList texts;
    const auto add = [&](int count, const QString& all, const QString& some) {
        if (count > 0) {
            texts += count == static_cast<int>(shown.size()) ? all : some.arg(count);
        }
    };
    add(places, tr("no places"), tr("%L1 without a place"));
    add(heights, tr("no heights"), tr("%L1 without a height"));
    add(outlines, tr("no package outlines"), tr("%L1 without a package outline"));
    return texts;
}

}  // namespace ui
