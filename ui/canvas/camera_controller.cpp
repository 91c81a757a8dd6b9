#include "ui/canvas/camera_controller.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ui {

namespace {

constexpr double kWheelPixels = 60.0;  // a notch pans as far
constexpr double kWheelNotch = 120.0;  // QWheelEvent: eighths of a degree, 15 degrees a notch
constexpr double kArrowPixels = 40.0;  // an arrow key moves as much as a drag of this length

bool isUse(QEvent::Type type) {
    return type == QEvent::MouseButtonPress || type == QEvent::Wheel || type == QEvent::ShortcutOverride;
}

/// A part of the board that is shown fills this much of the canvas, so that its surroundings are seen.
constexpr float kShownPart = 0.8F;
constexpr float kSmallestShownMm = 1.0F;  // half of what is seen, across
constexpr int kSeenRows = 24;             // of places where the board is looked for

}  // namespace

void CameraController::setViewport(QSizeF size, double pixelRatio) {
    m_viewport = size.expandedTo({1.0, 1.0});
    m_pixelRatio = pixelRatio;
    if (m_isFitted) {
        fit();
        return;
    }
    if (m_restored && m_camera.pose() == m_restored->taken) {
        seeAsMuch();
    }
    emit moved();
}

void CameraController::setBox(const glm::vec3& boxMin, const glm::vec3& boxMax) {
    m_boxMin = boxMin;
    m_boxMax = boxMax;
    if (m_isFitted) {
        fit();
    }
}

void CameraController::setMargins(const QMarginsF& margins) {
    m_margins = margins;
    if (m_isFitted) {
        fit();
    }
}

/// `place` is for a canvas of the aspect that is left; the camera then steps back and aside until the whole canvas has
/// it there.
template <class Place>
void CameraController::placeInMargins(const Place& place) {
    const QSizeF room = m_viewport.shrunkBy(m_margins).expandedTo({1.0, 1.0});
    place(static_cast<float>(room.width() / room.height()));
    if (!m_margins.isNull()) {
        m_camera.zoom(static_cast<float>(room.height() / m_viewport.height()), {0.0F, 0.0F}, aspect());
        m_camera.pan({static_cast<float>(m_margins.left() - m_margins.right()) / 2.0F,
                      static_cast<float>(m_margins.top() - m_margins.bottom()) / 2.0F},
                     height());
    }
}

void CameraController::fit() {
    placeInMargins([&](float aspect) { m_camera.fit(m_boxMin, m_boxMax, aspect); });
    m_isFitted = true;
    emit moved();
}

void CameraController::look(render::NamedView view) {
    placeInMargins([&](float aspect) { m_camera.fit(m_boxMin, m_boxMax, view, aspect); });
    m_isFitted = true;
    emit moved();
}

void CameraController::lookAtSide(render::NamedView side) {
    const bool isFromTop = m_camera.direction().z < 0.0F;
    const bool isOther = isFromTop != (side == render::NamedView::Top);
    m_isPlan && !m_isFitted && isOther ? flip() : look(side);
}

void CameraController::setPlan() {
    m_isPlan = true;
    m_camera.setOrthographic(true);
    look(render::NamedView::Top);
}

void CameraController::flip() {
    m_camera.flipOver();
    m_isFitted ? fit() : emit moved();  // margins stay where they are
}

void CameraController::lookFrom(const glm::vec3& side) {
    if (!m_isFitted) {
        focusAt(centre());
    }
    const glm::vec3 along = -glm::normalize(side);
    render::CameraPose pose = m_camera.pose();
    pose.pitch = std::asin(along.z);
    // From straight above and below the other named views say what is up.
    const bool isUpright = side.x == 0.0F && side.y == 0.0F;
    pose.yaw = !isUpright ? std::atan2(along.x, along.y) : side.z > 0.0F ? 0.0F : std::numbers::pi_v<float>;
    m_camera.setPose(pose);
    m_isFitted ? fit() : emit moved();
}

void CameraController::orbit(QPointF pixels) {
    focusAt(centre());
    orbitBy(pixels);
}

void CameraController::show(const glm::vec3& boxMin, const glm::vec3& boxMax) {
    const glm::vec3 middle = (boxMin + boxMax) / 2.0F;
    const glm::vec3 half = glm::max((boxMax - boxMin) / 2.0F / (kShownPart * render::Camera::kMargin),
                                    glm::vec3(glm::vec2(kSmallestShownMm), 0.0F));
    placeInMargins([&](float aspect) { m_camera.show(middle - half, middle + half, aspect); });
    announceUserMove();
}

void CameraController::setOrthographic(bool isOrthographic) {
    m_camera.setOrthographic(isOrthographic);
    emit moved();
}

