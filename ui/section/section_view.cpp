#include "ui/section/section_view.h"

#include <QHelpEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/export/section_export.h"
#include "ui/canvas/camera_controller.h"

namespace ui {

namespace {

using model::LayerType;
using model::SectionPiece;

constexpr double kMargin = 8.0;
constexpr double kLabels = 0.34;      // of the width
constexpr double kFilled = 0.8;       // of the plot, by a cut that is shown whole
constexpr double kLeastPixels = 0.7;  // of a piece: none vanishes
constexpr double kReachPixels = 2.0;  // around a piece, for the mouse
constexpr double kCatchPixels = 6.0;  // around edges and corners that are measured
constexpr double kWheelNotch = 120.0;
constexpr double kMostPerNm = 1e-2;  // 10 µm across a pixel times a thousand: nothing is smaller
constexpr double kLeastPerNm = 1e-8;

/// What others lie in or on is drawn first.
int orderOf(const model::Layer& layer) {
    return layer.type == LayerType::Body || layer.type == LayerType::Dielectric ? 0
           : layer.type == LayerType::ComponentBody                             ? 1
                                                                                : 2;
}

}  // namespace

SectionView::SectionView(SelectionModel& selection, QWidget* parent) : QWidget(parent), m_selection(selection) {
    setAccessibleName(tr("Cross-section"));
    setMinimumSize(200, 80);
    connect(&selection, &SelectionModel::highlightChanged, this, qOverload<>(&QWidget::update));
    connect(&selection, &SelectionModel::hoverChanged, this, qOverload<>(&QWidget::update));
}

void SectionView::setSection(std::shared_ptr<const model::BoardIndex> board, std::optional<model::Section> section) {
    m_board = std::move(board);
    m_section = std::move(section);
    m_drawn.clear();
    m_dimension.clear();
    if (m_section) {
        m_drawn = model::merged(m_section->pieces);
        std::ranges::stable_sort(m_drawn, {},
                                 [this](const SectionPiece& p) { return orderOf(this->board().layer(p.layer)); });
    }
    arrange();
}

void SectionView::setColours(std::vector<QColor> colours) {
    m_colours = std::move(colours);
    update();
}

void SectionView::setUnit(LengthUnit unit) {
    m_unit = unit;
    update();
}

void SectionView::setHeightTimes(double times) {
    m_wantedTimes = times;
    arrange();
}

void SectionView::fit() {
    m_isFitted = true;
    arrange();
}

QRectF SectionView::plot() const {
    return {kMargin, kMargin, width() * (1.0 - kLabels) - kMargin, height() - kMargin - 2.0 * lineHeight()};
}

/// Lengths and heights to pixels: of the whole line unless the user has chosen a part of it.
void SectionView::arrange() {
    if (m_section && m_isFitted) {
        const double length = m_section->stations.back();
        const double thickness = std::max<double>(board().boardThickness, 1.0);
        m_perNm = std::min(plot().width() / length, kFilled * plot().height() / thickness);
        m_along = length / 2;
        m_z = thickness / 2;
        m_times = std::max(1.0, std::floor(kFilled * plot().height() / (thickness * m_perNm)));
    }
    m_times = m_wantedTimes > 0.0 ? m_wantedTimes : m_times;
    update();
}

void SectionView::resizeEvent(QResizeEvent*) {
    arrange();
}

QPointF SectionView::positionOf(double along, double z) const {
    return plot().center() + QPointF((along - m_along) * m_perNm, (m_z - z) * m_perNm * m_times);
}

QRectF SectionView::rectOf(const SectionPiece& piece) const {
    QRectF rect(positionOf(piece.from, piece.top), positionOf(piece.to, piece.bottom));
    rect.setWidth(std::max(rect.width(), kLeastPixels));
    rect.setHeight(std::max(rect.height(), kLeastPixels));
    return rect;
}

/// Foils are thinner than a pointer is exact: what is drawn within a few pixels counts, if nothing better lies there.
const SectionPiece* SectionView::pieceAt(QPointF at) const {
    if (!m_section || !plot().contains(at)) {
        return nullptr;
    }
    const auto standing = [&](const SectionPiece& piece) {
        const bool isThere = rectOf(piece).contains(at);
        return std::tuple(orderOf(board().layer(piece.layer)), isThere, piece.from - piece.to);
    };
    const SectionPiece* found = nullptr;
    for (const SectionPiece& piece : m_section->pieces) {
        const QRectF reach = rectOf(piece).adjusted(-kReachPixels, -kReachPixels, kReachPixels, kReachPixels);
        if (reach.contains(at) && (found == nullptr || standing(piece) > standing(*found))) {
            found = &piece;
        }
    }
    if (found != nullptr) {
        return found;
    }
    const auto bore =
        std::ranges::find_if(m_section->bores, [&](const SectionPiece& p) { return rectOf(p).contains(at); });
    return bore != m_section->bores.end() ? &*bore : nullptr;
}

QString SectionView::tipAt(QPointF at) const {
    const SectionPiece* piece = pieceAt(at);
    if (piece == nullptr) {
        return {};
    }
    const bool isBore = !m_section->bores.empty() && piece >= m_section->bores.data() &&
                        piece < m_section->bores.data() + m_section->bores.size();
    QString tip = QString::fromStdString(board().layer(piece->layer).name);
    tip += isBore ? tr(", drilled out") : QString();
    if (const std::string net = model::netOf(*m_board, *piece); !net.empty()) {
        tip += QStringLiteral(" · ") + QString::fromStdString(net);
    }
    const auto text = [this](auto nm) { return lengthText(static_cast<double>(nm), m_unit); };
    return tip + '\n' +
           tr("%1 wide, from %2 to %3 along the line")
               .arg(text(piece->to - piece->from), text(piece->from), text(piece->to)) +
           '\n' +
           tr("%1 high, from %2 to %3 above the bottom")
               .arg(text(piece->top - piece->bottom), text(piece->bottom), text(piece->top));
}

std::optional<SectionPosition> SectionView::locationAt(QPointF at) const {
    // The ends of a line that is shown whole lie on the rim of the plot.
    if (!m_section || !plot().adjusted(-kCatchPixels, -kCatchPixels, kCatchPixels, kCatchPixels).contains(at)) {
        return std::nullopt;
    }
    std::optional<SectionPosition> best;
    double nearest = kCatchPixels;
    bool isCorner = false;
    const QPointF zero = positionOf(0.0, 0.0);
    for (const SectionPiece& piece : m_drawn) {
        const QPointF low = positionOf(piece.from, piece.bottom);
        const QPointF high = positionOf(piece.to, piece.top);
        const bool isLeft = std::abs(at.x() - low.x()) < std::abs(at.x() - high.x());
        const bool isBelow = std::abs(at.y() - low.y()) < std::abs(at.y() - high.y());
        const double across = std::abs(at.x() - (isLeft ? low.x() : high.x()));
        const double up = std::abs(at.y() - (isBelow ? low.y() : high.y()));
        const bool isBeside = at.x() >= low.x() - kCatchPixels && at.x() <= high.x() + kCatchPixels;
        const bool isLevel = at.y() >= high.y() - kCatchPixels && at.y() <= low.y() + kCatchPixels;
        if (!isBeside || !isLevel) {
            continue;
        }
        const bool isAtCorner = across <= kCatchPixels && up <= kCatchPixels;
        const double far = isAtCorner ? std::hypot(across, up) : std::min(across, up);
        const bool isNearer = isAtCorner == isCorner ? far < nearest : isAtCorner;
        if (far > 2 * kCatchPixels || (!isAtCorner && far > kCatchPixels) || !isNearer) {
            continue;
        }
        const bool isOnUpright = isAtCorner || across <= up;
        const bool isOnLevel = isAtCorner || across > up;
        best = {isOnUpright ? (isLeft ? piece.from : piece.to) : (at.x() - zero.x()) / m_perNm,
                isOnLevel ? static_cast<double>(isBelow ? piece.bottom : piece.top)
                          : (zero.y() - at.y()) / m_perNm / m_times,
                isOnUpright, isOnLevel};
        nearest = far;
        isCorner = isAtCorner;
    }
    return best;
}

bool SectionView::isHighlighted(const SectionPiece& piece) const {
    if (m_selection.hovered() == piece.at || std::ranges::binary_search(m_selection.selected(), piece.at)) {
        return true;
    }
    const std::optional<model::BoardNet> net = m_selection.nets().empty() ? std::nullopt : m_selection.netOf(piece.at);
    return net && std::ranges::binary_search(m_selection.nets(), *net);
}

void SectionView::wheelEvent(QWheelEvent* event) {
    const double factor =
        std::pow(static_cast<double>(CameraController::kZoomPerNotch), event->angleDelta().y() / kWheelNotch);
    const double after = std::clamp(m_perNm * factor, kLeastPerNm, kMostPerNm);
    // What is under the cursor stays there.
    const QPointF from = event->position() - plot().center();
    m_along += from.x() / m_perNm - from.x() / after;
    m_z -= (from.y() / m_perNm - from.y() / after) / m_times;
    m_perNm = after;
    m_isFitted = false;
    event->accept();
    update();
}

void SectionView::mousePressEvent(QMouseEvent* event) {
    m_pressed = m_last = event->position();
    m_isDragged = false;
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
    m_isDragged = m_isDragged || QLineF(m_pressed, event->position()).length() >= CameraController::kClickPixels;
    if (!m_isDragged || event->buttons() == Qt::NoButton) {
        return;
    }
    const QPointF moved = event->position() - m_last;
    m_last = event->position();
    m_along -= moved.x() / m_perNm;
    m_z += moved.y() / m_perNm / m_times;
    m_isFitted = false;
    update();
}

void SectionView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_isDragged || event->button() != Qt::LeftButton || !m_section) {
        return;
    }
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        if (const auto location = locationAt(event->position())) {
            m_dimension.add(*location);
            update();
        }
        return;
    }
    m_dimension.clear();
    update();
    const SectionPiece* piece = pieceAt(event->position());
    m_selection.select(piece != nullptr ? std::vector{piece->at} : std::vector<model::BoardElement>{});
}

void SectionView::mouseDoubleClickEvent(QMouseEvent*) {
    fit();
}

bool SectionView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ui
