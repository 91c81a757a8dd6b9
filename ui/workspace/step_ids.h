#pragma once

namespace ui {

/// QUndoCommand::id of all steps of the history of which several in a row may become one. The history asks a step to
/// merge with whatever has its id, so those of two kinds must not meet. Steps that stay alone have none (-1).
enum StepId : int {
    kHighlightStep,
    kLayerStep,  ///< and all above it: kLayerStep + LayerEdit::cell
};

}  // namespace ui
