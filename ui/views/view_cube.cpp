#include "ui/views/view_cube.h"

#include <QMouseEvent>
#include <QPainter>
#include <array>
#include <cmath>

namespace ui {

/// Directions of a face; `right` and `up` as its name is written.
struct ViewCube::Face {
    const char* name;
    Part out;
    Part right;
    Part up;
};

namespace {

constexpr double kSize = 112.0;     // logical pixels: holds the cube however it is turned
constexpr double kMargin = 6.0;     // to the corner of the view
constexpr double kHalf = 31.0;      // half an edge: corners come to 54 pixels from the middle
constexpr double kLeastView = 2.5;  // a view that is not as many times larger than the cube has none
constexpr float kInner = 0.58F;     // of half a face: beyond lie its edges and corners
constexpr float kLegible = 0.25F;   // cosine: a face seen more from the side than this has no name
constexpr QColor kInk(30, 33, 38);
constexpr QColor kRimInk(60, 66, 75, 150);
constexpr QColor kHighlighted(255, 176, 92);

/// -1, 0 or 1: which third of a face, whose middle is larger than the others.
int third(float along) {
    return along < -kInner ? -1 : along > kInner ? 1 : 0;
}

/// Where thirds begin and end.
constexpr std::array<float, 4> kThirds{-1.0F, -kInner, kInner, 1.0F};

}  // namespace

const std::array<ViewCube::Face, 6> ViewCube::kFaces{{{"TOP", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                                      {"BOTTOM", {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
                                                      {"FRONT", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                      {"BACK", {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                                      {"RIGHT", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                      {"LEFT", {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}};

ViewCube::ViewCube(BoardView& view, QObject* parent) : QObject(parent), m_view(view) {
    view.addPainter([this](QPainter& painter) { paint(painter); }, BoardView::Shown::OnCanvas);
    view.addCorner([this] { return place(); });
    view.controller().addTaker([this](QEvent& event) { return take(event); });
}

void ViewCube::setOn(bool isOn) {
    m_isOn = isOn;
    m_hovered.reset();
    m_pressed.reset();
    m_view.requestOverlay();
}

QRectF ViewCube::place() const {
    const QSizeF view = m_view.controller().viewport();
    if (!m_isOn || !m_view.hasScene() || view.width() < kLeastView * kSize || view.height() < kLeastView * kSize) {
        return {};
    }
    return {view.width() - kSize - kMargin, kMargin, kSize, kSize};
}

/// To the right, up, and towards the viewer.
glm::vec3 ViewCube::seen(const glm::vec3& direction) const {
    return glm::mat3(m_view.controller().camera().view()) * direction;
}

QPointF ViewCube::onCanvas(const glm::vec3& point) const {
    const glm::vec3 rotated = seen(point);
    return place().center() + QPointF(rotated.x, -rotated.y) * kHalf;
}

QPointF ViewCube::positionOf(const Part& part) const {
    // The middle of an edge lies on its rim: a little inwards it is on the cube for sure.
    constexpr float kInwards = 0.9F;
    return onCanvas(glm::vec3(part) * kInwards);
}

std::optional<ViewCube::Part> ViewCube::partAt(QPointF position) const {
    if (!place().contains(position)) {
        return std::nullopt;
    }
    const QPointF way = (position - place().center()) / kHalf;
    for (const Face& face : kFaces) {
        if (seen(face.out).z <= 0.0F) {
            continue;  // turned away
        }
        const glm::vec3 right = seen(face.right);
        const glm::vec3 up = seen(face.up);
        const glm::vec2 rest = glm::vec2(way.x(), -way.y()) - glm::vec2(seen(face.out));
        const float size = right.x * up.y - right.y * up.x;
        const float across = (rest.x * up.y - rest.y * up.x) / size;
        const float along = (right.x * rest.y - right.y * rest.x) / size;
        if (std::abs(across) <= 1.0F && std::abs(along) <= 1.0F) {
            return face.out + third(across) * face.right + third(along) * face.up;
        }
    }
    return std::nullopt;
}

bool ViewCube::take(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress: return press(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseMove: return move(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonRelease: return release(static_cast<const QMouseEvent&>(event));
        case QEvent::MouseButtonDblClick: return press(static_cast<const QMouseEvent&>(event));
        case QEvent::Leave: setHovered(std::nullopt); return false;
        default: return false;
    }
}

bool ViewCube::press(const QMouseEvent& event) {
    const std::optional<Part> part = partAt(event.position());
    if (!part || event.button() != Qt::LeftButton) {
        return m_pressed.has_value();
    }
    m_pressed = part;
    m_pressedAt = m_last = event.position();
    m_isDrag = false;
    return true;
}

bool ViewCube::move(const QMouseEvent& event) {
    const QPointF at = event.position();
    if (m_pressed) {
        m_isDrag = m_isDrag || QLineF(m_pressedAt, at).length() >= CameraController::kClickPixels;
        if (m_isDrag) {
            m_view.controller().orbit(at - m_last);
            m_last = at;
        }
        return true;
    }
    setHovered(event.buttons() == Qt::NoButton ? partAt(at) : std::nullopt);
    return m_hovered.has_value();
}

bool ViewCube::release(const QMouseEvent& event) {
    if (!m_pressed || event.button() != Qt::LeftButton) {
        return m_pressed.has_value();
    }
    const Part part = *std::exchange(m_pressed, std::nullopt);
    if (!m_isDrag) {
        m_view.controller().lookFrom(glm::vec3(part));
    }
    setHovered(partAt(event.position()));
    return true;
}

void ViewCube::setHovered(const std::optional<Part>& part) {
    if (part == m_hovered) {
        return;
    }
    if (part && !m_hovered) {
        emit m_view.controller().left();  // whatever of the board was under the cursor no longer is
    }
    m_hovered = part;
    m_view.requestOverlay();
}

void ViewCube::paint(QPainter& painter) const {
    if (place().isEmpty()) {
        return;
    }
    for (const Face& face : kFaces) {
        if (seen(face.out).z > 0.0F) {
            paintFace(painter, face);
        }
    }
}

QPolygonF ViewCube::cell(const Face& face, int column, int row) const {
    const auto corner = [&](int i, int j) {
        return onCanvas(glm::vec3(face.out) + kThirds[static_cast<std::size_t>(i)] * glm::vec3(face.right) +
                        kThirds[static_cast<std::size_t>(j)] * glm::vec3(face.up));
    };
    return {{corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1)}};
}

void ViewCube::paintHovered(QPainter& painter, const Face& face) const {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (m_hovered == face.out + (column - 1) * face.right + (row - 1) * face.up) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(kHighlighted);
                painter.drawPolygon(cell(face, column, row));
            }
        }
    }
}

void ViewCube::paintFace(QPainter& painter, const Face& face) const {
    const float facing = seen(face.out).z;
    const int grey = static_cast<int>(150.0F + 85.0F * facing);
    const QPointF middle = onCanvas(face.out);
    const QPointF right = onCanvas(face.out + face.right) - middle;
    const QPointF up = onCanvas(face.out + face.up) - middle;
    painter.setBrush(QColor(grey, grey, grey + 4, 235));
    painter.setPen(QPen(kRimInk, 1.0));
    painter.drawPolygon(
        QPolygonF({middle - right - up, middle + right - up, middle + right + up, middle - right + up}));
    paintHovered(painter, face);
    if (facing < kLegible) {
        return;
    }
    painter.save();
    // Letters lie on the face: a unit of theirs is a pixel when it is seen straight.
    painter.setTransform(
        QTransform(right.x() / kHalf, right.y() / kHalf, -up.x() / kHalf, -up.y() / kHalf, middle.x(), middle.y()) *
        painter.transform());
    QFont font = painter.font();
    font.setPixelSize(13);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(kInk);
    painter.drawText(QRectF(-kHalf, -kHalf, 2.0 * kHalf, 2.0 * kHalf), Qt::AlignCenter, QLatin1String(face.name));
    painter.restore();
}

}  // namespace ui
