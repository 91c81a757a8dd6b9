#include "ui/shell/status_bar.h"

#include <QPainter>
#include <QSizeGrip>
#include <QStyleOption>
#include <algorithm>

namespace ui {

QString StatusBar::shownMessage() const {
    return fontMetrics().elidedText(currentMessage(), Qt::ElideRight, messageRect().width());
}

/// Qt paints messages as they are and lets widgets lie over them.
void StatusBar::paintEvent(QPaintEvent* event) {
    if (currentMessage().isEmpty()) {
        return QStatusBar::paintEvent(event);
    }
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(messageRect(), Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine, shownMessage());
}

/// Left of all permanent widgets; others are hidden while there is a message.
QRect StatusBar::messageRect() const {
    constexpr int kMargin = 6;
    int right = width() - kMargin;
    for (const QWidget* widget : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        if (widget->isVisible() && qobject_cast<const QSizeGrip*>(widget) == nullptr) {
            right = std::min(right, widget->x() - kMargin);
        }
    }
    return {kMargin, 0, std::max(right - kMargin, 0), height()};
}

}  // namespace ui
