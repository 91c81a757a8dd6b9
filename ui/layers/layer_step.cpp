#include "ui/layers/layer_step.h"

#include "ui/workspace/step_ids.h"

namespace ui {

int LayerStep::id() const {
    return m_edit.cell < 0 ? -1 : kLayerStep + m_edit.cell;
}

bool LayerStep::mergeWith(const QUndoCommand* next) {
    const auto* later = dynamic_cast<const LayerStep*>(next);
    if (later == nullptr) {
        return false;
    }
    m_edit.after = later->m_edit.after;
    setObsolete(m_edit.after == m_edit.before);
    return true;
}

}  // namespace ui
