#include "ui/canvas/image_canvas.h"

#include <QColor>
#include <QPainter>
#include <QResizeEvent>
#include <utility>

#include "model/base/stopwatch.h"

namespace ui {

namespace {

using Pixels = render::FlatPicture::Pixels;

/// A frame at 60 Hz has room for this much drawing of tiles, and a hand that moves on is answered after a piece.
constexpr double kTilesMs = 4.0;
constexpr double kPieceMs = 8.0;
constexpr int kRestMs = 40;
constexpr int kLongRestMs = 200;
constexpr int kWholeShare = 2;  // a picture of all of the board is so many times smaller
constexpr double kMuchDrawnOut = 1.6;

/// No copy: the image holds the pixels.
QImage imageOf(std::shared_ptr<const Pixels> pixels, QSize size) {
    auto* owner = new std::shared_ptr<const Pixels>(std::move(pixels));
    return QImage(
        reinterpret_cast<const uchar*>((*owner)->data()), size.width(), size.height(),
        static_cast<qsizetype>(size.width()) * 4, QImage::Format_RGB32,
        [](void* held) { delete static_cast<std::shared_ptr<const Pixels>*>(held); }, owner);
}

glm::ivec2 vectorOf(QSize size) {
    return {size.width(), size.height()};
}

}  // namespace

ImageCanvas::ImageCanvas(GpuContext& context, CameraController& controller, const Picture& picture, QWidget* parent)
    : QWidget(parent), m_context(context), m_controller(controller), m_picture(picture), m_device(context, picture) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_goOn.setSingleShot(true);
    connect(&m_goOn, &QTimer::timeout, this, &ImageCanvas::goOn);
    connect(&m_device, &DevicePicture::done, this, [this] {
        m_isShotNew = true;
        m_isStale = true;
        update();
    });
    connect(&m_device, &DevicePicture::deviceLost, this, &ImageCanvas::deviceLost);
}

void ImageCanvas::releaseDevice() {
    m_device.release();
    clear();
}

void ImageCanvas::clear() {
    m_device.clear();
    m_image = {};
    m_isDue = true;
    m_isShotNew = false;
    m_isWholeDue = true;
    requestFrame();
}

void ImageCanvas::goOn() {
    if (!m_isByTiles) {
        prepareWhole();
        return;
    }
    if (m_picture.flat == nullptr) {
        return;
    }
    const bool isDone = m_isExact ? m_picture.flat->prepare(kPieceMs) : m_picture.flat->refine(kPieceMs);
    if (!isDone) {
        m_goOn.start(0);
    } else if (!m_isExact) {
        m_isStale = true;
        m_isDue = true;
        update();
    }
}

void ImageCanvas::requestFrame() {
    m_isAsked = true;
    m_isStale = true;
    update();
}

bool ImageCanvas::event(QEvent* event) {
    return m_controller.handle(*event) || QWidget::event(event);
}

void ImageCanvas::resizeEvent(QResizeEvent* event) {
    m_isStale = true;
    m_controller.setViewport(event->size(), devicePixelRatioF());
}

void ImageCanvas::paintEvent(QPaintEvent*) {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (m_isStale || m_image.size() != pixels) {
        draw(pixels);
    }
    QPainter painter(this);
    painter.drawImage(rect(), m_image);
    m_picture.paintOver(painter);
}

void ImageCanvas::draw(QSize pixels) {
    m_isStale = false;
    if (m_context.device().isLost()) {
        emit deviceLost();
        return;
    }
    const bool isBoardSame = m_picture.isBoardSame();
    m_isDue = m_isDue || !isBoardSame || m_image.size() != pixels;
    if (drawTiles(pixels)) {
        return;
    }
    drawByDevice(pixels);
}

void ImageCanvas::announce(const render::FrameStats& stats) {
    emit drawn();
    emit timed(stats);
}

/// False: this is for the device.
bool ImageCanvas::drawTiles(QSize pixels) {
    using Quality = render::FlatPicture::Quality;
    if (m_picture.flat == nullptr || (!m_isDue && !m_isByTiles)) {
        return false;
    }
    render::FrameStats stats;
    stats.isOverlayAlone = !m_isDue;
    if (m_isDue) {
        const base::Stopwatch watch;
        m_goOn.stop();
        const Quality quality = drawFlat(m_picture, m_controller.camera(), pixels, kTilesMs);
        m_isByTiles = quality != Quality::None;
        if (!m_isByTiles) {
            return false;
        }
        m_image = imageOf(m_picture.flat->pixels(), pixels);
        m_isDue = false;
        m_isExact = quality == Quality::Exact;
        stats.isPartial = m_picture.flat->isPartial();
        m_goOn.start(m_isExact ? kLongRestMs : stats.isPartial ? 0 : kRestMs);
        stats.cpuMs = watch.milliseconds();
    }
    announce(stats);
    return true;
}

