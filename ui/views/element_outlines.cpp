#include "ui/views/element_outlines.h"

#include <QPainter>
#include <algorithm>

#include "model/board/single_element.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "ui/nets/net_styles.h"
#include "ui/views/nearby_highlight.h"

namespace ui {

namespace {

constexpr std::array kInks = {kNearbyOutline, kSelectedOutline, QColor(255, 255, 255)};
enum Ink { Near, Selected, Hovered };
/// Opaque, as all inks: of translucent lines Qt gives every few spans to threads of its own and waits for them, which
/// takes twice as long, and many times where other work has the cores.
constexpr QColor kShadow(24, 24, 24);
constexpr double kWidth = 1.6;
/// Track chains of more points than this, and those beyond so many in all, are outlined track by track: uniting them
/// would take too long.
constexpr std::size_t kMostToUnite = 4000;
/// Of an element that is outlined finely (kMostFine).
constexpr std::size_t kMostFineNodes = 500;
/// The outline of an element under the pointer that has more comes with an event of its own: to make it takes as long
/// as finding the element.
constexpr std::size_t kMostNodesAtOnce = 2000;
constexpr int kRestMs = 150;
constexpr int kSmall = 256 * 256;  // pixels of the box of strokes that are painted every time

model::PolygonSet loopsOf(const model::Document& step, model::ElementId element, std::size_t& pointsToUnite,
                          bool isFine) {
    const bool isSmall = model::nodeCountOf(step, element) <= kMostFineNodes;
    model::PolygonSet parts = model::discretise(
        step, element,
        isFine && isSmall ? model::Discretisation{model::Discretisation::kMinChordNm, false} : model::Discretisation{});
    const bool isTracks = step.elements.kind[element.row()] != model::ElementKind::Area && parts.polygons.size() > 1;
    if (!isTracks || parts.points.size() > pointsToUnite) {
        return parts;
    }
    pointsToUnite -= parts.points.size();
    return model::unite(parts);
}

/// Of a long line Qt's rasteriser finds more than it has room for, and begins anew with twice the room, several times:
/// 2,000 points at once take 9 ms, in such pieces 3.
void drawInPieces(QPainter& painter, const QPolygonF& line) {
    constexpr qsizetype kPiece = 16;
    for (qsizetype first = 0; first + 1 < line.size(); first += kPiece) {
        painter.drawPolyline(line.constData() + first, static_cast<int>(std::min(kPiece + 1, line.size() - first)));
    }
}

}  // namespace

ElementOutlines::ElementOutlines(BoardViews& views, Workspace& workspace, const NetStyles& nets, QObject* parent)
    : QObject(parent), m_views(views), m_selection(workspace.selection()), m_nets(nets) {
    connect(&m_selection, &SelectionModel::hoverChanged, this, &ElementOutlines::updateHovered);
    connect(&m_selection, &SelectionModel::highlightChanged, this, &ElementOutlines::updateSelected);
    connect(&m_selection, &SelectionModel::marksChanged, this, &ElementOutlines::updateSelected);
    connect(&nets, &NetStyles::changed, this, [this] {
        ++m_change;
        m_views.requestOverlay();
    });
    m_hoveredDue.setSingleShot(true);
    connect(&m_hoveredDue, &QTimer::timeout, this, &ElementOutlines::showHovered);
    m_afterFrame.setSingleShot(true);
    connect(&m_afterFrame, &QTimer::timeout, this, &ElementOutlines::showSelected);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_isAtRest = true;
        m_views.requestOverlay();
    });
    for (std::size_t i = 0; i < m_pointers.size(); ++i) {
        watch(*views.both()[i], m_pointers[i]);
    }
}

void ElementOutlines::watch(BoardView& view, std::optional<QPointF>& pointer) {
    view.addPainter([this, &view](QPainter& painter) { paint(painter, view); }, BoardView::Shown::OnCanvas);
    const auto setPointer = [this, &view, &pointer](std::optional<QPointF> at) {
        pointer = at;
        const auto isPerforated = [](const Outline& outline) { return outline.runs.isPerforated(); };
        if (isPerforated(m_hovered) || std::ranges::any_of(m_selected, isPerforated)) {
            ++m_change;  // other openings are near the pointer
            view.requestOverlay();
        }
    };
    connect(&view.controller(), &CameraController::hovered, this, setPointer);
    connect(&view.controller(), &CameraController::left, this, [setPointer] { setPointer(std::nullopt); });
}

ElementOutlines::Outline ElementOutlines::outlineOf(const model::BoardElement& at, std::size_t& pointsToUnite,
                                                    bool isFine) const {
    const model::Document& step = m_selection.stepOf(at);
    const model::StepCopy& copy = m_selection.tree().copies[at.copy];
    return {OutlineRuns(model::placed(loopsOf(step, at.element, pointsToUnite, isFine), copy.placement)),
            m_selection.layerOf(at), model::elementHeights(step, at.element, copy.isFlipped), m_selection.netOf(at),
            false};
}

void ElementOutlines::updateHovered() {
    const auto at = m_selection.hovered();
    if (!at || model::nodeCountOf(m_selection.stepOf(*at), at->element) <= kMostNodesAtOnce) {
        showHovered();
        return;
    }
    m_hovered = {};
    m_hoveredDue.start(0);
    ++m_change;
    m_views.requestOverlay();
}