void CameraController::lift(float mm) {
    if (!m_isFitted && mm != 0.0F) {
        render::CameraPose pose = m_camera.pose();
        pose.target.z += mm;
        m_camera.setPose(pose);
        emit moved();
    }
}

void CameraController::place(const render::CameraPose& pose) {
    m_camera.setPose(pose);
    if (m_isPlan) {
        const bool isFromBelow = pose.pitch > 0.0F;
        render::CameraPose straight = pose;
        straight.yaw = isFromBelow ? std::numbers::pi_v<float> : 0.0F;
        straight.pitch = std::numbers::pi_v<float> * (isFromBelow ? 0.5F : -0.5F);
        straight.isOrthographic = true;
        m_camera.setPose(straight);
    }
}

void CameraController::setPose(const render::CameraPose& pose) {
    place(pose);
    announceUserMove();
}

void CameraController::restore(const render::CameraPose& pose, float aspect) {
    m_restored = Restored{pose, aspect, pose};
    seeAsMuch();
    announceUserMove();
}

void CameraController::seeAsMuch() {
    render::CameraPose pose = m_restored->pose;
    pose.distance *= std::max(m_restored->aspect / aspect(), 1.0F);
    place(pose);
    m_restored->taken = m_camera.pose();
}

void CameraController::zoomAt(QPointF position, float factor) {
    const QPointF pivot = pivotAt(position);
    m_camera.zoom(factor, ndcOf(pivot), aspect());
    announceUserMove();
}

/// The point of the canvas that a zoom keeps; the camera is focused on what is there.
QPointF CameraController::pivotAt(QPointF position) {
    if (boardPointAt(position)) {
        focusAt(position);
        return position;
    }
    const auto [from, along] = rayAt(position);
    const glm::vec3 middle = (m_boxMin + m_boxMax) / 2.0F;
    const float way = glm::dot(middle - from, m_camera.direction()) / glm::dot(along, m_camera.direction());
    const glm::vec3 nearest = glm::clamp(from + along * way, m_boxMin, m_boxMax);
    std::optional<QPointF> onCanvas = screenOf(nearest);
    if (!onCanvas || !QRectF({}, m_viewport).contains(*onCanvas)) {
        onCanvas = nearestSeen(position);
        focusAt(onCanvas.value_or(position));
        return onCanvas.value_or(position);  // the latter: nothing of the board is in sight
    }
    m_camera.focusOn(nearest);
    return *onCanvas;
}

/// Of the places of a grid over the canvas where the board is seen, the one nearest to `position`.
std::optional<QPointF> CameraController::nearestSeen(QPointF position) const {
    const auto farness = [position](QPointF p) { return std::hypot(p.x() - position.x(), p.y() - position.y()); };
    std::optional<QPointF> nearest;
    for (int row = 0; row <= kSeenRows; ++row) {
        for (int column = 0; column <= kSeenRows; ++column) {
            const QPointF at(m_viewport.width() * column / kSeenRows, m_viewport.height() * row / kSeenRows);
            if ((!nearest || farness(at) < farness(*nearest)) && boardPointAt(at)) {
                nearest = at;
            }
        }
    }
    return nearest;
}

void CameraController::zoomToBox(QPointF from, QPointF to) {
    const QPointF way = to - from;
    const double ratio = std::min(m_viewport.width() / std::max(std::abs(way.x()), 1.0),
                                  m_viewport.height() / std::max(std::abs(way.y()), 1.0));
    const bool isInto = way.x() > 0.0 && way.y() > 0.0;
    panBy(centre() - (from + to) / 2.0);
    focusAt(centre());
    m_camera.zoom(static_cast<float>(isInto ? ratio : 1.0 / ratio), {0.0F, 0.0F}, aspect());
    announceUserMove();
}

glm::vec2 CameraController::ndcOf(QPointF position) const {
    return {static_cast<float>(2.0 * position.x() / m_viewport.width() - 1.0),
            static_cast<float>(1.0 - 2.0 * position.y() / m_viewport.height())};
}

CameraController::Ray CameraController::rayAt(QPointF position) const {
    const glm::mat4 toBoard = glm::inverse(clipFromBoard());
    const glm::vec2 ndc = ndcOf(position);
    const auto at = [&](float depth) {  // y down and depth reversed, as the projection has them
        const glm::vec4 p = toBoard * glm::vec4(ndc.x, -ndc.y, depth, 1.0F);
        return glm::vec3(p) / p.w;
    };
    const glm::vec3 from = at(1.0F);
    return {from, at(0.5F) - from};
}

