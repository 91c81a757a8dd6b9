#include "ui/views/probing.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "model/base/background.h"
#include "ui/element/element_facts.h"

namespace ui {

namespace {

constexpr int kRestMs = 30;
constexpr int kSlowRestMs = 300;  // where a frame takes long, only a pointer that has come to rest highlights anything
constexpr double kReachPixels = 4.0;
constexpr QColor kInsideColour(90, 160, 255);
constexpr QColor kTouchingColour(235, 165, 60);

/// The dielectric and what else we put around the copper is looked through.
bool isPickable(const model::Layer& layer, const render::LayerStyle& style) {
    return style.isVisible && layer.type != model::LayerType::Body && (!layer.isSynthetic || style.opacity >= 1.0F);
}

std::vector<model::BoardElement> elementsOf(const std::vector<model::Hit>& hits) {
    std::vector<model::BoardElement> elements;
    std::ranges::transform(hits, std::back_inserter(elements), &model::Hit::at);
    return elements;
}

}  // namespace

Probing::Probing(BoardViews& views, Workspace& workspace, NetStyles& nets, LayerModel& layers, QObject* parent)
    : QObject(parent), m_views(views), m_workspace(workspace), m_selection(workspace.selection()), m_nets(nets) {
    connect(&workspace, &Workspace::boardShown, this, &Probing::setBoard);
    connect(&workspace, &Workspace::elementsWanted, this, &Probing::showInBoth);
    connect(&workspace, &Workspace::locationWanted, this,
            [this](base::PointD nm, model::LayerId layer) { showPosition(nm, layer); });
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &Probing::hover);
    connect(&m_selection, &SelectionModel::hoverChanged, this, [this] {
        if (!m_selection.hovered()) {
            QToolTip::hideText();
        }
    });
    qApp->installEventFilter(this);
    connect(&nets, &NetStyles::changed, this, &Probing::hideNets);
    connect(&nets, &NetStyles::changed, this, &Probing::endHiddenHover);
    connect(&layers, &LayerModel::stylesChanged, this, &Probing::endHiddenHover);
    connect(&workspace, &Workspace::currentLayerChanged, this, &Probing::endHiddenHover);
    for (BoardView* view : views.both()) {
        watch(*view);
    }
    CameraController& flat = views.flat().controller();
    connect(&flat, &CameraController::boxDrawn, this, [this](QPointF from, QPointF to) {
        m_box = {from, to};
        m_selection.hover(std::nullopt);
        m_views.flat().requestOverlay();
    });
    connect(&flat, &CameraController::boxFinished, this, &Probing::selectBox);
    connect(&flat, &CameraController::zoomedToBox, this, [this] { m_box.reset(); });
    connect(&flat, &CameraController::boxGivenUp, this, [this] {
        m_box.reset();
        m_views.flat().requestOverlay();
    });
    views.flat().addPainter([this](QPainter& painter) { paintBox(painter); });
}

void Probing::watch(BoardView& view) {
    CameraController& controller = view.controller();
    connect(&controller, &CameraController::hovered, this, [this, &view](QPointF position) {
        m_hoverView = &view;
        m_hoverAt = position;
        m_rest.start(view.isSlow() ? kSlowRestMs : kRestMs);
        endStaleHover(view);
        announceLocation(view, position);
    });
    connect(&controller, &CameraController::moved, this, [this, &view] { hoverAgain(view); });
    connect(&controller, &CameraController::left, this, [this] {
        m_rest.stop();
        m_hoverView = nullptr;
        m_selection.hover(std::nullopt);
        emit pointedAway();
    });
    connect(&controller, &CameraController::clicked, this,
            [this, &view](QPointF position, Qt::KeyboardModifiers modifiers) { click(view, position, modifiers); });
    connect(&controller, &CameraController::doubleClicked, this, &Probing::doubleClick);
}

bool Probing::eventFilter(QObject* object, QEvent* event) {
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (isKey && (m_rest.isActive() || m_hoverView == nullptr)) {
        m_rest.stop();
        findPointer();
        hover();
    }
    if (event->type() == QEvent::KeyPress && isCanvas(object)) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int by = key == Qt::Key_Tab ? 1 : key == Qt::Key_Backtab ? -1 : 0;
        if (by != 0 && !m_isSelecting) {
            emit beneathWanted(by);
            return true;
        }
        if (by != 0 && selectBeneath(by)) {
            return true;
        }
    }
    return QObject::eventFilter(object, event);
}

