#include "ui/canvas/image_canvas.h"

#include <QPainter>
#include <QResizeEvent>

namespace ui {

ImageCanvas::ImageCanvas(GpuContext& context, CameraController& controller, const Picture& picture, QWidget* parent)
    : QWidget(parent), m_context(context), m_controller(controller), m_picture(picture) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
}

void ImageCanvas::requestFrame() {
    m_isStale = true;
    update();
}

bool ImageCanvas::event(QEvent* event) {
    return m_controller.handle(*event) || QWidget::event(event);
}

void ImageCanvas::resizeEvent(QResizeEvent* event) {
    m_isStale = true;
    m_controller.setViewport(event->size());
}

void ImageCanvas::paintEvent(QPaintEvent*) {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (m_isStale || m_image.size() != pixels) {
        draw(pixels);
    }
    QPainter(this).drawImage(rect(), m_image);
}

void ImageCanvas::draw(QSize pixels) {
    m_isStale = false;
    if (m_context.device().isLost()) {
        emit deviceLost();
        return;
    }
    if (!m_presenter) {
        m_presenter.emplace(m_context.device());
    }
    m_picture.prepare(pixels);
    base::Result<QImage> image = drawPicture(*m_presenter, m_picture, m_controller.camera(), pixels);
    if (image) {
        m_image = *image;
        emit drawn();
        emit timed(m_presenter->stats());
    } else if (image.error().code == base::ErrorCode::DeviceFailed) {
        m_context.device().markLost();  // or it has no memory left: a device made anew may have
        emit deviceLost();
    }
}

}  // namespace ui
