#include "ui/messages/messages_feature.h"

#include <QComboBox>
#include <QLabel>
#include <QStatusBar>

#include "render/modelling/board_frame.h"
#include "render/scene/explosion.h"
#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/messages/message_badge.h"
#include "ui/messages/message_model.h"
#include "ui/views/board_views.h"
#include "ui/workspace/hint.h"

namespace ui {

namespace {

/// The part of the board that a message is about, in the renderer's millimetres; nothing for messages about files or
/// the whole board.
std::optional<render::Box3> locationOf(const model::Diagnostic& message, const model::Document& document) {
    const render::BoardFrame frame = render::frameOf(document);
    model::Box box;
    float bottom = frame.boxMin.z;
    float top = frame.boxMax.z;
    if (message.element.isValid()) {
        const std::size_t layer = document.elements.layer[message.element.row()].row();
        box = document.boxOf(message.element);
        bottom = frame.layers[layer].z0;
        top = frame.layers[layer].z1;
    } else if (message.location) {
        box.include(*message.location);
    } else {
        return std::nullopt;
    }
    const glm::vec2 low = render::toGpu(base::toDouble(box.min), frame.origin);
    const glm::vec2 high = render::toGpu(base::toDouble(box.max), frame.origin);
    return render::Box3{{low, bottom}, {high, top}};
}

void show(const model::Diagnostic& message, Workspace& workspace, BoardViews& views, Hint& hint) {
    const model::Document& document = *workspace.board()->document;
    const std::optional<render::Box3> location = locationOf(message, document);
    if (!location) {
        hint.show(MessageModel::tr("This message is not about one location on the board"));
        return;
    }
    hint.end();
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
    auto* hint = new Hint(workspace, messages);
    QWidget* panel = makeMessagesPanel(*messages, [&context, hint](const model::Diagnostic& message) {
        show(message, context.workspace, context.views, *hint);
    });
    context.addPanel({ActionId::ShowMessagesDock, "messages", MessageModel::tr("Messages"), Qt::BottomDockWidgetArea},
                     *panel);
    context.window.statusBar()->addPermanentWidget(
        new MessageBadge(*messages, context.actions[ActionId::ShowMessagesDock]));
    const auto setBoard = [messages](const LoadedBoard& board) {
        messages->setMessages(board.document, board.model->diagnostics);
    };
    QObject::connect(&workspace, &Workspace::boardRead, messages, setBoard);
    QObject::connect(&workspace, &Workspace::boardRead, messages, [messages] { messages->setExported({}); });
    QObject::connect(&workspace, &Workspace::exportListed, messages, &MessageModel::setExported);
    QObject::connect(&workspace, &Workspace::restacked, messages, setBoard);
}

QWidget* makeMessagesPanel(MessageModel& model, const std::function<void(const model::Diagnostic&)>& choose) {
    auto* table = new TableView(model);
    SortedRows& rows = table->makeSortable();
    table->sortByColumn(MessageModel::Severity, Qt::DescendingOrder);
    table->fitColumns(MessageModel::Text);
    auto* severity = new QComboBox;
    severity->addItems({MessageModel::tr("Everything"), MessageModel::tr("Warnings and errors"),
                        MessageModel::tr("Errors only")});  // by least severity
    QObject::connect(severity, &QComboBox::currentIndexChanged, &rows, &SortedRows::setLeastRank);
    QObject::connect(table, &TableView::rowChosen, &model, [&model, choose](int row) { choose(model.message(row)); });
    auto* summary = new QLabel;
    const auto updateSummary = [&rows, &model, summary] {
        summary->setText(MessageModel::tr("%1 of %2").arg(rows.rowCount()).arg(model.rowCount()));
    };
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        QObject::connect(&rows, signal, summary, updateSummary);
    }
    QObject::connect(&rows, &QAbstractItemModel::modelReset, summary, updateSummary);
    updateSummary();
    auto* controls = new QHBoxLayout;
    controls->addWidget(filterEdit(rows, MessageModel::tr("Filter by words of the message or the file")), 1);
    controls->addWidget(severity);
    controls->addWidget(summary);
    return panelOf(controls, table);
}

}  // namespace ui