bool Probing::isCanvas(const QObject* object) const {
    return std::ranges::any_of(m_views.both(), [&](BoardView* view) { return &view->canvas() == object; });
}

void Probing::setBoard(const LoadedBoard& board) {
    m_rest.stop();
    m_last = {};
    m_hoverView = nullptr;
    m_milledAway = MilledAway(board);
    makeOutlines(board.index);
    m_picker.reset();
    if (board.index) {
        m_picker.emplace(board.index);
    }
}

/// Not again where only heights have changed.
void Probing::makeOutlines(const std::shared_ptr<const model::BoardIndex>& index) {
    if (!index) {
        m_outlines.cancel();
    } else if (!m_picker || m_picker->index().figures != index->figures) {
        m_outlines.start(
            [index](const base::Progress& progress) {
                base::becomeBackground();
                index->figures->fill(index->tree, progress);
            },
            "Preparing outlines");
    }
}

void Probing::hideNets() {
    if (!m_picker) {
        return;
    }
    const auto& steps = m_picker->index().tree.steps;
    std::vector<std::vector<bool>> hidden(steps.size());
    for (const NetStyle& look : m_nets.state()) {
        if (look.isHidden) {
            hidden[look.net.step].resize(steps[look.net.step]->nets.size());
            hidden[look.net.step][look.net.net.row()] = true;
        }
    }
    m_picker->hideNets(std::move(hidden));
    m_last = {};
}

std::vector<model::PickLayer> Probing::layersOf(const BoardView& view) const {
    if (!m_picker) {
        return {};
    }
    std::vector<model::PickLayer> layers(m_picker->index().board->layers.size());
    const std::vector<render::ZRange> heights = view.drawnHeights();
    const double faces = static_cast<double>(view.drawnFaces()) * base::kNmPerMm;
    for (std::size_t row = 0; row < std::min(heights.size(), layers.size()); ++row) {
        layers[row].isVisible = isPickable(m_picker->index().board->layers[row], view.styles()[row]);
        layers[row].bottom = static_cast<double>(heights[row].z0) * base::kNmPerMm;
        layers[row].top = static_cast<double>(heights[row].z1) * base::kNmPerMm;
        layers[row].isSeenThrough = view.styles()[row].opacity < 1.0F;
        layers[row].faces = faces;
    }
    return layers;
}

std::optional<model::CutSide> Probing::cutSideOf(const BoardView& view) {
    const render::SectionCut* cut = view.cut();
    if (cut == nullptr) {
        return std::nullopt;
    }
    const glm::dvec2 along = cut->plane.direction;
    return model::CutSide{view.position().toJob(glm::vec3(glm::vec2(cut->plane.start), 0.0F)), {-along.y, along.x}};
}

std::vector<model::Hit> Probing::hitsAt(const BoardView& view, QPointF position) {
    if (!m_picker) {
        return {};
    }
    const std::vector<model::PickLayer> layers = layersOf(view);
    const auto [origin, direction] = view.controller().rayAt(position);
    const double reach = kReachPixels * view.controller().nmPerPixel();
    if (view.kind() == BoardView::Kind::Flat) {
        return m_picker->at(view.locationAt(position), reach, layers, direction.z > 0.0F);
    }
    // Steps of a length that keeps numbers near 1.
    const glm::dvec3 step = glm::normalize(glm::dvec3(direction)) * base::kNmPerMm;
    model::SightLine line{
        view.position().toJob(origin), static_cast<double>(origin.z) * base::kNmPerMm, {step.x, step.y}, -step.z};
    line.cutSide = cutSideOf(view);
    std::vector<model::Hit> hits = m_picker->along(line, reach, layers);
    if (view.isFabricated()) {
        std::erase_if(hits, [&](const model::Hit& hit) {
            return m_milledAway.has(
                hit.at, {line.origin.x + line.direction.x * hit.depth, line.origin.y + line.direction.y * hit.depth});
        });
    }
    return hits;
}

/// After a drag, or over a board that has just come, the pointer has said nothing of where it is.
void Probing::findPointer() {
    for (BoardView* view : m_views.both()) {
        const QPoint at = view->mapFromGlobal(QCursor::pos());
        const bool isOn = view->underMouse() && view->rect().contains(at) && !view->controller().isDragging();
        if (m_hoverView == nullptr && isOn) {
            m_hoverView = view;
            m_hoverAt = at;
        }
    }
}

