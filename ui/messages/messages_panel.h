#pragma once

#include <QWidget>

#include "ui/messages/message_filter.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace ui {

class MessageModel;
class TableView;

/// What was skipped, repaired or assumed, with file and line; filtered by words and by severity. A click on a message,
/// or Enter, asks to be shown what it is about.
class MessagesPanel : public QWidget {
    Q_OBJECT

public:
    explicit MessagesPanel(MessageModel& model, QWidget* parent = nullptr);
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] QLineEdit& wordsEdit() { return *m_words; }
    [[nodiscard]] QComboBox& severityBox() { return *m_severity; }

signals:
    void chosen(const model::Diagnostic& message);

private:
    void choose(const QModelIndex& index);
    void updateSummary();
    void fitColumns();

    MessageModel& m_model;
    MessageFilter* m_filter;
    TableView* m_table;
    QLineEdit* m_words;
    QComboBox* m_severity;
    QLabel* m_summary;
};

}  // namespace ui
