#pragma once

#include <QWidget>

#include "model/board/diagnostics.h"

namespace ui {

class MessageModel;
class TableView;

/// What was skipped, repaired or assumed, with file and line; filtered by words and by severity. A click on a message,
/// or Enter, shows what it is about.
class MessagesPanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagesPanel(MessageModel& model, QWidget* parent = nullptr);
    [[nodiscard]] TableView& table() { return *m_table; }

signals:
    void chosen(const model::Diagnostic& message);

private:
    TableView* m_table;
};

}  // namespace ui
