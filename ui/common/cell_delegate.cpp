#include "ui/common/cell_delegate.h"

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPointer>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "ui/common/table_model.h"

namespace ui {

namespace {

constexpr const char* kRefused = "isRefused";  ///< of an editor

int traitsOf(const QModelIndex& index) {
    return index.data(TableModel::kTraitsRole).toInt();
}

Qt::CheckState checkOf(const QModelIndex& index) {
    return static_cast<Qt::CheckState>(index.data(Qt::CheckStateRole).toInt());
}

/// A cell without the frame around it.
QRect innerOf(const QRect& cell) {
    return cell.adjusted(4, 3, -4, -3);
}

bool isSelected(const QStyleOptionViewItem& option) {
    return option.state.testFlag(QStyle::State_Selected);
}

QColor inkOf(const QStyleOptionViewItem& option) {
    return option.palette.color(isSelected(option) ? QPalette::HighlightedText : QPalette::Text);
}

QColor faint(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// A frame that is faint on the ground of a table would be none on that of a selected row, which is of a strong colour.
int frameAlpha(const QStyleOptionViewItem& option) {
    return isSelected(option) ? 235 : 110;
}

/// An invalid colour is an empty field.
void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, const QColor& colour) {
    if (colour.isValid()) {
        painter.fillRect(innerOf(option.rect), colour);
    }
    painter.setPen(faint(inkOf(option), 90));
    painter.drawRect(innerOf(option.rect).adjusted(0, 0, -1, -1));
}

/// In the colour of the text: the styles' own boxes vanish on a dark ground.
void paintCheck(QPainter& painter, const QStyleOptionViewItem& option, Qt::CheckState state) {
    const QColor tone = inkOf(option);
    const double side = std::min(innerOf(option.rect).height(), innerOf(option.rect).width());
    QRectF box(0.0, 0.0, side, side);
    box.moveCenter(QRectF(option.rect).center());
    // A line between two pixels is a faint one on both.
    box.moveTopLeft({std::floor(box.left()) + 0.5, std::floor(box.top()) + 0.5});
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(faint(tone, frameAlpha(option)), 1.0));
    painter.drawRoundedRect(box, 2.0, 2.0);
    if (state == Qt::PartiallyChecked) {
        painter.fillRect(box.adjusted(side * 0.25, side * 0.4, -side * 0.25, -side * 0.4), tone);
    } else if (state == Qt::Checked) {
        const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x, y) * side; };
        painter.setPen(QPen(tone, side / 7.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{at(0.22, 0.52), at(0.42, 0.74), at(0.78, 0.28)});
    }
}

void paintBar(QPainter& painter, const QStyleOptionViewItem& option, int percent) {
    const QRect whole = innerOf(option.rect);
    QRect filled = whole;
    filled.setWidth(whole.width() * percent / 100);
    const QColor tone = option.palette.color(QPalette::Text);
    painter.fillRect(filled, faint(tone, 45));
    painter.setPen(faint(tone, 110));
    painter.drawRect(whole.adjusted(0, 0, -1, -1));
    painter.setPen(inkOf(option));
    painter.drawText(whole, Qt::AlignCenter, QStringLiteral("%1 %").arg(percent));
}

int percentAt(const QRect& cell, double x) {
    const QRect whole = innerOf(cell);
    return std::clamp(static_cast<int>((x - whole.left()) * 100.0 / std::max(whole.width() - 1, 1)), 0, 100);
}

QWidget* percentBox(QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setRange(0, 100);
    box->setSuffix(QStringLiteral(" %"));
    box->setFrame(false);
    return box;
}

}  // namespace

void CellDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    // Headings begin with what they are, but where a table tells names apart by their ends theirs are no exception.
    const bool isHeading = option->font.bold() && option->textElideMode != Qt::ElideLeft;
    if (isHeading || (traitsOf(index) & kNumber) != 0) {
        option->textElideMode = Qt::ElideRight;
    } else if ((traitsOf(index) & kPath) != 0) {
        option->textElideMode = Qt::ElideLeft;
    }
}

void CellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int traits = traitsOf(index);
    if (traits != kCheck && (traits & (kColour | kPercent)) == 0) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    painter->save();
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    const QStyle& style = cell.widget != nullptr ? *cell.widget->style() : *QApplication::style();
    style.drawPrimitive(QStyle::PE_PanelItemViewItem, &cell, painter, cell.widget);
    if (traits == kCheck) {
        paintCheck(*painter, cell, checkOf(index));
    } else if ((traits & kColour) != 0) {
        paintSwatch(*painter, cell, index.data(Qt::EditRole).value<QColor>());
    } else {
        paintBar(*painter, cell, index.data(Qt::EditRole).toInt());
    }
    painter->restore();
}

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
    const int traits = traitsOf(index);
    if ((traits & kColour) != 0) {
        return nullptr;
    }
    const QStringList choices = index.data(TableModel::kChoicesRole).toStringList();
    if (choices.isEmpty()) {
        return (traits & kPercent) != 0 ? percentBox(parent) : QStyledItemDelegate::createEditor(parent, option, index);
    }
    auto* box = new QComboBox(parent);
    box->addItems(choices);
    // What is chosen counts at once; a box closed without a choice stays until the cell is left.
    connect(box, &QComboBox::activated, this, [this, box] {
        auto* self = const_cast<CellDelegate*>(this);
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void CellDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    auto* line = qobject_cast<QLineEdit*>(editor);
    if (line == nullptr) {
        QStyledItemDelegate::setModelData(editor, model, index);
        return;
    }
    const QPointer<QLineEdit> guard(line);  // an edit may empty the table, and with it the editor
    const bool isTaken = model->setData(index, line->text(), Qt::EditRole);
    if (guard != nullptr) {
        line->setProperty(kRefused, !isTaken);
    }
}

bool CellDelegate::isRefused(const QWidget& editor) {
    return editor.property(kRefused).toBool();
}

bool CellDelegate::eventFilter(QObject* editor, QEvent* event) {
    const bool isTaken = QStyledItemDelegate::eventFilter(editor, event);
    const bool isKey = event->type() == QEvent::KeyPress && qobject_cast<QComboBox*>(editor) != nullptr;
    const int key = isKey ? static_cast<const QKeyEvent&>(*event).key() : 0;
    return isTaken || key == Qt::Key_Return || key == Qt::Key_Enter;
}

bool CellDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                               const QModelIndex& index) {
    const bool isCheck = traitsOf(index) == kCheck;
    const bool isPress = event->type() == QEvent::MouseButtonPress;
    const bool isDrag = event->type() == QEvent::MouseMove;
    const bool isMouse = isPress || isDrag || event->type() == QEvent::MouseButtonDblClick;
    if (!isMouse || !static_cast<const QMouseEvent&>(*event).buttons().testFlag(Qt::LeftButton)) {
        // The release after a press has done its work; keys are handled as usual.
        return (event->type() == QEvent::MouseButtonRelease && isCheck) ||
               QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    if (isPress) {
        m_pressed = index;
    }
    // A drag that began elsewhere, to select rows say, changes nothing when it passes here.
    if ((traitsOf(index) & kPercent) != 0 && (isPress || (isDrag && index == m_pressed))) {
        const double x = static_cast<const QMouseEvent&>(*event).position().x();
        return model->setData(index, percentAt(option.rect, x), Qt::EditRole);
    }
    if (isCheck && !isDrag) {
        return model->setData(index, checkOf(index) == Qt::Checked ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace ui
