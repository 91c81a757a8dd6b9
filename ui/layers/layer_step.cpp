#include "ui/layers/layer_step.h"

namespace ui {

bool LayerStep::mergeWith(const QUndoCommand* next) {
    m_edit.after = static_cast<const LayerStep&>(*next).m_edit.after;  // of one id, so of one class: others have none
    setObsolete(m_edit.after == m_edit.before);
    return true;
}

}  // namespace ui
