#include "ui/messages/message_badge.h"

#include <QAction>
#include <QPainter>
#include <QPixmap>

#include "ui/common/severity_colour.h"
#include "ui/common/trouble_text.h"
#include "ui/messages/message_model.h"

namespace ui {

namespace {

QIcon dot(const QColor& colour, int pixels) {
    QPixmap picture(pixels, pixels);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(0.5, 0.5, pixels - 1.0, pixels - 1.0));
    return picture;
}

}  // namespace

MessageBadge::MessageBadge(const MessageModel& messages, QAction& panel, QWidget* parent)
    : QToolButton(parent), m_messages(messages) {
    setObjectName(QStringLiteral("messageBadge"));
    setAutoRaise(true);
    setCheckable(true);
    setFocusPolicy(Qt::NoFocus);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    const int side = fontMetrics().ascent() - 2;
    setIconSize({side, side});
    connect(&messages, &QAbstractItemModel::modelReset, this, &MessageBadge::refresh);
    connect(this, &QToolButton::clicked, &panel, &QAction::trigger);
    connect(&panel, &QAction::toggled, this, &QToolButton::setChecked);
    hide();
}

void MessageBadge::refresh() {
    const std::size_t errors = m_messages.count(model::Severity::Error);
    const std::size_t warnings = m_messages.count(model::Severity::Warning);
    setText(errors + warnings == 0 ? tr("No warnings") : troubleText(errors, warnings));
    setToolTip(tr("What was skipped, repaired or assumed while the board was opened or exported, or left out of "
                  "its rules: %L1 messages. Click to list them")
                   .arg(m_messages.rowCount()));
    setStyleSheet(errors == 0 ? QString()
                              : QStringLiteral("QToolButton { background: %1; color: white; font-weight: bold; }")
                                    .arg(severityColour(model::Severity::Error).darker(125).name()));
    const model::Severity worst = errors > 0     ? model::Severity::Error
                                  : warnings > 0 ? model::Severity::Warning
                                                 : model::Severity::Info;
    setIcon(dot(errors > 0 ? QColor(Qt::white) : severityColour(worst), iconSize().width()));
    show();
}

}  // namespace ui
