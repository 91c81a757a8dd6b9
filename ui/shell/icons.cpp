#include "ui/shell/icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>

#include "ui/workspace/actions.h"

namespace ui {

namespace {

// Drawings live on a square of 24 units. The board is a slab seen from a corner: four points of its top face, and its
// height below them.
constexpr double kUnits = 24.0;
const QPolygonF kTopFace{{12, 4}, {22, 9}, {12, 14}, {2, 9}};
constexpr double kPartHeight = 5.0;

void drawFolder(QPainter& painter) {
    painter.drawPolyline(QPolygonF{{3, 19}, {3, 5}, {9, 5}, {11, 8}, {20, 8}, {20, 11}});
    painter.drawPolygon(QPolygonF{{3, 19}, {7, 11}, {23, 11}, {19, 19}});
}

void drawFit(QPainter& painter) {
    for (const QPolygonF& corner : {QPolygonF{{3, 8}, {3, 3}, {8, 3}}, QPolygonF{{16, 3}, {21, 3}, {21, 8}},
                                    QPolygonF{{21, 16}, {21, 21}, {16, 21}}, QPolygonF{{8, 21}, {3, 21}, {3, 16}}}) {
        painter.drawPolyline(corner);
    }
    painter.drawRect(QRectF(8, 9, 8, 6));
}

void drawSubstrate(QPainter& painter, bool isTopFilled, bool isBottomFilled) {
    const QBrush fill(painter.pen().color());
    const QPointF down(0, kPartHeight);
    if (isBottomFilled) {
        painter.setBrush(fill);
        painter.drawPolygon(kTopFace.translated(down));
        painter.setBrush(QApplication::palette().color(QPalette::Button));
    } else {
        painter.drawPolyline(QPolygonF{kTopFace[1] + down, kTopFace[2] + down, kTopFace[3] + down});
    }
    for (const int corner : {1, 2, 3}) {
        painter.drawLine(kTopFace[corner], kTopFace[corner] + down);
    }
    if (isTopFilled) {
        painter.setBrush(fill);
    }
    painter.drawPolygon(kTopFace);
}

void drawExplode(QPainter& painter) {
    const QPolygonF plane{{12, 1}, {21, 5}, {12, 9}, {3, 5}};
    for (const double y : {14.0, 7.0, 0.0}) {
        painter.setBrush(QApplication::palette().color(QPalette::Button));
        painter.drawPolygon(plane.translated(0, y));
    }
}

void drawParallel(QPainter& painter) {
    painter.drawRect(QRectF(3, 9, 12, 12));
    painter.drawPolyline(QPolygonF{{3, 9}, {9, 3}, {21, 3}, {15, 9}});
    painter.drawPolyline(QPolygonF{{21, 3}, {21, 15}, {15, 21}});
}

/// A body with leads on two sides.
void drawComponent(QPainter& painter) {
    for (const double y : {6.0, 10.0, 14.0, 18.0}) {
        painter.drawLine(QPointF(2, y), QPointF(6, y));
        painter.drawLine(QPointF(18, y), QPointF(22, y));
    }
    painter.drawRect(QRectF(6, 3, 12, 18));
    painter.drawEllipse(QPointF(9, 6), 0.8, 0.8);
}

void drawCamera(QPainter& painter) {
    painter.drawPolygon(QPolygonF{{2, 7}, {7, 7}, {9, 4}, {15, 4}, {17, 7}, {22, 7}, {22, 20}, {2, 20}});
    painter.drawEllipse(QPointF(12, 13), 4.0, 4.0);
}

using Draw = void (*)(QPainter&);

struct Drawing {
    ActionId id;
    Draw draw;
};

const Drawing kDrawings[] = {
    {ActionId::OpenFile, drawFolder},
    {ActionId::Fit, drawFit},
    {ActionId::ViewTop, [](QPainter& painter) { drawSubstrate(painter, true, false); }},
    {ActionId::ViewBottom, [](QPainter& painter) { drawSubstrate(painter, false, true); }},
    {ActionId::ViewIso, [](QPainter& painter) { drawSubstrate(painter, false, false); }},
    {ActionId::Orthographic, drawParallel},
    {ActionId::Explode, drawExplode},
    {ActionId::ShowComponents, drawComponent},
    {ActionId::SavePicture, drawCamera},
};

/// Draws at whatever size and pixel ratio is asked for, in today's text colour: sharp on every screen, right in every
/// theme.
class DrawnIcon : public QIconEngine {
public:
    explicit DrawnIcon(Draw draw) : m_draw(draw) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / kUnits, rect.height() / kUnits);
        painter->setPen(QPen(QApplication::palette().color(group, QPalette::ButtonText), 1.6, Qt::SolidLine,
                             Qt::RoundCap, Qt::RoundJoin));
        m_draw(*painter);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect({}, size), mode, state);
        return image;
    }

    QIconEngine* clone() const override { return new DrawnIcon(m_draw); }

private:
    Draw m_draw;
};

}  // namespace

QIcon iconOf(ActionId id) {
    for (const Drawing& drawing : kDrawings) {
        if (drawing.id == id) {
            return QIcon(new DrawnIcon(drawing.draw));
        }
    }
    return {};
}

}  // namespace ui
