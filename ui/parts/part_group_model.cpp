#include "ui/parts/part_group_model.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "model/index/attributes.h"
#include "model/nets/net_statistics.h"

namespace ui {

namespace {

const QLatin1String kBetween(", ");  // designators

/// Those of the PartModel; `leftOut`: what is not counted.
std::vector<Column> columnsFor(const QString& attribute, const QString& leftOut) {
    const QString quantity = PartGroupModel::tr("How many of them are on the board; of placed steps, on one copy");
    return {{PartGroupModel::tr("Quantity"),
             leftOut.isEmpty() ? quantity : PartGroupModel::tr("%1. Not listed: %2").arg(quantity, leftOut), kNumber},
            {PartGroupModel::tr("Part"), PartGroupModel::tr("Part name or number in the job")},
            {PartGroupModel::tr("Value"), PartGroupModel::tr("The attribute of that name")},
            {PartGroupModel::tr("Package"), PartGroupModel::tr("Name of the package")},
            {attribute.isEmpty() ? PartGroupModel::tr("Attributes") : attribute,
             PartGroupModel::tr("The attribute chosen above the table, or all that are the same in all of them; "
                                "a filter looks through all either way")},
            {PartGroupModel::tr("Fitted"),
             PartGroupModel::tr("Whether they are assembled: the job may say that they are not populated")},
            {PartGroupModel::tr("Step"), PartGroupModel::tr("The step they are on; seen in all its copies")},
            {PartGroupModel::tr("Designators"), PartGroupModel::tr("Reference designators")}};
}

}  // namespace

PartGroupModel::PartGroupModel(const PartModel& parts, QObject* parent)
    : TableModel(columnsFor(parts.attribute(), {}), parent), m_parts(parts) {
    connect(&parts, &QAbstractItemModel::modelReset, this, [this] {
        if (m_isOn) {
            group();
        }
    });
    connect(&parts, &QAbstractItemModel::headerDataChanged, this, [this] {
        setHeadings();
        emit headerDataChanged(Qt::Horizontal, Attributes, Attributes);
    });
    connect(&parts, &QAbstractItemModel::dataChanged, this, &PartGroupModel::announceChange);
}

void PartGroupModel::setOn(bool isOn) {
    m_isOn = isOn;
    group();
}

void PartGroupModel::group() {
    beginResetModel();
    m_groups.clear();
    m_groupOf.clear();
    std::map<std::tuple<std::uint32_t, bool, QString, QString, QString>, int> groups;
    for (int part = 0; m_isOn && part < m_parts.rowCount(); ++part) {
        if (isLeftOut(part)) {
            m_groupOf.emplace_back();
            continue;
        }
        const auto key = std::tuple(m_parts.partAt(part).step, m_parts.componentAt(part).isPopulated,
                                    textOf(part, Part), textOf(part, Value), textOf(part, Package));
        const auto [found, isNew] = groups.try_emplace(key, static_cast<int>(m_groups.size()));
        if (isNew) {
            m_groups.emplace_back();
        }
        m_groups[static_cast<std::size_t>(found->second)].push_back(part);
        m_groupOf.emplace_back(found->second);
    }
    for (const Column column : {Part, Value, Package}) {
        rank(column);
    }
    setHeadings();
    endResetModel();
}

void PartGroupModel::setHeadings() {
    setColumns(columnsFor(m_parts.attribute(), leftOutText()));
}

bool PartGroupModel::isLeftOut(int part) const {
    return std::ranges::any_of(m_parts.attributesOf(part), [](const auto& attribute) {
        return model::excludesFromBom(attribute.first.toStdString(), attribute.second.toStdString());
    });
}

QString PartGroupModel::leftOutText() const {
    const auto count = std::ranges::count(m_groupOf, std::optional<int>());
    return count == 0   ? QString()
           : count == 1 ? tr("1 component excluded from the bill of materials")
                        : tr("%L1 components excluded from the bill of materials").arg(count);
}

void PartGroupModel::rank(Column column) {
    std::vector<std::string> texts;
    for (const std::vector<int>& parts : m_groups) {
        texts.push_back(textOf(parts.front(), column).toStdString());
    }
    m_ranks[static_cast<std::size_t>(column)] = model::ranksOf(texts);
}

std::optional<int> PartGroupModel::groupOf(int part) const {
    const auto at = static_cast<std::size_t>(part);
    return at < m_groupOf.size() ? m_groupOf[at] : std::nullopt;
}

bool PartGroupModel::hasValues() const {
    return std::ranges::any_of(m_groups,
                               [&](const std::vector<int>& parts) { return !textOf(parts.front(), Value).isEmpty(); });
}

QString PartGroupModel::textOf(int part, int column) const {
    return column == Part    ? QString::fromStdString(m_parts.componentAt(part).part)
           : column == Value ? m_parts.valueOf(part)
                             : QString::fromStdString(m_parts.packageOf(part));
}

QStringList PartGroupModel::designators(int row) const {
    QStringList names;
    for (const int part : partsOf(row)) {
        names += QString::fromStdString(m_parts.componentAt(part).refdes);
    }
    return names;
}

/// Of one attribute all values that there are, else what all components have in common.
QString PartGroupModel::attributes(int row) const {
    QStringList texts = m_parts.attributeTextsOf(partsOf(row).front());
    for (const int part : partsOf(row)) {
        const QStringList others = m_parts.attributeTextsOf(part);
        if (m_parts.isOneAttribute()) {
            texts += others;
        } else {
            texts.removeIf([&](const QString& text) { return !others.contains(text); });
        }
    }
    texts.removeDuplicates();
    return texts.join(m_parts.isOneAttribute() ? QStringLiteral(", ") : QStringLiteral(" · "));
}

Cell PartGroupModel::cell(int row, int column) const {
    const int first = partsOf(row).front();
    switch (column) {
        case Quantity: return count(partsOf(row).size());
        case Part:
        case Value:
        case Package:
            return {.text = textOf(first, column),
                    .order = m_ranks[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)]};
        case Attributes: return {attributes(row)};
        case Fitted: return {m_parts.componentAt(first).isPopulated ? tr("yes") : tr("no")};
        case Step: return {m_parts.stepNameOf(first)};
        default: return {.text = designators(row).join(kBetween), .order = row};
    }
}

QString PartGroupModel::searchText(int row) const {
    QStringList texts{textOf(partsOf(row).front(), Part), textOf(partsOf(row).front(), Package)};
    texts += designators(row);
    for (const int part : partsOf(row)) {
        for (const auto& [name, value] : m_parts.attributesOf(part)) {
            texts << name << value;
        }
    }
    texts.removeDuplicates();
    return texts.join('\t');
}

QString PartGroupModel::tip(int row, int column) const {
    if (column != Designators) {
        return column == Quantity || column == Fitted ? QString() : cell(row, column).text.toString();
    }
    constexpr qsizetype kInLine = 12;
    const QStringList names = designators(row);
    QStringList lines;
    for (qsizetype first = 0; first < names.size(); first += kInLine) {
        lines += names.mid(first, kInLine).join(kBetween);
    }
    return lines.join(QStringLiteral(",\n"));
}

}  // namespace ui
