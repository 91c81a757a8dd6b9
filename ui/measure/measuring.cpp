#include "ui/measure/measuring.h"

#include <QGuiApplication>
#include <QWindow>
#include <array>

namespace ui {

using model::Measurement;
using model::SnapKind;

namespace {

struct ToolFacts {
    Catch what;
    std::size_t clicks;
    std::array<const char*, 3> hints;  ///< what each click is for
    const char* nothing;               ///< a click that catches nothing
};

/// As in Measuring::Tool.
constexpr ToolFacts kTools[] = {
    {Catch::Points, 0, {}, ""},
    {Catch::Points,
     2,
     {"Click the first point; Alt catches nothing", "Click the second point; Shift straight, Ctrl in steps of 45°"},
     "Click on the board"},
    {Catch::Elements,
     2,
     {"Click the first element to measure from edge to edge", "Click the second element"},
     "There is no element under the cursor"},
    {Catch::Points,
     3,
     {"Click the corner of the angle", "Click a point on its first arm; Shift straight, Ctrl in steps of 45°",
      "Click a point on its second arm; Shift straight, Ctrl in steps of 45°"},
     "Click on the board"},
    {Catch::Straight,
     2,
     {"Click the first straight stroke or side", "Click the second straight stroke or side"},
     "There is nothing straight under the cursor"},
    {Catch::Round,
     1,
     {"Click an arc, a round pad or a hole for its radius"},
     "There is nothing round under the cursor"},
    {Catch::Copper,
     2,
     {"Click where the length along a net begins", "Click where it ends, on copper of the same net"},
     "There is no copper of a net under the cursor"},
};

const ToolFacts& factsOf(Measuring::Tool tool) {
    return kTools[static_cast<std::size_t>(tool)];
}

void showCursor(BoardView& view, Qt::CursorShape shape) {
    if (auto* window = qobject_cast<QWindow*>(&view.canvas())) {
        window->setCursor(shape);
    } else if (auto* widget = qobject_cast<QWidget*>(&view.canvas())) {
        widget->setCursor(shape);
    }
}

}  // namespace

Measuring::Measuring(BoardViews& views, Probing& probing, SavedMeasurements& kept, QObject* parent)
    : QObject(parent), m_views(views), m_probing(probing), m_kept(kept), m_cursor(probing) {
    for (BoardView* view : views.both()) {
        watch(*view);
    }
    connect(&kept, &SavedMeasurements::changed, this, [this] { m_views.requestOverlay(); });
    connect(&m_path.background(), &Background::progressed, this, &Measuring::progressed);
    connect(&m_path.background(), &Background::finished, this, &Measuring::takePath);
}

void Measuring::watch(BoardView& view) {
    CameraController& controller = view.controller();
    connect(&controller, &CameraController::hovered, this,
            [this, &view](QPointF position) { hover(view, position, QGuiApplication::keyboardModifiers()); });
    connect(&controller, &CameraController::left, this, [this] {
        m_hoverView = nullptr;
        m_under.reset();
        if (m_tool != Tool::None) {
            m_views.requestOverlay();
        }
    });
    const auto onClick = [this, &view](QPointF position, Qt::KeyboardModifiers modifiers) {
        click(view, position, modifiers);
    };
    connect(&controller, &CameraController::clicked, this, onClick);
    connect(&controller, &CameraController::doubleClicked, this, onClick);  // two points in quick succession
    view.addPainter([this, &view](QPainter& painter) { paint(painter, view); });
}

void Measuring::setBoard(const LoadedBoard& board) {
    m_path.cancel();
    m_index = board.index;
    m_position.origin = board.model->origin;
    m_cursor.setBoard(board.index);
    m_hoverView = nullptr;
    m_isLatestFull = false;
    m_shownSpacing.reset();
    setTool(Tool::None);
}

void Measuring::setHeights(std::shared_ptr<const model::Document> document) {
    if (m_index) {
        if (m_path.isRunning()) {
            stepBack();  // heights of holes would be those of before
        }
        m_index = model::withHeights(*m_index, std::move(document));
    }
}

void Measuring::setUnit(LengthUnit unit) {
    m_unit = unit;
    m_kept.list().setUnit(unit);
    m_views.requestOverlay();
}

void Measuring::setTool(Tool tool) {
    m_tool = m_index ? tool : Tool::None;
    clearClicks();
    m_under.reset();
    m_probing.setSelecting(m_tool == Tool::None);
    for (BoardView* view : m_views.both()) {
        showCursor(*view, m_tool == Tool::None ? Qt::ArrowCursor : Qt::CrossCursor);
    }
    if (m_hoverView != nullptr) {
        hover(*m_hoverView, m_hoverAt, Qt::NoModifier);
    }
    emit toolChanged();
    tellNextClick();
}

bool Measuring::stepBack() {
    if (m_path.isRunning()) {
        m_path.cancel();
        emit followingEnded();
        emit reported(QStringLiteral("Stopped"));
    } else if (!m_clicked.empty()) {
        m_clicked.pop_back();
        if (m_clicked.empty()) {
            clearClicks();
        }
        m_views.requestOverlay();
        tellNextClick();
    } else if (m_tool != Tool::None) {
        setTool(Tool::None);
    } else {
        return false;
    }
    return true;
}

void Measuring::tellNextClick() {
    if (m_tool != Tool::None) {
        emit reported(QString::fromUtf8(factsOf(m_tool).hints[m_clicked.size()]));
    }
}

void Measuring::clearClicks() {
    m_clicked.clear();
    m_views.requestOverlay();
    emit begunAt(std::nullopt);
}

std::optional<Caught> Measuring::catchAt(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    const auto from = m_clicked.empty() ? std::nullopt : std::optional(m_clicked.front().at);
    return m_cursor.at(view, position, factsOf(m_tool).what, modifiers, from);
}

void Measuring::hover(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    m_hoverView = &view;
    m_hoverAt = position;
    // What is under the cursor is outlined already: elements need no mark of their own.
    if (m_tool != Tool::None && m_tool != Tool::Objects) {
        m_under = catchAt(view, position, modifiers);
        m_views.requestOverlay();
    }
}

void Measuring::click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    if (m_tool == Tool::None) {
        return;
    }
    const std::optional<Caught> caught = catchAt(view, position, modifiers);
    if (!caught) {
        tellWhyNothing(view, position);
        return;
    }
    if (const QString refusal = refusalOf(*caught); !refusal.isEmpty()) {
        emit reported(refusal);
        return;
    }
    m_clicked.push_back(*caught);
    m_under = m_tool == Tool::Objects ? std::nullopt : caught;
    m_views.requestOverlay();
    if (m_clicked.size() < factsOf(m_tool).clicks) {
        if (m_tool == Tool::Points) {
            emit begunAt(caught->at);
        }
        tellNextClick();
        return;
    }
    const std::vector<Caught> clicked = m_clicked;
    clearClicks();
    measure(clicked);
}

