#include "ui/messages/messages_feature.h"

#include "ui/messages/message_location.h"
#include "ui/messages/message_model.h"
#include "ui/messages/messages_panel.h"
#include "ui/views/board_views.h"

namespace ui {

namespace {

void show(const model::Diagnostic& message, Workspace& workspace, BoardViews& views) {
    const model::Document& document = *workspace.board()->document;
    const std::optional<render::Box3> location = locationOf(message, document, render::frameOf(document));
    if (!location) {
        workspace.report(MessagesPanel::tr("This message is not about one location on the board"));
        return;
    }
    workspace.selection().select({});
    if (message.element.isValid()) {
        workspace.selection().select({{0, message.element}});
        workspace.showLayer(document.elements.layer[message.element.row()]);
    }
    for (BoardView* view : views.both()) {
        view->controller().show(location->min, location->max);
    }
}

}  // namespace

void addMessages(FeatureContext& context) {
    Workspace& workspace = context.workspace;
    auto* messages = new MessageModel(&context.window);
    auto* panel = new MessagesPanel(*messages);
    context.addPanel(
        {ActionId::ShowMessagesDock, "messages", MessagesPanel::tr("Messages"), Qt::BottomDockWidgetArea, {}, 13},
        *panel);
    const auto setBoard = [messages](const LoadedBoard& board) {
        messages->setMessages(board.document, board.model->diagnostics);
    };
    QObject::connect(&workspace, &Workspace::boardRead, messages, setBoard);
    QObject::connect(&workspace, &Workspace::restacked, messages, setBoard);
    QObject::connect(panel, &MessagesPanel::chosen, &workspace,
                     [&context](const model::Diagnostic& message) { show(message, context.workspace, context.views); });
}

}  // namespace ui
