#include "ui/common/elided_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setMostLines(int lines) {
    m_mostLines = lines;
    updateGeometry();
}

QStringList ElidedLabel::linesIn(int width) const {
    QTextLayout layout(text(), font());
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    qsizetype from = 0;
    layout.beginLayout();
    while (lines.size() + 1 < m_mostLines) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) {
            break;
        }
        line.setLineWidth(width);
        lines += text().mid(from, line.textLength());
        from += line.textLength();
    }
    layout.endLayout();
    return from < text().size() ? lines << fontMetrics().elidedText(text().mid(from), Qt::ElideRight, width) : lines;
}

QString ElidedLabel::shown() const {
    return linesIn(contentsRect().width()).join(QString());
}

int ElidedLabel::heightForWidth(int width) const {
    const QMargins around = contentsMargins();
    const auto lines = static_cast<int>(linesIn(width - around.left() - around.right()).size());
    return std::max(lines, 1) * fontMetrics().lineSpacing() + around.top() + around.bottom();
}

bool ElidedLabel::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const QString whole = shown() == text() ? QString() : text();
        QToolTip::showText(static_cast<const QHelpEvent*>(event)->globalPos(), whole, this);
        return true;
    }
    return QLabel::event(event);
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    const QStringList lines = linesIn(contentsRect().width());
    painter.drawText(contentsRect(), static_cast<int>(alignment()), lines.join('\n'));
}

}  // namespace ui
