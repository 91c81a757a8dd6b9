#include "ui/clearance/clearance_map_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/scene/colour_ramp.h"

namespace ui {

namespace {

constexpr int kRestMs = 60;
constexpr std::size_t kShades = 256;
/// Over what is too far away to be coloured, so that the colours are seen on any board.
constexpr QRgb kVeil = 0x78000000;  // premultiplied
/// A picture in perspective is painted in so many parts each distance, to leave out those that reach behind the camera.
constexpr int kParts = 8;

/// In nanometres of the board, both corners inside.
struct Stretch {
    base::PointD min{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    base::PointD max{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    void include(base::PointD p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
};

/// What the corners of the canvas show of the plane at height `z`; nothing if one of them is above its horizon.
std::optional<Stretch> seenStretch(const BoardView& view, float z) {
    const QSizeF size = view.controller().viewport();
    Stretch seen;
    for (const QPointF corner :
         {QPointF(0, 0), QPointF(size.width(), 0), QPointF(0, size.height()), QPointF(size.width(), size.height())}) {
        const auto [from, along] = view.controller().rayAt(corner);
        const float distance = (z - from.z) / along.z;
        if (!(distance >= 0.0F) || !std::isfinite(distance)) {
            return std::nullopt;
        }
        seen.include(view.position().toJob(from + along * distance));
    }
    return seen;
}

std::array<QRgb, kShades> shades(int alpha) {
    std::array<QRgb, kShades> table{};
    for (std::size_t i = 0; i < kShades; ++i) {
        const glm::vec3 c = render::rampColour(static_cast<float>(i) / (kShades - 1)) * 255.0F;
        table[i] = qPremultiply(qRgba(qRound(c.r), qRound(c.g), qRound(c.b), alpha));
    }
    return table;
}

}  // namespace

ClearanceMapPicture::ClearanceMapPicture(BoardView& view, QObject* parent) : QObject(parent), m_view(view) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &ClearanceMapPicture::work);
    connect(&m_work.background(), &Background::finished, this, &ClearanceMapPicture::deliver);
    view.setPlanePainter([this](QPainter& painter) { paint(painter); },
                         [this] { return m_field && m_view.hasScene() ? std::optional(height()) : std::nullopt; });
}

void ClearanceMapPicture::setField(std::shared_ptr<const model::BoardDistances> field, const model::Box& board) {
    m_work.cancel();
    m_rest.stop();
    m_field = std::move(field);
    m_board = board;
    m_asked.reset();
    m_map.reset();
    m_image = {};
    m_view.requestOverlay();
}

void ClearanceMapPicture::setReach(double nm) {
    m_reach = nm;
    colour();
}

float ClearanceMapPicture::height() const {
    const std::vector<render::ZRange> heights = m_view.drawnHeights();
    const std::size_t row = m_field->layer().row();
    const bool isFromBelow = m_view.controller().camera().direction().z > 0.0F;
    return row >= heights.size() ? 0.0F : isFromBelow ? heights[row].z0 : heights[row].z1;
}

std::optional<model::MapFrame> ClearanceMapPicture::shownFrame() const {
    Stretch part;
    part.include(base::toDouble(m_board.min));
    part.include(base::toDouble(m_board.max));
    const std::optional<Stretch> seen = seenStretch(m_view, height());
    base::PointD grid = part.min;  // where the board is cut off, cells stay under their pixels
    if (seen) {
        grid = seen->min;
        part.min = {std::max(part.min.x, seen->min.x), std::max(part.min.y, seen->min.y)};
        part.max = {std::min(part.max.x, seen->max.x), std::min(part.max.y, seen->max.y)};
    }
    if (!(part.min.x < part.max.x && part.min.y < part.max.y)) {
        return std::nullopt;
    }
    const double ratio = m_view.devicePixelRatioF();
    const QSizeF size = m_view.controller().viewport() * ratio;
    const double perPixel = m_view.controller().nmPerPixel() / ratio;
    const double area = (part.max.x - part.min.x) * (part.max.y - part.min.y);
    model::MapFrame frame;
    frame.cell =
        std::clamp(std::max(perPixel, std::sqrt(area / (size.width() * size.height()))), 1.0, model::kMostMapCell);
    frame.corner = {grid.x + std::floor((part.min.x - grid.x) / frame.cell) * frame.cell,
                    grid.y + std::floor((part.min.y - grid.y) / frame.cell) * frame.cell};
    frame.width = static_cast<std::uint32_t>(std::ceil((part.max.x - frame.corner.x) / frame.cell));
    frame.height = static_cast<std::uint32_t>(std::ceil((part.max.y - frame.corner.y) / frame.cell));
    return frame;
}

/// Every move of the camera ends in a painting, so it is noticed here.
void ClearanceMapPicture::follow() {
    const std::optional<model::MapFrame> shown = shownFrame();
    if (shown && shown != m_asked) {
        m_work.cancel();
        m_asked = shown;
        m_rest.start();
    }
}

void ClearanceMapPicture::work() {
    m_work.run([field = m_field, frame = *m_asked](
                   base::Progress& progress) { return field->map(frame, model::kMostMapReach, progress); },
               tr("Measuring distances"), tr("not enough memory for a map"));
}

void ClearanceMapPicture::deliver() {
    auto map = m_work.take();
    if (map) {
        m_map = std::move(*map);
        colour();
    } else {
        emit failed(QString::fromStdString(map.error().text));
    }
}

void ClearanceMapPicture::colour() {
    if (!m_map) {
        return;
    }
    const auto width = static_cast<int>(m_map->frame.width);
    const auto height = static_cast<int>(m_map->frame.height);
    if (m_image.width() != width || m_image.height() != height) {
        m_image = QImage(width, height, QImage::Format_ARGB32_Premultiplied);
    }
    const bool isOfGaps = m_field->kind() == model::DistanceField::Kind::BetweenNets;
    const auto table = shades(isOfGaps ? kSpacingAlpha : kDistanceAlpha);
    const auto most = static_cast<float>(m_reach);
    const float scale = (kShades - 1) / most;
    const float* nm = m_map->nm.data();
    for (int row = 0; row < height; ++row) {
        auto* pixels = reinterpret_cast<QRgb*>(m_image.scanLine(row));
        for (int column = 0; column < width; ++column, ++nm) {
            pixels[column] = *nm > most ? kVeil : *nm > 0.0F ? table[static_cast<std::size_t>(*nm * scale)] : 0U;
        }
    }
    m_view.requestOverlay();
}

QTransform ClearanceMapPicture::canvasFromCells() const {
    const glm::mat4 clip = m_view.controller().clipFromBoard();
    const QSizeF size = m_view.controller().viewport();
    // Columns: what a step to the right adds, what a step upwards adds, where the corner is; x, y and weight.
    const auto column = [&](const glm::vec4& p) {
        return std::array{(p.x + p.w) / 2.0 * size.width(), (p.y + p.w) / 2.0 * size.height(), double{p.w}};
    };
    glm::vec3 corner = m_view.position().toModel(m_map->frame.corner);
    corner.z = height();
    const auto step = static_cast<float>(m_map->frame.cell / base::kNmPerMm);
    const auto right = column(clip[0] * step);
    const auto up = column(clip[1] * step);
    const auto at = column(clip * glm::vec4(corner, 1.0F));
    if (right[2] == 0.0 && up[2] == 0.0) {
        return {right[0] / at[2], right[1] / at[2], up[0] / at[2], up[1] / at[2], at[0] / at[2], at[1] / at[2]};
    }
    return {right[0], right[1], right[2], up[0], up[1], up[2], at[0], at[1], at[2]};
}

/// What a section plane has taken away has no map.
void ClearanceMapPicture::clipToBoard(QPainter& painter) const {
    if (m_view.cut() == nullptr) {
        return;
    }
    const render::SectionPlane& cut = m_view.cut()->plane;
    const auto beyond = [&](QPointF cell) {
        const glm::vec3 at = m_view.position().toModel(m_map->frame.centreOf(cell.x() - 0.5, cell.y() - 0.5));
        return glm::dot(glm::dvec2(at) - cut.start, glm::dvec2(-cut.direction.y, cut.direction.x));
    };
    const QPolygonF corners = QRectF(m_image.rect());  // closed: the last is the first
    QPolygonF left;
    for (qsizetype i = 0; i + 1 < corners.size(); ++i) {
        const double from = beyond(corners[i]);
        const double to = beyond(corners[i + 1]);
        if (from <= 0.0) {
            left += corners[i];
        }
        if ((from > 0.0) != (to > 0.0)) {
            left += corners[i] + (corners[i + 1] - corners[i]) * (from / (from - to));
        }
    }
    QPainterPath path;
    path.addPolygon(left);
    painter.setClipPath(path);
}

void ClearanceMapPicture::paint(QPainter& painter) {
    if (!m_field || !m_view.hasScene()) {
        return;
    }
    follow();
    if (!m_map) {
        return;
    }
    const QTransform cells = canvasFromCells();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !m_view.controller().isPlan());
    painter.setTransform(cells, true);
    clipToBoard(painter);
    if (cells.isAffine()) {
        painter.drawImage(QPointF(), m_image);
        return;
    }
    const QSizeF part(m_image.width() / double{kParts}, m_image.height() / double{kParts});
    const auto isBeforeEye = [&](QPointF p) { return cells.m13() * p.x() + cells.m23() * p.y() + cells.m33() > 0.0; };
    for (int i = 0; i < kParts * kParts; ++i) {
        const QRectF location(QPointF(i % kParts * part.width(), i / kParts * part.height()), part);
        if (isBeforeEye(location.topLeft()) && isBeforeEye(location.topRight()) && isBeforeEye(location.bottomLeft()) &&
            isBeforeEye(location.bottomRight())) {
            painter.drawImage(location, m_image, location);
        }
    }
}

}  // namespace ui
