#include "ui/models/statistics_model.h"

#include <QFont>
#include <QLocale>
#include <numeric>

namespace ui::models {

namespace {

constexpr const char* kHeadings[StatisticsModel::ColumnCount] = {"Layer", "Line", "Arc",      "Circle",
                                                                 "Trail", "Area", "Elements", "Features"};
constexpr const char* kTips[StatisticsModel::ColumnCount] = {
    "Layer of the job",
    "Single straight strokes and oval pads",
    "Single strokes along a circular arc",
    "Round pads, vias and holes",
    "Chains of strokes of one width joined end to end",
    "Surfaces and pads of any other shape",
    "All elements of the layer",
    "Feature records in the job's file; several strokes may make one trail",
};

/// Numbers to the right, under headings to the right.
QVariant alignment(int column) {
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignVCenter | (column == StatisticsModel::Layer ? Qt::AlignLeft : Qt::AlignRight)));
}

}  // namespace

void StatisticsModel::setDocument(std::shared_ptr<const model::Document> document) {
    beginResetModel();
    m_document = std::move(document);
    m_layers.clear();
    for (std::size_t row = 0; m_document && row < m_document->layers.size(); ++row) {
        if (!m_document->layers[row].isSynthetic) {
            m_layers.emplace_back(row);
        }
    }
    endResetModel();
}

qulonglong StatisticsModel::number(int row, int column) const {
    if (isTotal(row)) {
        return totalOf(column);
    }
    const model::Layer& layer = m_document->layer(m_layers[static_cast<std::size_t>(row)]);
    switch (column) {
        case Elements:
            return std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), qulonglong{0});
        case Features: return layer.featureCount;
        default: return layer.countsWithCopies[static_cast<std::size_t>(column - Line)];
    }
}

qulonglong StatisticsModel::totalOf(int column) const {
    qulonglong sum = 0;
    for (int row = 0; row < static_cast<int>(m_layers.size()); ++row) {
        sum += number(row, column);
    }
    return sum;
}

QVariant StatisticsModel::value(int row, int column) const {
    if (column != Layer) {
        return number(row, column);
    }
    return isTotal(row) ? QStringLiteral("All layers")
                        : QString::fromStdString(m_document->layer(m_layers[static_cast<std::size_t>(row)]).name);
}

int StatisticsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_document ? 0 : static_cast<int>(m_layers.size()) + 1;
}

int StatisticsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant StatisticsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const int column = index.column();
    switch (role) {
        case Qt::EditRole: return value(index.row(), column);
        case Qt::DisplayRole:
            return column == Layer ? value(index.row(), column) : QLocale().toString(number(index.row(), column));
        case Qt::TextAlignmentRole: return alignment(index.column());
        case Qt::FontRole: {
            QFont bold;
            bold.setBold(true);
            return isTotal(index.row()) ? QVariant(bold) : QVariant();
        }
        default: return {};
    }
}

QVariant StatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kHeadings[section];
        case Qt::ToolTipRole: return kTips[section];
        case Qt::TextAlignmentRole: return alignment(section);
        default: return {};
    }
}

}  // namespace ui::models
