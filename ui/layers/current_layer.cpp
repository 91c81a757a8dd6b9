#include "ui/layers/current_layer.h"

#include "model/board/layers.h"

namespace ui {

model::LayerId takeCurrentLayer(Workspace& workspace) {
    const LoadedBoard* board = workspace.board();
    if (board != nullptr && !workspace.currentLayer().isValid()) {
        const auto meant = workspace.selection().pointedOrCurrent();
        workspace.setCurrentLayer(meant ? workspace.selection().layerOf(*meant)
                                        : model::outerCopper(*board->document, model::LayerSide::Top));
    }
    return workspace.currentLayer();
}

}  // namespace ui
