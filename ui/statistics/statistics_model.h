#pragma once

#include <memory>

#include "model/board/document.h"
#include "ui/common/table_model.h"

namespace ui {

/// Elements by kind and what copper covers for every layer of the job, and for all of them in the last row. Layers that
/// Copperscope adds (board body, outline) are left out, so that the numbers add up to the job's own.
class StatisticsModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Layer, Line, Arc, Circle, Trail, Area, Elements, Features, Copper };

    explicit StatisticsModel(QObject* parent = nullptr);

    /// `copperNm2` as of model::copperAreas; empty: not known.
    void setDocument(std::shared_ptr<const model::Document> document, std::vector<double> copperNm2 = {});
    [[nodiscard]] bool isTotal(int row) const override { return row == static_cast<int>(m_layers.size()); }

private:
    [[nodiscard]] int rows() const override { return m_document ? static_cast<int>(m_layers.size()) + 1 : 0; }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] Cell plainCell(int row, int column) const;
    [[nodiscard]] qulonglong number(int row, int column) const;
    [[nodiscard]] double copper(int row) const;

    std::shared_ptr<const model::Document> m_document;
    std::vector<model::LayerId> m_layers;  ///< row to layer
    std::vector<double> m_copperNm2;       ///< by layer
};

}  // namespace ui