std::optional<QPointF> CameraController::screenOf(const glm::vec3& point) const {
    const glm::vec4 clip = clipFromBoard() * glm::vec4(point, 1.0F);
    if (clip.w <= 0.0F) {
        return std::nullopt;
    }
    return QPointF((clip.x / clip.w + 1.0) / 2.0 * m_viewport.width(),
                   (clip.y / clip.w + 1.0) / 2.0 * m_viewport.height());
}

bool CameraController::seesAll(const render::Camera& camera) const {
    const glm::mat4 clipFromBoard = camera.projection(aspect()) * camera.view();
    for (int corner = 0; corner < 8; ++corner) {
        const auto pick = [&](int axis) { return (corner >> axis & 1) != 0 ? m_boxMax[axis] : m_boxMin[axis]; };
        const glm::vec4 clip = clipFromBoard * glm::vec4(pick(0), pick(1), pick(2), 1.0F);
        if (std::max(std::abs(clip.x), std::abs(clip.y)) > clip.w) {
            return false;
        }
    }
    return true;
}

render::Camera CameraController::cameraForAll() const {
    render::Camera camera = m_camera;
    camera.fit(m_boxMin, m_boxMax, aspect());
    return camera;
}

std::optional<glm::vec3> CameraController::boardPointAt(QPointF position) const {
    const auto [from, along] = rayAt(position);
    const float face = m_camera.direction().z < 0.0F ? m_boxMax.z : m_boxMin.z;
    const float way = (face - from.z) / along.z;
    const glm::vec3 point = from + along * way;
    const bool isInside =
        point.x >= m_boxMin.x && point.x <= m_boxMax.x && point.y >= m_boxMin.y && point.y <= m_boxMax.y;
    // Written so that a line of sight along the face (way is infinite or not a number) misses.
    return way > 0.0F && isInside ? std::optional(point) : std::nullopt;
}

void CameraController::focusAt(QPointF position) {
    if (const std::optional<glm::vec3> point = boardPointAt(position)) {
        m_camera.focusOn(*point);
    }
}

bool CameraController::handle(QEvent& event) {
    if (isUse(event.type())) {
        emit used();
    }
    const auto takes = [&event](const Taker& taker) { return taker(event); };
    if (m_button == Qt::NoButton && std::ranges::any_of(m_takers, takes)) {
        return true;
    }
    return dispatch(event);
}