void Measuring::tellWhyNothing(const BoardView& view, QPointF position) {
    const auto empty = m_tool == Tool::Objects ? m_cursor.emptyAt(view, position) : std::nullopt;
    emit reported(empty ? QStringLiteral("%1 covers nothing, so it has no distance")
                              .arg(QString::fromStdString(model::nameOf(*m_index, *empty)))
                        : QString::fromUtf8(factsOf(m_tool).nothing));
}

QString Measuring::refusalOf(const Caught& caught) const {
    if (m_tool != Tool::Length || m_clicked.empty()) {
        return {};
    }
    const Caught& first = m_clicked.front();
    const model::NetId net = model::netOf(*m_index, *first.element);
    const model::NetId other = model::netOf(*m_index, *caught.element);
    if (net == other && first.element->copy == caught.element->copy) {
        return {};
    }
    const auto name = [&](const Caught& of, model::NetId id) {
        return QString::fromStdString(model::nameOf(*m_index, model::NetOfCopy{of.element->copy, id}));
    };
    return QStringLiteral("That is %1: click copper of %2, where the length begins")
        .arg(name(caught, other), name(first, net));
}

void Measuring::measure(const std::vector<Caught>& clicked) {
    m_tool == Tool::Length ? followNet(clicked[0], clicked[1]) : keep(measured(clicked));
}

base::Result<Measurement> Measuring::measured(const std::vector<Caught>& clicked) const {
    switch (m_tool) {
        case Tool::Objects: return edgeToEdge(*m_index, *clicked[0].element, *clicked[1].element);
        case Tool::Angle: return angleAt(*m_index, clicked[0], clicked[1], clicked[2]);
        case Tool::Lines: return angleOfLines(*m_index, clicked[0], clicked[1]);
        case Tool::Radius: return radiusOf(*m_index, clicked[0]);
        default: return pointToPoint(*m_index, clicked[0], clicked[1]);
    }
}

