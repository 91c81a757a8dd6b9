#include "ui/statistics/drill_model.h"

#include <QLocale>
#include <algorithm>

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[DrillModel::ColumnCount] = {
    {"Layer", "Drill or rout layer of the job"},
    {"Span", "Which copper the holes join or pass"},
    {"Kind", "What the holes are for"},
    {"Shape", "Round, slot (one stroke), path (a rout) or area"},
    {"Diameter", "As drilled; the width of a slot or path"},
    {"Finished", "What the plating leaves open; as drilled where there is none"},
    {"Tool", "Number in the job's tool list"},
    {"Holes", "How many there are"},
};

/// In the order of model::HoleKind.
constexpr const char* kKinds[] = {"Via", "Component", "Mounting", "Not plated"};

bool isNumber(int column) {
    return column >= DrillModel::Diameter;
}

/// None for no length.
QVariant inUnit(model::Nm length, LengthUnit unit) {
    return length > 0 ? QVariant(length / nmPer(unit)) : QVariant();
}

QVariant alignment(int column) {
    return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft)));
}

}  // namespace

void DrillModel::setDocument(std::shared_ptr<const model::Document> document) {
    beginResetModel();
    m_document = std::move(document);
    m_rows = m_document ? model::drillTable(*m_document) : std::vector<model::DrillRow>();
    endResetModel();
}

void DrillModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (!m_rows.empty()) {
        emit dataChanged(index(0, Diameter), index(rowCount() - 1, Finished));
    }
}

std::vector<model::ElementId> DrillModel::holesIn(const std::vector<int>& rows) const {
    std::vector<model::ElementId> holes;
    for (const int row : rows) {
        const std::vector<model::ElementId> ofRow = model::holesOf(*m_document, m_rows[static_cast<std::size_t>(row)]);
        holes.insert(holes.end(), ofRow.begin(), ofRow.end());
    }
    std::ranges::sort(holes);
    return holes;
}

QVariant DrillModel::value(const model::DrillRow& row, int column) const {
    switch (column) {
        case Diameter: return inUnit(row.diameter, m_unit);
        case Finished: return inUnit(row.open, m_unit);
        case Tool: return row.tool != nullptr ? QVariant(row.tool->number) : QVariant();
        case Holes: return row.count;
        default: return text(row, column);
    }
}

QString DrillModel::text(const model::DrillRow& row, int column) const {
    switch (column) {
        case Layer: return QString::fromStdString(m_document->layer(row.layer).name);
        case Span: return QString::fromLatin1(model::toString(row.span));
        case Kind: return QString::fromLatin1(kKinds[static_cast<std::size_t>(row.kind)]);
        case Shape: return QString::fromLatin1(row.shape);
        case Diameter: return row.diameter > 0 ? lengthText(row.diameter, m_unit) : QString();
        case Finished: return row.open > 0 ? lengthText(row.open, m_unit) : QString();
        case Tool: return row.tool != nullptr ? QString::number(row.tool->number) : QString();
        default: return QLocale().toString(row.count);
    }
}

QString DrillModel::spanTip(const model::DrillRow& row) const {
    const model::Layer& layer = m_document->layer(row.layer);
    if (!layer.spanTop.isValid() || !layer.spanBottom.isValid()) {
        return {};
    }
    return QStringLiteral("%1 to %2")
        .arg(QString::fromStdString(m_document->layer(layer.spanTop).name),
             QString::fromStdString(m_document->layer(layer.spanBottom).name));
}

int DrillModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int DrillModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant DrillModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const model::DrillRow& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole: return text(row, index.column());
        case Qt::EditRole: return value(row, index.column());
        case Qt::TextAlignmentRole: return alignment(index.column());
        case Qt::ToolTipRole: return index.column() == Span ? spanTip(row) : QVariant();
        default: return {};
    }
}

QVariant DrillModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kColumns[section].heading;
        case Qt::ToolTipRole: return kColumns[section].tip;
        case Qt::TextAlignmentRole: return alignment(section);
        default: return {};
    }
}

}  // namespace ui
