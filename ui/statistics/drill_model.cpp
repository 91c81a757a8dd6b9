#include "ui/statistics/drill_model.h"

#include <algorithm>
#include <iterator>

namespace ui {

DrillModel::DrillModel(QObject* parent)
    : TableModel(
          {{tr("Layer"), tr("Drill or routing layer of the job")},
           {tr("Span"), tr("Which copper layers the holes join or pass")},
           {tr("Kind"), tr("What the holes are for")},
           {tr("Shape"), tr("Round hole, slot (one straight cut), routed path or area")},
           {tr("Diameter"), tr("As drilled; the width of a slot"), kNumber},
           {tr("Length"), tr("Of slots as drilled, over their ends; of areas the longer side"), kNumber},
           {tr("Finished"), tr("Finished size that the job's tool list states; empty where it states none"), kNumber},
           {tr("Inside"),
            tr("Inside of the plating, as 3D draws it; as drilled where there is none; in italics: assumed, as the "
               "job does not say how thick the plating is"),
            kNumber},
           {tr("Tool"), tr("Number in the job's tool list"), kNumber},
           {tr("Holes"), tr("How many there are"), kNumber}},
          parent) {}

void DrillModel::setDocument(std::shared_ptr<const model::Document> document) {
    beginResetModel();
    m_document = std::move(document);
    m_rows = m_document ? model::drillTableWithCopies(*m_document) : std::vector<model::DrillRow>();
    endResetModel();
}

std::vector<model::BoardElement> DrillModel::holesIn(const std::vector<int>& rows) const {
    std::vector<model::DrillRow> chosen;
    std::ranges::transform(rows, std::back_inserter(chosen),
                           [&](int row) { return m_rows[static_cast<std::size_t>(row)]; });
    return chosen.empty() ? std::vector<model::BoardElement>() : model::holesOf(*m_document, chosen);
}

Cell DrillModel::cell(int at, int column) const {
    const model::DrillRow& row = m_rows[static_cast<std::size_t>(at)];
    const QString kinds[] = {tr("Via"), tr("Component"), tr("Plated"), tr("NPTH")};  // in the order of HoleKind
    switch (column) {
        case Layer: return text(m_document->layer(row.layer).name);
        case Span: return {QString::fromLatin1(model::toString(row.span))};
        case Kind: return {kinds[static_cast<std::size_t>(row.kind)]};
        case Shape: return {row.shape == std::string_view("path") ? tr("routed path") : QString::fromLatin1(row.shape)};
        case Diameter: return row.diameter > 0 ? length(row.diameter) : Cell{};
        case Length: return row.length > 0 ? length(row.length) : Cell{};
        case Finished:
            return row.tool != nullptr && row.tool->finishedSize > 0 ? length(row.tool->finishedSize) : Cell{};
        case Inside: return row.open > 0 ? inside(row) : Cell{};
        case Tool:
            return row.tool == nullptr      ? Cell{}
                   : row.otherTools.empty() ? Cell{row.tool->number}
                                            : Cell{QString::fromStdString(model::toolsText(row)), {}, row.tool->number};
        default: return count(row.count);
    }
}

/// Slanted where it is assumed, as in the stackup.
Cell DrillModel::inside(const model::DrillRow& row) const {
    Cell cell = length(row.open);
    if (row.isOpenAssumed) {
        QFont slanted;
        slanted.setItalic(true);
        cell.font = slanted;
        cell.tip = tr("Assumed: no tool of the job says how thick the plating is");
    }
    return cell;
}

QString DrillModel::tip(int row, int column) const {
    const model::Layer& layer = m_document->layer(m_rows[static_cast<std::size_t>(row)].layer);
    if (column != Span || !layer.spanTop.isValid() || !layer.spanBottom.isValid()) {
        return {};
    }
    return tr("%1 to %2")
        .arg(QString::fromStdString(m_document->layer(layer.spanTop).name),
             QString::fromStdString(m_document->layer(layer.spanBottom).name));
}

}  // namespace ui
