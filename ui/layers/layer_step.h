#pragma once

#include <QUndoCommand>

#include "ui/layers/layer_model.h"

namespace ui {

/// A step of the undo history: an edit of the layers that was made. The layers must be those of the same board as long
/// as the step is there, which Workspace sees to.
class LayerStep : public QUndoCommand {
public:
    LayerStep(LayerModel& layers, LayerEdit edit)
        : QUndoCommand(edit.what), m_layers(layers), m_edit(std::move(edit)) {}

    void undo() override { m_layers.setSettings(m_edit.before); }
    void redo() override { m_layers.setSettings(m_edit.after); }
    [[nodiscard]] int id() const override;
    /// What a drag changes is one step, and none if it ends where it began.
    bool mergeWith(const QUndoCommand* next) override;

private:
    LayerModel& m_layers;
    LayerEdit m_edit;
};

}  // namespace ui
