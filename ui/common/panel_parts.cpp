#include "ui/common/panel_parts.h"

#include <QKeyEvent>

#include "ui/common/sorted_rows.h"

namespace ui {

QToolButton* toolButton(QAction& action) {
    auto* button = new QToolButton;
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    button->setObjectName(action.objectName());
    return button;
}

QHBoxLayout* buttonRow(std::initializer_list<QAction*> actions) {
    auto* row = new QHBoxLayout;
    for (QAction* action : actions) {
        row->addWidget(toolButton(*action));
    }
    row->addStretch();
    return row;
}

QToolBar* toolBar(std::initializer_list<QAction*> actions) {
    auto* bar = new QToolBar;
    bar->addActions(actions);
    if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        more->setIcon({});  // a picture of its own style, dark on whatever ground; text has the palette's colour
        more->setText(QStringLiteral("»"));
    }
    return bar;
}

namespace {

/// Esc empties it, and leaves it once it is empty, so that keys are commands again.
class FilterEdit : public QLineEdit {
protected:
    bool event(QEvent* event) override {
        const bool isEscape = (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) &&
                              static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
        if (!isEscape) {
            return QLineEdit::event(event);
        }
        if (event->type() == QEvent::KeyPress) {
            text().isEmpty() ? clearFocus() : clear();
        }
        event->accept();
        return true;
    }
};

}  // namespace

QLineEdit* filterEdit(const QString& hint) {
    auto* line = new FilterEdit;
    line->setPlaceholderText(hint);
    line->setClearButtonEnabled(true);
    return line;
}

QLineEdit* filterEdit(SortedRows& rows, const QString& hint) {
    QLineEdit* line = filterEdit(hint);
    QObject::connect(line, &QLineEdit::textChanged, &rows, &SortedRows::setWords);
    return line;
}

QWidget* panelOf(QLayout* controls, QWidget* below, int margin) {
    auto* panel = new QWidget;
    auto* column = columnIn(*panel, margin);
    column->addLayout(controls);
    column->addWidget(below);
    return panel;
}

void clearMenu(QMenu& menu) {
    menu.clear();
    qDeleteAll(menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
}

QVBoxLayout* columnIn(QWidget& panel, int margin) {
    auto* column = new QVBoxLayout(&panel);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(2);
    return column;
}

}  // namespace ui
