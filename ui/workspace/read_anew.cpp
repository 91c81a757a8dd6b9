#include "ui/workspace/read_anew.h"

namespace ui {

namespace {

bool isSameJob(const Workspace& workspace, const LoadedBoard& next) {
    const LoadedBoard* board = workspace.board();
    return board != nullptr && board->request.path == next.request.path &&
           board->request.member == next.request.member && board->format == next.format;
}

}  // namespace

bool isReadAnew(const Workspace& workspace, const LoadedBoard& next) {
    return isSameJob(workspace, next) && workspace.isOpen(next.document->job.step);
}

bool isOtherStep(const Workspace& workspace, const LoadedBoard& next) {
    return isSameJob(workspace, next) && !workspace.isOpen(next.document->job.step);
}

}  // namespace ui
