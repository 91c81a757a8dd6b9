#include "ui/statistics/statistics_model.h"

#include <numeric>

namespace ui {

StatisticsModel::StatisticsModel(QObject* parent)
    : TableModel({{tr("Layer"), tr("Layer of the job")},
                  {tr("Line"), tr("Single straight tracks and oval pads"), kNumber},
                  {tr("Arc"), tr("Single tracks along a circular arc"), kNumber},
                  {tr("Circle"), tr("Round pads, vias and holes"), kNumber},
                  {tr("Trail"), tr("Track chains: tracks of one width joined end to end"), kNumber},
                  {tr("Area"), tr("Surfaces and pads of any other shape"), kNumber},
                  {tr("Elements"), tr("All elements of the layer"), kNumber},
                  {tr("Features"), tr("Feature records in the job's file; several may make one track chain"), kNumber},
                  {tr("Copper"), tr("Area of what is drawn on copper layers; overlaps count twice"), kNumber}},
                 parent) {}

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

double StatisticsModel::copper(int row) const {
    if (!isTotal(row)) {
        const std::size_t layer = m_layers[static_cast<std::size_t>(row)].row();
        return layer < m_copperNm2.size() ? m_copperNm2[layer] : 0.0;
    }
    return std::accumulate(m_copperNm2.begin(), m_copperNm2.end(), 0.0);
}

qulonglong StatisticsModel::number(int row, int column) const {
    if (isTotal(row)) {
        qulonglong sum = 0;
        for (int other = 0; other < row; ++other) {
            sum += number(other, column);
        }
        return sum;
    }
    const model::Layer& layer = m_document->layer(m_layers[static_cast<std::size_t>(row)]);
    switch (column) {
        case Elements:
            return std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), qulonglong{0});
        case Features: return layer.featureCount;
        default: return layer.countsWithCopies[static_cast<std::size_t>(column - Line)];
    }
}

Cell StatisticsModel::plainCell(int row, int column) const {
    switch (column) {
        case Layer:
            return isTotal(row) ? Cell{tr("All layers")}
                                : text(m_document->layer(m_layers[static_cast<std::size_t>(row)]).name);
        case Copper: return copper(row) > 0.0 ? area(copper(row)) : Cell{};
        default: return count(number(row, column));
    }
}

Cell StatisticsModel::cell(int row, int column) const {
    Cell cell = plainCell(row, column);
    cell.font = isTotal(row) ? QVariant(boldFont()) : QVariant();
    return cell;
}

}  // namespace ui
