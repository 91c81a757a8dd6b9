#include "ui/statistics/statistics_model.h"

#include <QFont>
#include <QLocale>
#include <numeric>

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[StatisticsModel::ColumnCount] = {
    {"Layer", "Layer of the job"},
    {"Line", "Single straight strokes and oval pads"},
    {"Arc", "Single strokes along a circular arc"},
    {"Circle", "Round pads, vias and holes"},
    {"Trail", "Chains of strokes of one width joined end to end"},
    {"Area", "Surfaces and pads of any other shape"},
    {"Elements", "All elements of the layer"},
    {"Features", "Feature records in the job's file; several strokes may make one trail"},
    {"Copper", "Area of what is drawn on copper layers; where elements overlap it counts twice"},
};

/// None for no area.
QVariant squareMm(double squareNm) {
    return squareNm > 0.0 ? QVariant(squareNm / (base::kNmPerMm * base::kNmPerMm)) : QVariant();
}

/// Numbers to the right, under headings to the right.
QVariant alignment(int column) {
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignVCenter | (column == StatisticsModel::Layer ? Qt::AlignLeft : Qt::AlignRight)));
}

}  // namespace

void StatisticsModel::setDocument(std::shared_ptr<const model::Document> document, std::vector<double> copperNm2) {
    beginResetModel();
    m_document = std::move(document);
    m_copperNm2 = std::move(copperNm2);
    m_layers.clear();
    for (std::size_t row = 0; m_document && row < m_document->layers.size(); ++row) {
        if (!m_document->layers[row].isSynthetic) {
            m_layers.emplace_back(row);
        }
    }
    endResetModel();
}

void StatisticsModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (m_document) {
        emit dataChanged(index(0, Copper), index(rowCount() - 1, Copper));
    }
}

double StatisticsModel::copper(int row) const {
    if (!isTotal(row)) {
        const std::size_t layer = m_layers[static_cast<std::size_t>(row)].row();
        return layer < m_copperNm2.size() ? m_copperNm2[layer] : 0.0;
    }
    return std::accumulate(m_copperNm2.begin(), m_copperNm2.end(), 0.0);
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
        return column == Copper ? squareMm(copper(row)) : number(row, column);
    }
    return isTotal(row) ? QStringLiteral("All layers")
                        : QString::fromStdString(m_document->layer(m_layers[static_cast<std::size_t>(row)]).name);
}

QString StatisticsModel::text(int row, int column) const {
    switch (column) {
        case Layer: return value(row, column).toString();
        case Copper: return copper(row) > 0.0 ? areaText(copper(row), m_unit) : QString();
        default: return QLocale().toString(number(row, column));
    }
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
        case Qt::DisplayRole: return text(index.row(), column);
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
        case Qt::DisplayRole: return kColumns[section].heading;
        case Qt::ToolTipRole: return kColumns[section].tip;
        case Qt::TextAlignmentRole: return alignment(section);
        default: return {};
    }
}

}  // namespace ui
