#pragma once

#include <QGroupBox>
#include <vector>

#include "ui/layers/layer_model.h"
#include "ui/workspace/settings.h"

class QListWidget;

namespace ui {

/// Which layers are exported: those of the board that anything is on, with check marks, and buttons that set them all.
class ExportLayers : public QGroupBox {
    Q_OBJECT

public:
    /// As the window shows the layers: colours, and what is visible.
    explicit ExportLayers(const LayerModel& layers, QWidget* parent = nullptr);

    /// In the order of the board.
    [[nodiscard]] std::vector<model::LayerId> layers() const;
    /// As the last time, by name. Layers that were not there are checked if a finished board consists of them
    /// (model::isSolidLayer).
    void restore(const Settings& settings);
    void remember(Settings& settings) const;

signals:
    /// Once per edit, however many layers it concerns.
    void changed();

private:
    QWidget* buttons();
    /// `isChecked` is asked for the row of each layer.
    template <class Rule>
    void check(const Rule& isChecked);

    const LayerModel& m_model;
    QListWidget* m_list;
};

}  // namespace ui
