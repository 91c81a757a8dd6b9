#include "ui/views/board_view.h"

#include <QGuiApplication>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "render/scene/explosion.h"
#include "ui/canvas/image_canvas.h"
#include "ui/canvas/view_picture.h"
#include "ui/canvas/vulkan_canvas.h"

namespace ui {

namespace {

constexpr double kSlowMs = 50.0;  // 20 frames a second: below that a drag feels sticky
constexpr int kRestMs = 250;
constexpr std::uint64_t kPatienceNs = 1'000'000'000;

/// As frames are while a slow view moves.
void setCoarse(render::ViewSettings& settings, bool isCoarse) {
    settings.isSmoothed = !isCoarse;
    settings.levels = isCoarse ? render::LevelOfDetail::Coarse : render::LevelOfDetail::Error;
}

}  // namespace

BoardView::BoardView(GpuContext& context, Kind kind, QWidget* parent)
    : QWidget(parent), m_context(context), m_kind(kind) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    setMinimumSize(160, 120);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &BoardView::requestRestingFrame);
    connect(&m_controller, &CameraController::moved, this, &BoardView::requestMovingFrame);
    m_picture.settings.cachesBoard = true;
    m_picture.prepare = [this](QSize pixels) {
        m_picture.settings.isBoardCached = std::exchange(m_isBoardDrawn, true);
        paintOverlay(pixels);
    };
    m_picture.isBoardSame = [this] { return std::exchange(m_isBoardDrawn, true); };
    m_picture.preparePlane = [this](QSize pixels) { paintPlane(pixels); };
    m_picture.paintOver = [this](QPainter& painter) {
        painter.setRenderHint(QPainter::Antialiasing);
        paintAll(painter, Shown::OnCanvas);
    };
    if (kind == Kind::Flat) {
        m_picture.settings.is2d = true;
        m_controller.setPlan();
    }
    m_picture.settings.isFabricated = kind == Kind::Solid;
    takeCanvas();
}

BoardView::~BoardView() {
    delete m_container;  // as a child it would go after the members that its canvas works on
}

void BoardView::takeCanvas() {
    const bool isPresented = m_context.surfaceInstance() != nullptr && !m_context.device().caps().isCpu;
    if (isPresented && m_window == nullptr) {
        showVulkanCanvas();
    } else if (!isPresented && m_image == nullptr) {
        showImageCanvas();
    }
}

void BoardView::showVulkanCanvas() {
    m_image = nullptr;
    m_window = new VulkanCanvas(m_context, m_controller, m_picture);
    connect(m_window, &VulkanCanvas::drawn, this, &BoardView::drawn);
    connect(m_window, &VulkanCanvas::timed, this, &BoardView::onTimed);
    connect(m_window, &VulkanCanvas::deviceLost, this, &BoardView::deviceLost, Qt::QueuedConnection);
    connect(m_window, &VulkanCanvas::unusable, this, &BoardView::showImageCanvas, Qt::QueuedConnection);
    replaceCanvas(QWidget::createWindowContainer(m_window));
}

void BoardView::showImageCanvas() {
    m_window = nullptr;
    m_image = new ImageCanvas(m_context, m_controller, m_picture);
    connect(m_image, &ImageCanvas::drawn, this, &BoardView::drawn);
    connect(m_image, &ImageCanvas::timed, this, &BoardView::onTimed);
    connect(m_image, &ImageCanvas::deviceLost, this, &BoardView::deviceLost, Qt::QueuedConnection);
    replaceCanvas(m_image);
    if (m_kind == Kind::Solid) {
        m_image->makeReady();
    }
}

void BoardView::replaceCanvas(QWidget* canvas) {
    delete m_container;
    m_container = canvas;
    canvas->setFocusPolicy(Qt::StrongFocus);
    layout()->addWidget(canvas);
    setFocusProxy(canvas);
}

void BoardView::setScene(render::BoardScene* scene, std::vector<render::LayerStyle> styles) {
    m_picture.scene = scene;
    m_picture.styles = std::move(styles);
    m_isSlow = false;
    if (m_image != nullptr) {
        m_image->clear();
    }
    requestRestingFrame();
}