void Probing::hover() {
    if (m_hoverView == nullptr) {
        return;
    }
    const std::vector<model::Hit> hits = hitsAt(*m_hoverView, m_hoverAt);
    if (hits.empty()) {
        m_selection.hover(std::nullopt);
        return;
    }
    m_selection.hover(hits.front().at);
    if (!m_isSelecting) {
        return;
    }
    QToolTip::showText(m_hoverView->mapToGlobal(m_hoverAt.toPoint()) + QPoint(0, 4),
                       summaryOf(*m_workspace.board()->index, hits.front().at, m_workspace.unit()), m_hoverView);
}

/// Nothing is shown as hovered that the pointer has left, however long it takes until it rests.
void Probing::endStaleHover(BoardView& view) {
    if (const auto before = m_selection.hovered()) {
        const std::vector<model::Hit> hits = hitsAt(view, m_hoverAt);
        if (hits.empty() || hits.front().at != *before) {
            m_selection.hover(std::nullopt);
        }
    }
}

/// Layers or nets are shown otherwise: what was under the pointer may be hidden. Once the views have their new styles.
void Probing::endHiddenHover() {
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (m_hoverView != nullptr) {
                endStaleHover(*m_hoverView);
            }
        },
        Qt::QueuedConnection);
}

/// The camera has moved: what was under the pointer is elsewhere. In a drag the pointer is elsewhere too, and says
/// where when it moves next.
void Probing::hoverAgain(const BoardView& view) {
    if (m_hoverView != &view) {
        return;
    }
    m_selection.hover(std::nullopt);
    if (view.controller().isDragging()) {
        m_rest.stop();
        m_hoverView = nullptr;
    } else {
        m_rest.start(view.isSlow() ? kSlowRestMs : kRestMs);
        announceLocation(view, m_hoverAt);
    }
}

void Probing::announceLocation(const BoardView& view, QPointF position) {
    if (view.kind() == BoardView::Kind::Flat) {
        const base::PointD location = view.locationAt(position);
        emit pointedAt(location.x, location.y);
    } else if (const auto point = view.controller().boardPointAt(position)) {
        const base::PointD location = view.position().toJob(*point);
        emit pointedAt(location.x, location.y);
    } else {
        emit pointedAway();
    }
}

void Probing::click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    if (!m_isSelecting) {
        return;
    }
    std::vector<model::BoardElement> found = elementsOf(hitsAt(view, position));
    if (modifiers.testFlag(Qt::ControlModifier)) {
        if (!found.empty() && modifiers.testFlag(Qt::ShiftModifier)) {
            emit componentRequested(found.front());
        } else if (!found.empty()) {
            m_selection.select({found.front()}, SelectionModel::Mode::Toggle);
        }
        return;
    }
    const bool isRepeated = m_last.view == &view && found == m_last.found && isLastSelected() &&
                            QLineF(m_last.position, position).length() < CameraController::kClickPixels;
    if (!isRepeated) {
        selectFirst(view, position, std::move(found));
    } else if (m_last.since.restart() >= QApplication::doubleClickInterval()) {
        m_last.isBeneath = selectBeneath(1);
    }
    BoardView& other = view.kind() == BoardView::Kind::Flat ? m_views.solid() : m_views.flat();
    if (modifiers.testFlag(Qt::AltModifier)) {
        showInOther(view);
    } else if (m_follows[static_cast<std::size_t>(other.kind())] && other.isVisible()) {
        show(other, m_selection.selected());
    }
}

void Probing::doubleClick() {
    if (!m_isSelecting) {
        return;
    }
    if (std::exchange(m_last.isBeneath, false)) {
        selectBeneath(-1);
    }
    showInBoth(m_selection.selected());
}

void Probing::selectFirst(const BoardView& view, QPointF position, std::vector<model::BoardElement> found) {
    m_selection.select(found.empty() ? found : std::vector{found.front()});
    m_last = {&view, position, std::move(found), 0, false, {}};
    m_last.since.start();
}

bool Probing::isLastSelected() const {
    return !m_last.found.empty() && m_selection.selected() == std::vector{m_last.found[m_last.taken]};
}