std::optional<Measurement> Measuring::preview() const {
    if (!m_under || m_tool == Tool::Length) {
        return std::nullopt;
    }
    std::vector<Caught> clicked = m_clicked;
    clicked.push_back(*m_under);
    if (clicked.size() == factsOf(m_tool).clicks) {
        const auto measurement = measured(clicked);
        return measurement ? std::optional(*measurement) : std::nullopt;
    }
    return m_tool == Tool::Angle && clicked.size() == 2
               ? std::optional(pointToPoint(*m_index, clicked[0], clicked[1]))  // the first arm
               : std::nullopt;
}

void Measuring::followNet(const Caught& from, const Caught& to) {
    m_following = {m_index, from, to};
    const auto follow = [work = m_following](base::Progress& progress) {
        const model::BoardIndex& index = *work.index;
        const model::BoardElement at = *work.from.element;
        return model::pathAlong(index, {at.copy, model::netOf(index, at)}, pathEndOf(index, work.from),
                                pathEndOf(index, work.to), progress);
    };
    m_path.ask(follow, "Following the net", "There is not enough memory to follow this net");
    emit followingBegan();
}

void Measuring::takePath() {
    const auto path = m_path.take();
    const Following done = std::exchange(m_following, {});
    emit followingEnded();
    if (path) {
        keep(lengthAlong(*done.index, done.from, done.to, *path));
    } else {
        emit reported(QString::fromStdString(path.error().text));
    }
}

void Measuring::measureSpacingAtCursor() {
    if (m_hoverView == nullptr || !m_cursor.isOnBoard(*m_hoverView, m_hoverAt)) {
        emit reported(QStringLiteral("Point at the board to measure the gap there"));
        return;
    }
    const auto gap = m_cursor.spacingAt(*m_hoverView, m_hoverAt);
    if (!gap) {
        emit reported(QStringLiteral("There is no gap between two nets within 10 mm of the cursor"));
        return;
    }
    keep(spacingOn(*m_index, *gap));
}

void Measuring::showSpacing(const std::optional<model::LocalSpacing>& gap) {
    m_shownSpacing = gap;
    m_views.requestOverlay();
}

void Measuring::keep(const base::Result<Measurement>& measurement) {
    if (!measurement) {
        emit reported(QString::fromStdString(measurement.error().text));
        return;
    }
    m_isLatestFull = true;
    m_kept.keep(*measurement);
    emit reported((QStringList{valueText(*measurement)} + remarksText(*measurement)).join(QStringLiteral("; ")));
}

void Measuring::goTo(int row) {
    const Measurement& measurement = m_kept.list().measurements()[static_cast<std::size_t>(row)];
    if (!m_index || !m_kept.isHere(measurement)) {
        emit reported(QStringLiteral("It was measured in step %1").arg(QString::fromStdString(measurement.step)));
        return;
    }
    for (BoardView* view : m_views.both()) {
        const DrawnHeights heights(*view, m_position, *m_index->board);
        glm::vec3 low = heights.at(measurement.from);
        glm::vec3 high = low;
        for (const auto& [location, layer] : locationsOf(measurement)) {
            low = glm::min(low, heights.at(location, layer));
            high = glm::max(high, heights.at(location, layer));
        }
        view->controller().show(low, high);
    }
}

void Measuring::paint(QPainter& painter, const BoardView& view) const {
    if (!m_index) {
        return;
    }
    MeasurementPainter on(painter, view, m_position, *m_index->board);
    const auto& measurements = m_kept.list().measurements();
    for (std::size_t row = 0; row < measurements.size(); ++row) {
        if (measurements[row].isShown && m_kept.isHere(measurements[row])) {
            on.paint(measurements[row], m_unit, m_isLatestFull && row + 1 == measurements.size());
        }
    }
    if (m_shownSpacing) {
        on.paint(spacingOn(*m_index, *m_shownSpacing), m_unit, false);
    }
    paintClicks(on, view);
    on.paintLabels();
}

void Measuring::paintClicks(MeasurementPainter& on, const BoardView& view) const {
    const std::optional<Measurement> coming = preview();
    if (coming) {
        on.paint(*coming, m_unit, m_tool != Tool::Angle || m_clicked.size() == 2);
    }
    const auto mark = [&](const Caught& caught) {
        const model::MeasuredEnd end = endOf(*m_index, caught);
        const bool isPoint = caught.kind != SnapKind::Free || !caught.element;
        on.paintSnap(end, caught.kind,
                     QString::fromStdString(isPoint           ? end.snap
                                            : end.net.empty() ? end.layer
                                                              : end.net));
    };
    if (!coming) {
        std::ranges::for_each(m_clicked, mark);
    }
    if (m_under && m_hoverView == &view) {
        mark(*m_under);
    }
}

}  // namespace ui