void BoardView::setModel(std::shared_ptr<const render::BoardModel> model) {
    const bool isDrawnHere = m_kind == Kind::Flat && model != nullptr && m_context.device().caps().isCpu;
    if (m_image != nullptr) {
        m_image->clear();
    }
    auto next = isDrawnHere ? std::make_shared<render::FlatPicture>(std::move(model)) : nullptr;
    if (auto before = std::exchange(m_picture.flat, std::move(next))) {
        m_freeing.start([before = std::move(before)](base::Progress&) mutable { before.reset(); }, "");
    }
}

void BoardView::setStyles(std::vector<render::LayerStyle> styles) {
    m_picture.styles = std::move(styles);
    requestFrame();
}

std::vector<render::ZRange> BoardView::drawnHeights() const {
    if (m_picture.scene == nullptr) {
        return {};
    }
    return m_picture.scene->drawnHeights(m_picture.frameSettings());
}

float BoardView::drawnFaces() const {
    return m_picture.scene != nullptr ? m_picture.scene->drawnFaces(m_picture.frameSettings()) : 0.0F;
}

float BoardView::seenFace(const model::Document& board) const {
    const std::vector<render::ZRange> heights = drawnHeights();
    const bool isFromBelow = m_controller.camera().direction().z > 0.0F;
    std::optional<float> face;
    for (std::size_t row = 0; row < std::min(heights.size(), board.layers.size()); ++row) {
        if (board.layers[row].isCopper()) {
            const float height = isFromBelow ? heights[row].z0 : heights[row].z1;
            face = !face ? height : isFromBelow ? std::min(*face, height) : std::max(*face, height);
        }
    }
    return face.value_or(0.0F);
}

void BoardView::setOutlined(bool isOn) {
    m_picture.settings.isOutlined = isOn;
    requestFrame();
}

template <class Paint>
void BoardView::paintOn(QImage& image, QSize pixels, const Paint& paint) const {
    if (image.size() != pixels) {
        image = QImage(pixels, QImage::Format_RGBA8888_Premultiplied);
    }
    image.fill(Qt::transparent);
    QPainter painter(&image);
    scaleToLogical(painter, pixels);
    paint(painter);
}

void BoardView::scaleToLogical(QPainter& painter, QSize pixels) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(pixels.width() / m_controller.viewport().width(), pixels.height() / m_controller.viewport().height());
}

void BoardView::paintAll(QPainter& painter, Shown where) const {
    for (const auto& [paint, shown] : m_painters) {
        if (where == Shown::OnCanvas || shown == Shown::Everywhere) {
            painter.save();
            paint(painter);
            painter.restore();
        }
    }
}

std::vector<QRectF> BoardView::corners() const {
    std::vector<QRectF> places;
    for (const auto& place : m_corners) {
        if (const QRectF at = place(); !at.isEmpty()) {
            places.push_back(at);
        }
    }
    return places;
}

void BoardView::setPlanePainter(Painter painter, std::function<std::optional<float>()> height) {
    if (m_kind == Kind::Flat) {
        addGroundPainter(std::move(painter));
        return;
    }
    m_planePainter = std::move(painter);
    m_planeHeight = std::move(height);
}

void BoardView::paintPlane(QSize pixels) {
    if (const std::optional<float> height = planeHeight()) {
        m_picture.planeZ = *height;
        paintOn(m_picture.inPlane, pixels, m_planePainter);
    } else {
        m_picture.inPlane = {};
    }
}

void BoardView::paintOverlay(QSize pixels) {
    paintPlane(pixels);
    if (m_painters.empty()) {
        m_picture.overlay = {};
        return;
    }
    paintOn(m_picture.overlay, pixels, [&](QPainter& painter) { paintAll(painter, Shown::OnCanvas); });
}

base::Box BoardView::boxBetween(QPointF from, QPointF to) const {
    const auto clamp = [](double v) {
        return static_cast<base::Nm>(std::clamp<double>(v, -base::kMaxCoordinate, base::kMaxCoordinate));
    };
    base::Box box;
    for (const QPointF corner : {from, to}) {
        const base::PointD location = locationAt(corner);
        box.include(base::Point{clamp(location.x), clamp(location.y)});
    }
    return box;
}

void BoardView::setBoard(const glm::vec3& boxMin, const glm::vec3& boxMax) {
    m_boxMin = boxMin;
    m_boxMax = boxMax;
    updateBox();
}

