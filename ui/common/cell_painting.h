#pragma once

#include <QPainter>
#include <QStyleOptionViewItem>

/// What cells of tables show beside text, alike in all panels.
namespace ui {

/// A cell without the frame around it.
[[nodiscard]] QRect innerOf(const QRect& cell);
/// The ground of a cell: plain, selected, alternating.
void paintGround(QPainter& painter, const QStyleOptionViewItem& option);
/// A field of a colour; an invalid one is an empty field.
void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, const QColor& colour);
/// A box with a tick, in the text's colour: the styles' own boxes vanish on a dark ground.
void paintCheck(QPainter& painter, const QStyleOptionViewItem& option, bool isChecked);

}  // namespace ui
