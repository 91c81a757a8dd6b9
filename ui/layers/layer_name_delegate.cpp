#include "ui/layers/layer_name_delegate.h"

#include <QApplication>
#include <algorithm>

namespace ui {

namespace {

qsizetype sameAtBeginning(const QString& a, const QString& b) {
    return std::ranges::mismatch(a, b).in1 - a.begin();
}

}  // namespace

QString shortName(const QString& name, const QStringList& all, const QFontMetrics& letters, int width) {
    const QString middleCut = letters.elidedText(name, Qt::ElideMiddle, width);
    if (middleCut == name) {
        return name;
    }
    const QChar dots(0x2026);
    const QString head = middleCut.section(dots, 0, 0);
    const QString tail = middleCut.section(dots, -1);
    qsizetype same = 0;
    for (const QString& other : all) {
        if (other != name && other.startsWith(head) && other.endsWith(tail)) {
            same = std::max(same, sameAtBeginning(name, other));
        }
    }
    if (same == 0) {
        return middleCut;
    }
    // The end alone, if it shows where they differ: a name may be all that another begins with.
    const QString end = letters.elidedText(name, Qt::ElideLeft, width);
    const bool showsDifference = name.size() - (end.size() - 1) <= same;
    return showsDifference ? end : letters.elidedText(dots + name.mid(same), Qt::ElideRight, width);
}

void LayerNameDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    CellDelegate::initStyleOption(option, index);
    const QStyle& style = option->widget != nullptr ? *option->widget->style() : *QApplication::style();
    const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
    if (!option->font.bold()) {  // headings have room
        option->text = shortName(option->text, m_names, option->fontMetrics, option->rect.width() - 2 * margin);
    }
}

}  // namespace ui
