#pragma once

#include <QAbstractProxyModel>
#include <array>
#include <vector>

#include "ui/layers/layer_model.h"

namespace ui {

/// The rows of the layers panel: the layers of a LayerModel under headings of their groups, which are folded where they
/// are empty or dull. A heading's check mark is that of all its layers, also of those that are folded away.
class GroupedLayers : public QAbstractProxyModel {
    Q_OBJECT

public:
    explicit GroupedLayers(LayerModel& layers, QObject* parent = nullptr);

    [[nodiscard]] bool isHeading(int row) const { return !m_rows[static_cast<std::size_t>(row)].layer.isValid(); }
    /// Of a heading or a layer.
    [[nodiscard]] model::LayerGroup groupAt(int row) const { return m_rows[static_cast<std::size_t>(row)].group; }
    /// The layer of a row, or all under a heading.
    [[nodiscard]] std::vector<model::LayerId> layersAt(int row) const;
    /// Unfolds its group; -1 if there is no such layer.
    int reveal(model::LayerId layer);
    void fold(model::LayerGroup group, bool isFolded);
    [[nodiscard]] bool isFolded(model::LayerGroup group) const { return m_isFolded[static_cast<std::size_t>(group)]; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] QModelIndex mapToSource(const QModelIndex& index) const override;
    /// Invalid for layers that are folded away.
    [[nodiscard]] QModelIndex mapFromSource(const QModelIndex& index) const override;
    /// Of headings too, which the layers know nothing of: views edit, and toggle boxes, at the buddy of a cell.
    [[nodiscard]] QModelIndex buddy(const QModelIndex& index) const override { return index; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    struct Row {
        model::LayerGroup group;
        model::LayerId layer;  ///< none: the heading
    };

    void takeDocument();
    [[nodiscard]] bool isDull(model::LayerGroup group) const;
    [[nodiscard]] int headingOf(model::LayerGroup group) const;
    [[nodiscard]] QVariant headingData(model::LayerGroup group, int column, int role) const;
    [[nodiscard]] Qt::CheckState checkOf(model::LayerGroup group) const;
    [[nodiscard]] const std::vector<model::LayerId>& layersIn(model::LayerGroup group) const {
        return m_layersIn[static_cast<std::size_t>(group)];
    }

    LayerModel& m_layers;
    std::array<std::vector<model::LayerId>, model::kLayerGroupCount> m_layersIn;
    std::array<bool, model::kLayerGroupCount> m_isFolded{};
    std::vector<Row> m_rows;
};

}  // namespace ui
