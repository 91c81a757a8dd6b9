#include "ui/shell/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), m_label(new QLabel) {
    setObjectName(QStringLiteral("messageBar"));
    setStyleSheet(QStringLiteral(
        "#messageBar { background: #7d2a22; } #messageBar QLabel, #messageBar QToolButton { color: white; }"
        "#messageBar QToolButton { border: none; padding: 2px 6px; } #messageBar QToolButton:hover { background: "
        "#a8463c; }"));
    m_label->setWordWrap(true);
    m_label->setTextFormat(Qt::PlainText);  // reasons hold file names, which may look like markup
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* close = new QToolButton;
    close->setText(tr("Close"));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->addWidget(m_label, 1);
    layout->addWidget(close);
    m_isNew.setSingleShot(true);
    m_isNew.setInterval(0);
    hide();
}

void MessageBar::showError(const QString& text) {
    const bool isOneMore = !isHidden() && m_sinceLast.isValid() && !m_sinceLast.hasExpired(kTogetherMs);
    if (!isOneMore) {
        m_label->setText(text);
    } else if (!m_label->text().split('\n').contains(text)) {
        m_label->setText(m_label->text() + '\n' + text);
    }
    show();
    m_isNew.start();
    m_sinceLast.start();
}

void MessageBar::endEarlierError() {
    if (!m_isNew.isActive()) {
        hide();
    }
}

bool MessageBar::end() {
    const bool wasShown = !isHidden();
    hide();
    return wasShown;
}

}  // namespace ui
