#pragma once

#include <QToolButton>

namespace ui {

class MessageModel;

/// A button of the status line that says how many warnings and errors a board came with, red when there is an error.
/// It opens and closes the panel that lists them. Hidden before there is a board.
class MessageBadge : public QToolButton {
    Q_OBJECT

public:
    /// `panel`: the command that shows and hides the list.
    MessageBadge(const MessageModel& messages, QAction& panel, QWidget* parent = nullptr);

private:
    void refresh();

    const MessageModel& m_messages;
};

}  // namespace ui