void ImageCanvas::drawByDevice(QSize pixels) {
    if (m_picture.scene == nullptr) {
        fill(pixels);
        m_isDue = false;
        announce({});
        return;
    }
    m_isByTiles = false;
    const Warped before = warped(pixels);
    m_picture.preparePlane(pixels);
    const bool isPlaneShown = !m_picture.inPlane.isNull();
    if (std::exchange(m_isPlaneShown, isPlaneShown) != isPlaneShown) {
        m_isDue = true;  // nobody asks for a frame of the board when a map comes or goes
    }
    bool isNew = std::exchange(m_isShotNew, false);
    bool isAwaited = false;  // what is shown stays until the device is done
    // What the pointer moves over a map asks for no frame of the board, but for one of the map. A shot that came says
    // nothing of it: it may be older than what the map is now.
    const bool isPlaneDue = std::exchange(m_isAsked, false) && isPlaneShown;
    const bool isPostponed = isCoarse() && before.isNear;
    if ((m_isDue && !isPostponed) || isPlaneDue) {
        m_goOn.stop();
        m_isWholeDue = m_isWholeDue || m_isDue;
        const bool isBoardSame = !std::exchange(m_isDue, false);
        isNew = m_device.request(m_controller.camera(), pixels, isBoardSame) || isNew;
        isAwaited = !isNew && m_image.size() == pixels && m_shown == m_controller.camera().pose();
    }
    if (isNew) {
        keepFirstWhole(pixels);
    }
    if (!isAwaited) {
        showShot(isNew ? warped(pixels) : before, pixels, isNew);
    }
    if (!isCoarse() && !m_device.isUnderWay() && m_isWholeDue) {
        m_goOn.start(kLongRestMs);
    }
}

/// While the view moves.
bool ImageCanvas::isCoarse() const {
    return m_picture.settings.levels == render::LevelOfDetail::Coarse;
}

/// Once the view rests: for what comes into sight when it moves.
void ImageCanvas::prepareWhole() {
    if (m_picture.scene == nullptr || m_device.isUnderWay() || !std::exchange(m_isWholeDue, false)) {
        return;
    }
    if (m_controller.seesAll(m_device.shot().camera)) {
        m_device.keepAsWhole();
    } else {
        m_device.requestWhole(m_controller.cameraForAll(), m_image.size() / kWholeShare);
    }
}

/// While the view moves a picture of all of the board stays, unless it is of the other face: it may be seen less from
/// the side than what comes next.
void ImageCanvas::keepFirstWhole(QSize pixels) {
    const DevicePicture::Shot& shot = m_device.shot();
    if (!shot.image.isNull() && !warpedShot(m_device.whole(), pixels) && m_controller.seesAll(shot.camera)) {
        m_device.keepAsWhole();
    }
}

std::optional<render::WarpedPicture> ImageCanvas::warpedShot(const DevicePicture::Shot& shot, QSize pixels) const {
    const render::Camera& camera = m_controller.camera();
    const float face = camera.direction().z < 0.0F ? m_picture.faces.y : m_picture.faces.x;
    const auto seenBy = [face](const render::Camera& by, QSize size) {
        const float aspect = static_cast<float>(size.width()) / static_cast<float>(size.height());
        return render::clipFromPlane(by.projection(aspect) * by.view(), face);
    };
    if (shot.image.isNull() || pixels.isEmpty()) {
        return std::nullopt;
    }
    const render::WarpSource source{reinterpret_cast<const std::uint32_t*>(shot.image.constBits()),
                                    vectorOf(shot.image.size()), seenBy(shot.camera, shot.image.size())};
    return render::WarpedPicture::make(source, seenBy(camera, pixels), vectorOf(pixels));
}

/// A picture along the board makes walls of its edges when it is seen from above: then one of all of it is better.
ImageCanvas::Warped ImageCanvas::warped(QSize pixels) const {
    const std::optional<render::WarpedPicture> shot = warpedShot(m_device.shot(), pixels);
    const std::optional<render::WarpedPicture> whole = warpedShot(m_device.whole(), pixels);
    const bool isDrawnOut = shot && whole && shot->stretch() > kMuchDrawnOut && whole->stretch() < shot->stretch();
    if (!shot || isDrawnOut) {
        return {whole, std::nullopt, false};
    }
    return {shot, whole, shot->isNear()};
}

/// Shows the last picture of the device, as it is or warped, and says whether it is another one than before.
void ImageCanvas::showShot(const Warped& warped, QSize pixels, bool isNew) {
    const DevicePicture::Shot& shot = m_device.shot();
    const render::CameraPose& pose = m_controller.camera().pose();
    render::FrameStats stats;
    stats.isOverlayAlone = m_shown == pose;
    if (shot.image.size() == pixels && shot.camera.pose() == pose) {
        m_image = shot.image;
        if (isNew && !m_device.isUnderWay()) {
            stats = shot.stats;
        }
        m_shown = pose;
    } else if (warped.best) {
        const auto count = static_cast<std::size_t>(pixels.width()) * static_cast<std::size_t>(pixels.height());
        if (m_warped == nullptr || m_warped->size() != count) {
            m_warped = std::make_shared<Pixels>(count);
        }
        warped.best->paint(ground(), warped.rest ? &*warped.rest : nullptr, m_warped->data());
        m_image = imageOf(m_warped, pixels);
        m_shown = pose;
    } else {
        stats.isOverlayAlone = true;  // the picture of before stays
        if (m_image.size() != pixels) {
            fill(pixels);
        }
    }
    announce(stats);
}

std::uint32_t ImageCanvas::ground() const {
    const glm::vec3& colour = m_picture.settings.background;
    return QColor::fromRgbF(colour.r, colour.g, colour.b).rgb();
}

void ImageCanvas::fill(QSize pixels) {
    m_image = QImage(pixels, QImage::Format_RGB32);
    m_image.fill(ground());
}

}  // namespace ui
