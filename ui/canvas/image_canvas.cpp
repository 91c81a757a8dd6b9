#include "ui/canvas/image_canvas.h"

#include <QPainter>
#include <QResizeEvent>

#include "model/base/stopwatch.h"

namespace ui {

namespace {

/// A frame at 60 Hz has room for this much drawing of tiles, and a hand that moves on is answered after a piece.
constexpr double kTilesMs = 6.0;
constexpr double kPieceMs = 8.0;
constexpr int kRestMs = 40;

}  // namespace

ImageCanvas::ImageCanvas(GpuContext& context, CameraController& controller, const Picture& picture, QWidget* parent)
    : QWidget(parent), m_context(context), m_controller(controller), m_picture(picture) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_refine.setSingleShot(true);
    connect(&m_refine, &QTimer::timeout, this, &ImageCanvas::refine);
}

void ImageCanvas::refine() {
    if (m_picture.flat == nullptr) {
        return;
    }
    if (m_picture.flat->refine(kPieceMs)) {
        requestFrame();
    } else {
        m_refine.start(0);
    }
}

bool ImageCanvas::drawWithoutDevice(QSize pixels) {
    using Quality = render::FlatPicture::Quality;
    const base::Stopwatch watch;
    if (m_picture.flat == nullptr || m_picture.scene == nullptr || pixels.isEmpty()) {
        return false;
    }
    if (m_image.size() != pixels || m_image.format() != QImage::Format_RGB32) {
        m_image = QImage(pixels, QImage::Format_RGB32);
    }
    const Quality quality = drawFlat(m_picture, m_controller.camera(), kTilesMs, m_image);
    if (quality == Quality::None) {
        return false;
    }
    m_presenter.reset();  // the board that it may have cached is another one now
    render::FrameStats stats;
    stats.isOverlayAlone = m_picture.paintOver(m_image);
    stats.backend = render::Backend::Auto;
    stats.cpuMs = watch.milliseconds();
    if (quality == Quality::Rough) {
        m_refine.start(kRestMs);
    }
    emit drawn();
    emit timed(stats);
    return true;
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
    m_refine.stop();
    if (m_context.device().isLost()) {
        emit deviceLost();
        return;
    }
    if (drawWithoutDevice(pixels)) {
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