bool CameraController::dispatch(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress: return press(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonDblClick: return doubleClick(static_cast<const QMouseEvent&>(event));
        case QEvent::Leave: emit left(); return false;
        case QEvent::MouseMove: return move(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonRelease: return release(static_cast<const QMouseEvent&>(event));
        case QEvent::Wheel: return wheel(static_cast<const QWheelEvent&>(event));
        case QEvent::ShortcutOverride: return keepKey(static_cast<QKeyEvent&>(event));
        case QEvent::KeyPress: return key(static_cast<const QKeyEvent&>(event));
        default: return false;
    }
}

/// What a drag with this button and these modifiers is.
CameraController::Drag CameraController::kindOf(const QMouseEvent& event) const {
    const bool isShifted = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool isRight = event.button() == Qt::RightButton;
    if (isRight && m_isPlan && m_habits.rightDragZooms && !isShifted) {
        return Drag::ZoomBox;
    }
    if (isRight && !m_isPlan && m_habits.shiftRightDragOrbits && isShifted) {
        return Drag::Orbit;
    }
    if (event.button() != Qt::LeftButton || isShifted) {
        return Drag::Pan;
    }
    return m_isPlan ? Drag::Box : Drag::Orbit;
}

bool CameraController::press(const QMouseEvent& event) {
    if (m_button != Qt::NoButton) {
        return true;  // one drag at a time: a second button does not disturb the first
    }
    m_button = event.button();
    m_pressed = m_last = event.position();
    m_drag = Drag::Undecided;
    m_dragKind = kindOf(event);
    // A pan keeps the board under the cursor; an orbit turns about what is in the middle of the canvas.
    if (m_dragKind == Drag::Pan || m_dragKind == Drag::Orbit) {
        focusAt(m_dragKind == Drag::Pan ? m_pressed : centre());
    }
    return true;
}

/// Windows get the second press as a press too, widgets do not.
bool CameraController::doubleClick(const QMouseEvent& event) {
    m_drag = Drag::None;
    m_button = Qt::NoButton;
    if (event.button() == Qt::LeftButton) {
        emit doubleClicked(event.position(), event.modifiers());
    }
    return true;
}

bool CameraController::move(const QMouseEvent& event) {
    if (m_drag == Drag::None) {
        emit hovered(event.position());
        return false;
    }
    if (m_drag == Drag::Undecided) {
        const QPointF way = event.position() - m_pressed;
        if (std::hypot(way.x(), way.y()) < kClickPixels) {
            return true;
        }
        m_drag = m_dragKind;
    }
    const QPointF step = event.position() - m_last;
    if (m_drag == Drag::Pan) {
        m_last += panBy(step);  // the rest comes with the next move
        return true;
    }
    m_last = event.position();
    switch (m_drag) {
        case Drag::Orbit: orbitBy(step); break;
        default: emit boxDrawn(m_pressed, m_last); break;
    }
    return true;
}

bool CameraController::release(const QMouseEvent& event) {
    if (event.button() != m_button) {
        return false;
    }
    const Drag drag = std::exchange(m_drag, Drag::None);
    const Qt::MouseButton button = std::exchange(m_button, Qt::NoButton);
    if (drag == Drag::Box) {
        emit boxFinished(m_pressed, event.position(), event.modifiers());
    } else if (drag == Drag::ZoomBox) {
        zoomToBox(m_pressed, event.position());
        emit zoomedToBox();
    }
    if (drag == Drag::Undecided && button == Qt::LeftButton) {
        emit clicked(m_pressed, event.modifiers());
    } else if (drag == Drag::Undecided && button == Qt::RightButton) {
        emit menuRequested(m_pressed);
    }
    return true;
}

bool CameraController::wheel(const QWheelEvent& event) {
    const QPoint angle = event.angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / kWheelNotch;  // some systems swap them with Shift
    if (notches == 0.0) {
        return false;
    }
    switch (moveOf(event)) {
        case WheelMove::Zoom: zoomAt(event.position(), std::pow(kZoomPerNotch, static_cast<float>(notches))); break;
        case WheelMove::UpAndDown: panBy({0.0, notches * kWheelPixels}); break;
        case WheelMove::Sideways: panBy({notches * kWheelPixels, 0.0}); break;
    }
    return true;
}

WheelMove CameraController::moveOf(const QWheelEvent& event) const {
    const bool isShifted = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool isControlled = event.modifiers().testFlag(Qt::ControlModifier);
    const bool isTilted = event.angleDelta().y() == 0 && !isShifted && !isControlled;  // or two fingers sideways
    return isTilted       ? WheelMove::Sideways
           : isShifted    ? m_habits.shiftWheel
           : isControlled ? m_habits.ctrlWheel
                          : WheelMove::Zoom;
}

bool CameraController::givesUpBox(const QKeyEvent& event) const {
    return event.key() == Qt::Key_Escape && (m_drag == Drag::Box || m_drag == Drag::ZoomBox);
}

/// Esc is no command while a box is drawn.
bool CameraController::keepKey(QKeyEvent& event) const {
    const bool isOwn = givesUpBox(event);
    event.setAccepted(isOwn || event.isAccepted());
    return isOwn;
}

bool CameraController::key(const QKeyEvent& event) {
    if (givesUpBox(event)) {
        m_drag = Drag::None;  // the button is still down, and its release means nothing
        emit boxGivenUp();
        return true;
    }
    if ((event.modifiers() & (Qt::AltModifier | Qt::ControlModifier)) != 0) {
        return false;  // a command's
    }
    QPointF way;
    switch (event.key()) {
        case Qt::Key_Left: way = {-kArrowPixels, 0.0}; break;
        case Qt::Key_Right: way = {kArrowPixels, 0.0}; break;
        case Qt::Key_Up: way = {0.0, -kArrowPixels}; break;
        case Qt::Key_Down: way = {0.0, kArrowPixels}; break;
        default: return false;
    }
    // The arrow says where the viewer goes, a drag where the board goes.
    if (m_isPlan || event.modifiers().testFlag(Qt::ShiftModifier)) {
        panBy(-way);
    } else {
        orbitBy(-way);
    }
    return true;
}

void CameraController::orbitBy(QPointF pixels) {
    // Half a turn across the height of the canvas; the surface under the cursor follows it.
    const double radPerPixel = std::numbers::pi / m_viewport.height();
    m_camera.orbit(static_cast<float>(pixels.x() * radPerPixel), static_cast<float>(-pixels.y() * radPerPixel));
    announceUserMove();
}

/// By how far the board moved.
QPointF CameraController::panBy(QPointF pixels) {
    const auto whole = [this](double x) { return m_isPlan ? std::round(x * m_pixelRatio) / m_pixelRatio : x; };
    const QPointF way(whole(pixels.x()), whole(pixels.y()));
    m_camera.pan({static_cast<float>(way.x()), static_cast<float>(way.y())}, height());
    announceUserMove();
    return way;
}

void CameraController::announceUserMove() {
    m_isFitted = false;
    emit moved();
}

}  // namespace ui