void ElementOutlines::showHovered() {
    m_hoveredDue.stop();
    const auto at = m_selection.hovered();
    std::size_t pointsToUnite = kMostToUnite;
    m_hovered = at ? outlineOf(*at, pointsToUnite, true) : Outline();
    ++m_change;
    m_views.requestOverlay();
}

void ElementOutlines::updateSelected() {
    const bool wasEmpty = m_selected.empty();
    m_selected.clear();
    std::size_t pointsToUnite = kMostToUnite;
    std::size_t nodes = 0;
    for (const auto* elements : {&m_selection.marked(), &m_selection.nearby(), &m_selection.selected()}) {
        for (std::size_t i = 0; elements->size() <= kMostOutlined && i < elements->size(); ++i) {
            const model::BoardElement& at = (*elements)[i];
            nodes += model::nodeCountOf(m_selection.stepOf(at), at.element);
            if (nodes > kMostNodes) {
                break;
            }
            m_selected.push_back(outlineOf(at, pointsToUnite, elements->size() <= kMostFine));
            m_selected.back().isNear = elements == &m_selection.nearby();
        }
    }
    std::size_t points = 0;
    std::ranges::for_each(m_selected, [&](const Outline& outline) { points += outline.runs.pointCount(); });
    m_isSelectedLate = points > kMostAtOnce;
    m_afterFrame.stop();
    m_change += wasEmpty && m_selected.empty() ? 0 : 1;
    m_views.requestOverlay();
}

void ElementOutlines::showSelected() {
    m_isSelectedLate = false;
    ++m_change;
    m_views.requestOverlay();
}

OutlineStrokes ElementOutlines::strokesOver(const BoardView& view) const {
    OutlineSight sight{
        view.controller().clipFromBoard(), view.controller().viewport(), view.position(), {}, m_pointers[rowOf(view)]};
    if (view.cut() != nullptr) {
        sight.cut = view.cut()->plane;
    }
    OutlineStrokes strokes(sight);
    const std::vector<render::ZRange> heights = view.drawnHeights();
    const double faces = view.drawnFaces() * base::kNmPerMm;
    const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
    const auto add = [&](const Outline& outline, Ink ink) {
        const std::size_t row = outline.layer.row();
        const bool isOfHiddenNet = outline.net && m_nets.isHidden(*outline.net);
        if (outline.runs.isEmpty() || row >= heights.size() || !view.styles()[row].isVisible || isOfHiddenNet) {
            return;
        }
        const auto [bottom, top] = outline.heights.on(
            {.bottom = heights[row].z0 * base::kNmPerMm, .top = heights[row].z1 * base::kNmPerMm, .faces = faces});
        strokes.add(outline.runs, static_cast<float>((isFromBelow ? bottom : top) / base::kNmPerMm), ink);
    };
    add(m_hovered, Hovered);  // first: what is too much goes from the end
    for (std::size_t i = 0; !m_isSelectedLate && i < m_selected.size(); ++i) {
        add(m_selected[i], m_selected[i].isNear ? Near : Selected);
    }
    strokes.thin();
    return strokes;
}

ElementOutlines::Looks ElementOutlines::looksOf(const BoardView& view) const {
    Looks looks{m_change, view.controller().clipFromBoard(), view.controller().viewport(), view.drawnHeights(), {}, {}};
    if (view.cut() != nullptr) {
        looks.cut = view.cut()->plane;
    }
    std::ranges::transform(view.styles(), std::back_inserter(looks.visibility), &render::LayerStyle::isVisible);
    return looks;
}

void ElementOutlines::paint(QPainter& painter, const BoardView& view) {
    if (m_hovered.runs.isEmpty() && m_selected.empty()) {
        return;
    }
    if (m_isSelectedLate && !m_afterFrame.isActive()) {
        m_afterFrame.start(0);
    }
    const Looks looks = looksOf(view);
    if (!m_onViews[rowOf(view)].picture.show(painter, looks)) {
        paintOrKeep(painter, view, looks);
    }
}

/// Large strokes take Qt 3 to 4 ms, as threads are woken for pieces of them; a picture of them takes 1, but 10 when it
/// is made.
void ElementOutlines::paintOrKeep(QPainter& painter, const BoardView& view, const Looks& looks) {
    OnView& own = m_onViews[rowOf(view)];
    const OutlineStrokes strokes = strokesOver(view);
    const QRect box = strokes.box(2.0 * kWidth);
    const bool isLarge = box.width() * box.height() > kSmall;
    if (isLarge && m_isAtRest && own.painted == looks) {
        own.picture.keep(painter, looks, box, [&](QPainter& kept) { paintStrokes(kept, strokes); });
        return;
    }
    paintStrokes(painter, strokes);
    own.painted = looks;
    if (isLarge) {
        m_isAtRest = false;
        m_rest.start();
    }
}

void ElementOutlines::paintStrokes(QPainter& painter, const OutlineStrokes& strokes) {
    for (const Ink ink : {Near, Selected, Hovered}) {
        for (const auto& [colour, width] : {std::pair(kShadow, 2.0 * kWidth), std::pair(kInks[ink], kWidth)}) {
            painter.setPen(QPen(colour, width));
            for (const OutlineStrokes::Line& line : strokes.lines()) {
                if (line.ink == ink) {
                    drawInPieces(painter, line.points);
                }
            }
        }
    }
}

}  // namespace ui