void BoardView::setBackend(render::Backend backend) {
    m_picture.settings.backend = backend;
    requestFrame();
}

void BoardView::setFabricated(bool isOn) {
    m_picture.settings.isFabricated = isOn;
    requestFrame();
}

void BoardView::setExplode(float explode) {
    m_picture.settings.explode = explode;
    updateBox();
    requestMovingFrame();
}

void BoardView::setZScale(const render::ZScale& scale) {
    m_picture.settings.zScale = scale;
    requestFrame();
}

void BoardView::setCut(std::shared_ptr<const render::SectionCut> cut) {
    m_picture.settings.section = std::move(cut);
    requestMovingFrame();
}

void BoardView::updateBox() {
    const render::Box3 box = render::explodedBox({m_boxMin, m_boxMax}, m_picture.settings.explode);
    m_picture.faces = {box.min.z, box.max.z};
    m_controller.setBox(box.min, box.max);
}

void BoardView::requestFrame() {
    m_isBoardDrawn = false;
    requestOverlay();
}

void BoardView::requestFrameAtRest() {
    if (m_isSlow) {
        m_rest.start();
        requestOverlay();
    } else {
        requestFrame();
    }
}

void BoardView::requestOverlay() {
    if (m_window != nullptr) {
        m_window->requestUpdate();
    } else if (m_image != nullptr) {
        m_image->requestFrame();
    }
}

void BoardView::requestMovingFrame() {
    if (m_isSlow) {
        setCoarse(m_picture.settings, true);
        m_rest.start();
    }
    requestFrame();
}

void BoardView::requestRestingFrame() {
    setCoarse(m_picture.settings, false);
    requestFrame();
}

void BoardView::onTimed(const render::FrameStats& stats) {
    // What tiles give comes at once, and is refined.
    m_isSlow = m_isSlow || (stats.isByDevice && !stats.isOverlayAlone && std::max(stats.cpuMs, stats.gpuMs) > kSlowMs);
    emit timed(stats);
}

void BoardView::takeKeyboard() {
    setFocus(Qt::ShortcutFocusReason);
    if (m_window != nullptr) {
        m_window->requestActivate();
    }
}

bool BoardView::hasKeyboard() const {
    // To Qt, a window in a window is active with it, whichever of both has the keyboard.
    return m_window != nullptr ? QGuiApplication::focusWindow() == m_window : m_image->hasFocus();
}

QObject& BoardView::canvas() {
    return m_window != nullptr ? static_cast<QObject&>(*m_window) : *m_image;
}

ViewShot BoardView::shot(double scale) const {
    ViewShot shot;
    shot.camera = m_controller.camera();
    shot.pixels = pixelsOf(scale);
    Picture& picture = shot.picture;
    picture.scene = m_picture.scene;
    picture.settings = m_picture.settings;
    setCoarse(picture.settings, false);
    picture.settings.cachesBoard = picture.settings.isBoardCached = false;
    picture.styles = m_picture.styles;
    if (m_picture.scene != nullptr) {
        shot.look.emplace(*m_picture.scene);
    }
    const auto record = [&](const auto& paint) {
        return RecordedPainting::of(shot.pixels, [&](QPainter& painter) {
            scaleToLogical(painter, shot.pixels);
            paint(painter);
        });
    };
    shot.overlay = record([&](QPainter& painter) { paintAll(painter, Shown::Everywhere); });
    if (const std::optional<float> height = planeHeight()) {
        picture.planeZ = *height;
        shot.plane = record(m_planePainter);
    }
    return shot;
}

base::Result<QImage> BoardView::grabPicture(double scale) {
    RETURN_IF_ERROR(ViewPicture::check(pixelsOf(scale), m_context.device()));
    ViewPicture picture(shot(scale), m_context.device());
    picture.prepare();
    RETURN_IF_ERROR(picture.begin());
    ASSIGN_OR_RETURN(bool isDone, picture.isDone());
    while (!isDone) {
        ASSIGN_OR_RETURN(isDone, picture.isDone(kPatienceNs));
    }
    return picture.finish();
}

void BoardView::releaseDevice() {
    if (m_window != nullptr) {
        m_window->releaseDevice();
    } else {
        m_image->releaseDevice();
    }
}

}  // namespace ui
