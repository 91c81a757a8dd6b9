#pragma once

#include <QImage>
#include <QPainter>
#include <QRect>
#include <optional>

namespace ui {

/// When something that is painted becomes a picture. One that is blended is at places a level of 255 beside what is
/// painted at once.
enum class Keep {
    AtOnce,
    WhenRepeated  ///< for what is large, and mostly painted once only while the view moves
};

/// What takes long to paint over a view and seldom changes, as a picture that is painted instead while it stays the
/// same. `Key` says what it looks like.
template <class Key>
class KeptPicture {
public:
    /// Larger ones are painted every time: to get memory for one of a whole view takes 5 ms, longer than to paint what
    /// is in it.
    static constexpr int kMostPixels = 1 << 19;

    explicit KeptPicture(Keep keep) : m_keep(keep) {}

    /// False: it is not there.
    [[nodiscard]] bool show(QPainter& painter, const Key& key) const {
        if (m_picture.isNull() || m_key != key || m_ratio != ratioOf(painter)) {
            return false;
        }
        painter.drawImage(m_corner, m_picture);
        return true;
    }

    /// What `paint(QPainter&)` paints within `box`, in logical pixels.
    template <class Paint>
    void paint(QPainter& painter, const Key& key, const QRect& box, const Paint& paint) {
        const bool isKept = m_keep == Keep::AtOnce || (m_key == key && m_ratio == ratioOf(painter));
        m_key = key;
        m_ratio = ratioOf(painter);
        m_picture = {};
        const QSize pixels = (QSizeF(box.size()) * m_ratio).toSize();
        if (!isKept || box.isEmpty() || qint64{pixels.width()} * pixels.height() > kMostPixels) {
            paint(painter);
            return;
        }
        m_corner = box.topLeft();
        m_picture = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
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

    Keep m_keep;
    std::optional<Key> m_key;
    qreal m_ratio = 1.0;
    QImage m_picture;
    QPoint m_corner;
};

}  // namespace ui
