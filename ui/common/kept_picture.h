#pragma once

#include <QImage>
#include <QPainter>
#include <QRect>
#include <optional>

namespace ui {

/// What takes long to paint over a view and seldom changes, as a picture that is painted instead while it stays the
/// same. `Key` says what it looks like. What is blended as a picture is at places a level of 255 beside what is painted
/// at once.
template <class Key>
class KeptPicture {
public:
    /// False: it is not there.
    [[nodiscard]] bool show(QPainter& painter, const Key& key) const {
        if (m_key != key || m_ratio != ratioOf(painter)) {
            return false;
        }
        painter.drawImage(m_corner, m_picture);
        return true;
    }

    /// Shows what `paint(QPainter&)` paints within `box`, in logical pixels, and keeps it. Memory for one of a whole
    /// view takes 5 ms to get, unless the last one was as large.
    template <class Paint>
    void keep(QPainter& painter, const Key& key, const QRect& box, const Paint& paint) {
        m_key = key;
        m_ratio = ratioOf(painter);
        m_corner = box.topLeft();
        const QSize pixels = (QSizeF(box.size()) * m_ratio).toSize();
        if (m_picture.size() != pixels) {
            m_picture = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
        }
        if (pixels.isEmpty()) {
            return;
        }
        m_picture.setDevicePixelRatio(m_ratio);
        m_picture.fill(Qt::transparent);
        QPainter own(&m_picture);
        own.setRenderHints(painter.renderHints());
        own.setFont(painter.font());
        own.translate(-m_corner);
        paint(own);
        own.end();
        painter.drawImage(m_corner, m_picture);
    }

private:
    /// Pixels of the device per logical one.
    static qreal ratioOf(const QPainter& painter) {
        return painter.device()->devicePixelRatioF() * painter.transform().m11();
    }

    std::optional<Key> m_key;
    qreal m_ratio = 1.0;
    QImage m_picture;
    QPoint m_corner;
};

}  // namespace ui