bool Probing::selectBeneath(int by) {
    if (!isLastSelected()) {
        return false;
    }
    const std::size_t count = m_last.found.size();
    m_last.taken = (m_last.taken + count + static_cast<std::size_t>(by)) % count;
    m_selection.select({m_last.found[m_last.taken]});
    return true;
}

bool Probing::chooseAt(const BoardView& view, QPointF position) {
    std::vector<model::BoardElement> found = elementsOf(hitsAt(view, position));
    if (found.empty()) {
        return false;
    }
    const auto isSelected = [&](const model::BoardElement& at) {
        return std::ranges::binary_search(m_selection.selected(), at);
    };
    const auto net = m_selection.netOf(found.front());
    const bool isOfChosenNet =
        m_selection.selected().empty() && net && std::ranges::binary_search(m_selection.nets(), *net);
    // What was taken from beneath is chosen too, where it was taken.
    const bool isTakenHere = found == m_last.found && isLastSelected();
    if (!isSelected(found.front()) && !isOfChosenNet && !isTakenHere) {
        selectFirst(view, position, std::move(found));
    }
    return true;
}

void Probing::showInOther(BoardView& view) {
    BoardView& other = view.kind() == BoardView::Kind::Flat ? m_views.solid() : m_views.flat();
    show(other.isVisible() ? other : view, m_selection.selected());
}

void Probing::show(BoardView& view, std::span<const model::BoardElement> elements) {
    if (elements.empty()) {
        return;
    }
    const std::vector<model::PickLayer> layers = layersOf(view);
    glm::vec3 low(1e30F);
    glm::vec3 high(-1e30F);
    for (const model::BoardElement& at : elements) {
        const model::StepCopy& copy = m_selection.tree().copies[at.copy];
        const model::Document& step = m_selection.stepOf(at);
        const model::Box box = copy.placement.boxOf(step.boxOf(at.element));
        const model::LayerId layer = m_selection.layerOf(at);
        const model::PickLayer drawn = layer.row() < layers.size() ? layers[layer.row()] : model::PickLayer{};
        const auto [bottom, top] = model::elementHeights(step, at.element, copy.isFlipped).on(drawn);
        low = glm::min(low, position().toModel(base::toDouble(box.min), bottom));
        high = glm::max(high, position().toModel(base::toDouble(box.max), top));
    }
    view.controller().show(low, high);
}

void Probing::showInBoth(std::span<const model::BoardElement> elements) {
    for (BoardView* view : m_views.both()) {
        if (view->isVisible()) {
            show(*view, elements);
        }
    }
}

void Probing::showPosition(base::PointD nm, model::LayerId layer, float aroundMm) {
    for (BoardView* view : m_views.both()) {
        const std::vector<render::ZRange> heights = view->drawnHeights();
        const float face = view->seenFace(*m_workspace.board()->document);
        const render::ZRange z = layer.row() < heights.size() ? heights[layer.row()] : render::ZRange{face, face};
        const glm::vec3 at = position().toModel(nm);
        const float side = view == &m_views.flat() ? aroundMm : std::max(aroundMm, kAroundMm);
        const glm::vec3 around(side, side, 0.0F);
        view->controller().show(glm::vec3(at.x, at.y, z.z0) - around, glm::vec3(at.x, at.y, z.z1) + around);
    }
}

void Probing::selectBox(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers) {
    m_box.reset();
    m_views.flat().requestOverlay();
    if (!m_picker || !m_isSelecting) {
        return;
    }
    const model::Box box = m_views.flat().boxBetween(from, to);
    // From left to right what is inside, from right to left also what is touched, as CAD users know it.
    m_selection.select(
        m_picker->inside(box, to.x() < from.x(), layersOf(m_views.flat())),
        modifiers.testFlag(Qt::ControlModifier) ? SelectionModel::Mode::Toggle : SelectionModel::Mode::Replace);
}

void Probing::paintBox(QPainter& painter) const {
    if (!m_box) {
        return;
    }
    const auto& [from, to] = *m_box;
    const bool isTouching = to.x() < from.x();
    QColor colour = isTouching ? kTouchingColour : kInsideColour;
    painter.setPen(QPen(colour, 1.0, isTouching ? Qt::DashLine : Qt::SolidLine));
    colour.setAlpha(40);
    painter.setBrush(colour);
    painter.drawRect(QRectF(from, to).normalized());
}

}  // namespace ui
