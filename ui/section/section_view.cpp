#include "ui/section/section_view.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "model/board/board_heights.h"
#include "model/export/section_export.h"
#include "model/index/pin_names.h"
#include "ui/canvas/camera_controller.h"
#include "ui/common/thickness_text.h"

namespace ui {

namespace {

using model::SectionPiece;
using model::SectionPosition;

constexpr double kMargin = 8.0;
constexpr double kLabels = 0.34;       // of the width, at least
constexpr double kMostLabels = 0.5;    // the cut is what the view is for
constexpr double kLeastOfBoard = 0.4;  // of what is shown, beside tall parts
constexpr double kFilled = 0.8;        // of the plot, by a cut that is shown whole
constexpr double kLeastPixels = 0.7;   // of a piece: none vanishes
constexpr double kReachPixels = 2.0;   // around a piece, for the mouse
constexpr double kWheelNotch = 120.0;
constexpr double kMostPerNm = 1e-2;  // 10 µm across a pixel times a thousand: nothing is smaller
constexpr double kLeastPerNm = 1e-8;

}  // namespace

SectionView::SectionView(SelectionModel& selection, QWidget* parent) : QWidget(parent), m_selection(selection) {
    setAccessibleName(tr("Cross-section"));
    setMinimumSize(200, 150);
    setFocusPolicy(Qt::ClickFocus);
    setMouseTracking(true);
    connect(&selection, &SelectionModel::highlightChanged, this, qOverload<>(&QWidget::update));
    connect(&selection, &SelectionModel::hoverChanged, this, qOverload<>(&QWidget::update));
}

void SectionView::setSection(std::shared_ptr<const model::BoardIndex> board, std::optional<model::Section> section) {
    m_board = std::move(board);
    m_section = std::move(section);
    m_drawn.clear();
    m_under.reset();
    if (m_section) {
        m_drawn = model::merged(m_section->pieces);
        std::ranges::stable_sort(m_drawn, {}, [](const SectionPiece& p) { return model::drawOrderOf(p.material); });
    }
    arrange();
    updateMeasuring();
}

void SectionView::setRuns(std::vector<model::LayerRun> runs) {
    m_runs = std::move(runs);
    arrange();
}

void SectionView::setMeasuring(bool isOn) {
    m_isMeasuring = isOn;
    QToolTip::hideText();
    m_under.reset();
    m_dimensions.giveUp();
    setCursor(isOn ? Qt::CrossCursor : Qt::ArrowCursor);
    updateMeasuring();
}

QString SectionView::prompt() const {
    if (!m_section || !m_isPointedAt) {
        return {};
    }
    if (m_dimensions.from()) {
        return tr("Click the second edge or corner");
    }
    return m_isMeasuring ? tr("Click the first edge or corner of the section") : QString();
}

void SectionView::updateMeasuring() {
    update();
    if (const QString now = prompt(); std::exchange(m_prompt, now) != now) {
        emit promptChanged(now);
    }
}

void SectionView::setDimensions(std::vector<model::SectionDimension> dimensions) {
    m_dimensions.set(std::move(dimensions));
    updateMeasuring();
}

bool SectionView::stepBack() {
    const bool isBegun = m_dimensions.giveUp();
    updateMeasuring();
    return isBegun;
}

void SectionView::removeLastDimension() {
    m_dimensions.removeLast();
    updateMeasuring();
    emit dimensionsChanged();
}

void SectionView::setColours(std::vector<QColor> colours) {
    m_colours = std::move(colours);
    update();
}

void SectionView::setUnit(LengthUnit unit) {
    m_unit = unit;
    arrange();
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
    const double above = m_runs.empty() ? kMargin : kMargin + lineHeight();
    return {kMargin, above, width() - m_labelRoom - kMargin, height() - above - 3.0 * lineHeight()};
}

/// From the lowest to the highest of what is drawn. Parts may be many times as high as a board: then both ends are
/// moved in until the board has its share.
std::pair<double, double> SectionView::fittedHeights() const {
    const model::ZRange faces = model::boardHeights(board());
    const auto bottom = static_cast<double>(faces.bottom);
    const double thickness = std::max(static_cast<double>(faces.top) - bottom, 1.0);
    double below = 0.0;
    double above = 0.0;
    for (const SectionPiece& piece : m_drawn) {
        below = std::max(below, bottom - static_cast<double>(piece.bottom));
        above = std::max(above, static_cast<double>(piece.top) - bottom - thickness);
    }
    const double room = thickness / kLeastOfBoard - thickness;
    const double part = below + above > room ? room / (below + above) : 1.0;
    return {bottom - part * below, bottom + thickness + part * above};
}

std::vector<QRectF> SectionView::brokenParts() const {
    std::vector<QRectF> broken;
    for (const SectionPiece& piece : m_drawn) {
        const bool isPart =
            piece.material == model::SectionMaterial::Part || piece.material == model::SectionMaterial::Terminal;
        const QRectF rect = rectOf(piece);
        if (isPart && m_isFitted && (rect.top() < plot().top() || rect.bottom() > plot().bottom())) {
            broken.push_back(rect);
        }
    }
    return broken;
}

/// Lengths and heights to pixels: of the whole line unless the user has chosen a part of it.
void SectionView::arrange() {
    const double wanted = m_section ? roomForLabels() : 0.0;
    m_labelRoom = std::clamp(wanted, kLabels * width(), kMostLabels * width());
    if (m_section && m_isFitted) {
        const double length = m_section->stations.back();
        const auto [low, high] = fittedHeights();
        m_perNm = std::min(plot().width() / length, kFilled * plot().height() / (high - low));
        m_along = length / 2;
        m_z = (low + high) / 2;
        m_times = std::max(1.0, std::floor(kFilled * plot().height() / ((high - low) * m_perNm)));
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
    QRectF rect(positionOf(piece.least(), piece.top), positionOf(piece.most(), piece.bottom));
    rect.setWidth(std::max(rect.width(), kLeastPixels));
    rect.setHeight(std::max(rect.height(), kLeastPixels));
    return rect;
}

QPolygonF SectionView::outlineOf(const SectionPiece& piece) const {
    if (!piece.leans()) {
        return {rectOf(piece)};
    }
    return {{positionOf(piece.from, piece.bottom), positionOf(piece.to, piece.bottom),
             positionOf(piece.upperTo(), piece.top), positionOf(piece.upperFrom(), piece.top)}};
}

QColor SectionView::colourOf(const SectionPiece& piece) const {
    if (const auto fixed = model::colourOf(piece.material)) {
        return QColor::fromRgb(*fixed);
    }
    return piece.layer.row() < m_colours.size() ? m_colours[piece.layer.row()] : QColor(Qt::gray);
}

/// Foils are thinner than a pointer is exact: what is drawn within a few pixels counts, if nothing better lies there.
const SectionPiece* SectionView::pieceAt(QPointF at) const {
    if (!m_section || !plot().contains(at)) {
        return nullptr;
    }
    const auto standing = [&](const SectionPiece& piece) {
        const bool isThere = outlineOf(piece).containsPoint(at, Qt::OddEvenFill);
        return std::tuple(isThere, model::drawOrderOf(piece.material), piece.from - piece.to);
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
    const model::StackupRow* row = model::stackupRowOf(board(), *piece);
    QString tip = QString::fromStdString(row != nullptr ? row->name : board().layer(piece->layer).name);
    tip += isBore ? tr(", drilled out") : QStringLiteral(" · ") + model::toString(piece->material);
    if (const QString component = componentOf(*piece); !component.isEmpty()) {
        tip += QStringLiteral(" · ") + component;
    }
    if (const std::string net = model::netOf(*m_board, *piece); !net.empty()) {
        tip += QStringLiteral(" · ") + QString::fromStdString(net);
    }
    const auto text = [this](auto nm) { return lengthText(static_cast<double>(nm), m_unit); };
    return tip + '\n' +
           tr("%1 wide, from %2 to %3 along the line")
               .arg(text(piece->to - piece->from), text(piece->from), text(piece->to)) +
           '\n' +
           tr("%1 high, from %2 to %3 above the bottom")
               .arg(text(piece->top - piece->bottom), text(piece->bottom), text(piece->top)) +
           (row != nullptr ? '\n' + dielectricText(*piece, *row) : QString());
}

QString SectionView::componentOf(const SectionPiece& piece) const {
    if (!piece.at.element.isValid()) {
        return {};
    }
    const model::Document& step = m_board->stepOf(piece.at.copy);
    const model::PinFinder& finder = m_board->pinsOf(piece.at.copy);
    if (const std::vector<model::PinId> pins = finder.pinsOf(piece.at.element); pins.size() == 1) {
        return QString::fromStdString(model::fullPinName(step, pins.front()));
    }
    const model::ComponentId component = finder.componentOf(piece.at.element);
    return component.isValid() ? QString::fromStdString(step.components[component.row()].refdes) : QString();
}

/// What the stackup says of a dielectric, which is less than its height where it fills the space beside copper too.
QString SectionView::dielectricText(const SectionPiece& piece, const model::StackupRow& row) const {
    const QString thickness = thicknessText(row.thickness, m_unit);
    return piece.top - piece.bottom > row.thickness
               ? tr("%1 thick in the stackup, and fills the space beside copper here").arg(thickness)
               : tr("%1 thick in the stackup").arg(thickness);
}

bool SectionView::isHighlighted(const SectionPiece& piece) const {
    if (!piece.at.element.isValid()) {
        return false;
    }
    if (m_selection.hovered() == piece.at || std::ranges::binary_search(m_selection.selected(), piece.at)) {
        return true;
    }
    const std::optional<model::BoardNet> net = m_selection.nets().empty() ? std::nullopt : m_selection.netOf(piece.at);
    return net && std::ranges::binary_search(m_selection.nets(), *net);
}

void SectionView::wheelEvent(QWheelEvent* event) {
    if (!m_section) {
        return;  // nothing to zoom: the next section is shown whole
    }
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
    m_isDragged = m_endsDoubleClick = false;
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
    m_isDragged = m_isDragged || QLineF(m_pressed, event->position()).length() >= CameraController::kClickPixels;
    if (m_isMeasuring && event->buttons() == Qt::NoButton) {
        m_under = locationAt(event->position());
        update();
    }
    if (!m_section || !m_isDragged || event->buttons() == Qt::NoButton) {
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
    if (std::exchange(m_endsDoubleClick, false) || m_isDragged) {
        return;
    }
    if (event->button() == Qt::RightButton) {
        openMenu(event->position());
    }
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (m_isMeasuring || event->modifiers().testFlag(Qt::ShiftModifier)) {
        measureAt(event->position());
        return;
    }
    selectAt(event->position());
}

void SectionView::selectAt(QPointF at) {
    if (!m_section) {
        return;
    }
    const SectionPiece* piece = pieceAt(at);
    const bool isElement = piece != nullptr && piece->at.element.isValid();
    m_selection.select(isElement ? std::vector{piece->at} : std::vector<model::BoardElement>{});
}

/// Of the mouse it opens once the right button is released where it was pressed: a drag pans.
void SectionView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() == QContextMenuEvent::Keyboard) {
        openMenu(event->pos());
    }
    event->accept();
}

void SectionView::openMenu(QPointF at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const SectionPiece* piece = pieceAt(at);
    const QString component = piece != nullptr ? componentOf(*piece).replace('&', QStringLiteral("&&")) : QString();
    QAction* select =
        menu->addAction(component.isEmpty() ? tr("Select element") : tr("Select element of %1").arg(component), this,
                        [this, at] { selectAt(at); });
    select->setObjectName(QStringLiteral("select"));
    select->setEnabled(piece != nullptr && piece->at.element.isValid());
    menu->addAction(tr("Show whole section"), this, &SectionView::fit)->setEnabled(m_section.has_value());
    menu->addSeparator();
    menu->addActions(actions());
    menu->popup(mapToGlobal(at.toPoint()));
}

void SectionView::measureAt(QPointF at) {
    QToolTip::hideText();
    const std::optional<SectionPosition> location = locationAt(at);
    if (!location) {
        emit refused(m_section ? tr("There is no edge or corner of the section under the pointer")
                               : tr("There is no section to measure: draw one first"));
        return;
    }
    const bool isWhole = m_dimensions.add(*location);
    updateMeasuring();
    if (isWhole) {
        emit dimensionsChanged();
        emit measured(textOf(m_dimensions.all().back()));
    }
}

void SectionView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (m_isMeasuring) {
        mousePressEvent(event);  // two locations in quick succession
    } else {
        fit();
        m_endsDoubleClick = true;
    }
}

void SectionView::enterEvent(QEnterEvent*) {
    m_isPointedAt = true;
    updateMeasuring();
}

void SectionView::leaveEvent(QEvent*) {
    m_isPointedAt = false;
    m_under.reset();
    updateMeasuring();
}

void SectionView::keyPressEvent(QKeyEvent* event) {
    const bool isBack = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    if (isBack && (m_dimensions.from() || !m_dimensions.all().empty())) {
        removeLastDimension();
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool SectionView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const bool isBusy = m_isMeasuring || m_dimensions.from();
        QToolTip::showText(help->globalPos(), isBusy ? QString() : tipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ui
