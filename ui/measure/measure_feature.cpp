#include "ui/measure/measure_feature.h"

#include <QGuiApplication>
#include <QWindow>
#include <numeric>

#include "model/base/assert.h"
#include "model/board/single_element.h"
#include "model/measure/restacked.h"
#include "ui/common/net_name.h"
#include "ui/common/texts.h"
#include "ui/measure/measurement_panel.h"
#include "ui/measure/tool_facts.h"
#include "ui/views/board_views.h"
#include "ui/views/position_readout.h"

namespace ui {

using model::Measurement;
using model::SnapKind;

namespace {

/// So long the cursor rests before a length is followed to it.
constexpr int kRestMs = 80;

/// Measured twice in a row.
bool isSame(const Measurement& entry, Measurement measurement) {
    measurement.name = entry.name;
    measurement.step = entry.step;
    measurement.isShown = entry.isShown;
    return entry == measurement;
}

void showCursor(BoardView& view, Qt::CursorShape shape) {
    if (auto* window = qobject_cast<QWindow*>(&view.canvas())) {
        window->setCursor(shape);
    } else if (auto* widget = qobject_cast<QWidget*>(&view.canvas())) {
        widget->setCursor(shape);
    }
}

}  // namespace

MeasureFeature::MeasureFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_hint(context.workspace),
      m_views(context.views),
      m_probing(context.probing),
      m_readout(context.position),
      m_list(this),
      m_saved(context.workspace, tr("The measurements"), &model::session::Session::measurements,
              model::session::saveMeasurements,
              [this](const auto& measurements) {
                  m_list.setMeasurements(measurements);
                  m_views.requestOverlay();
              }),
      m_cursor(context.probing) {
    for (BoardView* view : m_views.both()) {
        watch(*view);
    }
    connectCommands(context);
    addPanel(context);
    context.escapes.emplace(EscapeRank::Tool, [this] { return stepBack(); });
    const auto repaint = [this] { m_views.requestOverlay(); };
    connect(&m_workspace, &Workspace::unitChanged, this, repaint);
    connect(&m_workspace, &Workspace::boardOpened, this, &MeasureFeature::setBoard);
    connect(&m_workspace, &Workspace::restacked, this, &MeasureFeature::setHeights);
    connect(&m_workspace, &Workspace::spacingWanted, this, &MeasureFeature::showSpacing);
    connect(&m_probing, &Probing::beneathWanted, this, &MeasureFeature::stepBeneath);
    connect(&m_workspace.selection(), &SelectionModel::hoverChanged, this, &MeasureFeature::correctHighlight);
    m_workspace.watch(m_path.background(), [] { return tr("Length"); });
    connect(&m_path.background(), &Background::finished, this, &MeasureFeature::takePath);
    connect(&m_pathAhead.background(), &Background::finished, this, &MeasureFeature::takePathAhead);
    m_restBeforePath.setSingleShot(true);
    m_restBeforePath.setInterval(kRestMs);
    connect(&m_restBeforePath, &QTimer::timeout, this, &MeasureFeature::followAhead);
}

void MeasureFeature::connectCommands(FeatureContext& context) {
    constexpr std::pair<ActionId, Tool> kActions[] = {
        {ActionId::MeasurePoints, Tool::Points}, {ActionId::MeasureObjects, Tool::Objects},
        {ActionId::MeasureAngle, Tool::Angle},   {ActionId::MeasureLines, Tool::Lines},
        {ActionId::MeasureRadius, Tool::Radius}, {ActionId::MeasureLength, Tool::Length}};
    for (const auto& [id, tool] : kActions) {
        QAction& action = context.actions[id];
        context.on(id, this, [this, use = tool](bool isOn) { setTool(isOn ? use : Tool::None); });
        connect(this, &MeasureFeature::toolChanged, &action,
                [this, &action, own = tool] { action.setChecked(m_tool == own); });
    }
    alternateWith(context.actions[ActionId::DrawSection]);
    context.on(ActionId::MeasureSpacing, this, [this] { measureSpacingAtCursor(); });
    m_showing = &context.actions[ActionId::ShowMeasurements];
    m_showing->setChecked(true);
    context.on(ActionId::ShowMeasurements, this, [this] { m_views.requestOverlay(); });
    context.on(ActionId::DeleteMeasurements, this, [this] { deleteAll(); });
    context.on(ActionId::ExportMeasurements, this, [this, &context] { exportTable(context); });
}

void MeasureFeature::alternateWith(QAction& drawing) {
    connect(&drawing, &QAction::toggled, this, [this](bool isOn) {
        if (isOn && m_tool != Tool::None) {
            setTool(Tool::None);
        }
    });
    connect(this, &MeasureFeature::toolChanged, &drawing, [this, &drawing] {
        if (m_tool != Tool::None && drawing.isChecked()) {
            drawing.trigger();
        }
    });
}

void MeasureFeature::deleteAll() {
    std::vector<int> rows(m_saved.entries().size());
    std::iota(rows.begin(), rows.end(), 0);
    if (rows.empty()) {
        m_workspace.report(tr("There are no measurements"));
    } else {
        const auto count = rows.size();
        m_saved.remove(tr("deleting measurements"), std::move(rows));
        m_workspace.report(count == 1 ? tr("1 measurement deleted") : tr("%L1 measurements deleted").arg(count));
    }
}

void MeasureFeature::addPanel(FeatureContext& context) {
    connect(&m_workspace, &Workspace::unitChanged, &m_list, &MeasurementModel::setUnit);
    connect(&m_list, &MeasurementModel::renamed, this,
            [this](int row, const QString& name) { m_saved.rename(tr("the name of a measurement"), row, name); });
    connect(&m_list, &MeasurementModel::shownChanged, this, [this](int row, bool isShown) {
        m_saved.change(isShown ? tr("showing a measurement") : tr("hiding a measurement"), row,
                       [isShown](Measurement& measurement) { measurement.isShown = isShown; });
    });
    auto* panel = new MeasurementPanel(m_list, context.actions);
    connect(panel, &MeasurementPanel::chosen, this, &MeasureFeature::goTo);
    connect(panel, &MeasurementPanel::deleteRequested, this,
            [this](const auto& rows) { m_saved.remove(tr("deleting measurements"), rows); });
    connect(this, &MeasureFeature::measuredNew, panel, &MeasurementPanel::scrollToLast);
    context.addPanel({ActionId::ShowMeasurementsDock, "measurements", tr("Measurements"), Qt::BottomDockWidgetArea},
                     *panel);
}

void MeasureFeature::exportTable(FeatureContext& context) {
    if (m_saved.entries().empty()) {
        m_workspace.report(tr("There are no measurements to export"));
        return;
    }
    context.saveFile(tr("Export measurements"), tr("measurements"), {tr("Tables (*.csv)")},
                     [this](const QString&) { return model::measurementsCsv(m_saved.entries()); });
}

void MeasureFeature::watch(BoardView& view) {
    CameraController& controller = view.controller();
    connect(&controller, &CameraController::hovered, this, [this, &view](QPointF position) {
        if (m_hoverView == nullptr && m_tool != Tool::None) {
            reportNextClick();  // a panel where the tool measures too may have said something else
        }
        hover(view, position, QGuiApplication::keyboardModifiers());
    });
    connect(&controller, &CameraController::left, this, [this] {
        m_hoverView = nullptr;
        m_under.reset();
        if (m_tool != Tool::None) {
            updatePreview();
        }
    });
    const auto onClick = [this, &view](QPointF position, Qt::KeyboardModifiers modifiers) {
        click(view, position, modifiers);
    };
    connect(&controller, &CameraController::clicked, this, onClick);
    connect(&controller, &CameraController::doubleClicked, this, onClick);  // two points in quick succession
    view.addPainter([this, &view](QPainter& painter) { paint(painter, view); });
}

void MeasureFeature::setBoard(const LoadedBoard& board) {
    m_index = board.index;
    m_cursor.setBoard(board.index);
    m_hoverView = nullptr;
    m_isLatestFull = false;
    m_shownSpacing.reset();
    setTool(Tool::None);
}

void MeasureFeature::setHeights(const LoadedBoard& board) {
    m_path.cancel();  // heights of holes would be those of before
    m_pathAhead.cancel();
    const std::shared_ptr<const model::BoardIndex> before = std::exchange(m_index, board.index);
    if (before && m_index) {
        m_saved.follow([&](Measurement& measurement) {
            measurement = model::restacked(*before->board, *m_index->board, std::move(measurement));
        });
        updatePreview();
    }
}

void MeasureFeature::setTool(Tool tool) {
    m_tool = m_index ? tool : Tool::None;
    m_under.reset();  // what another tool has caught is nothing that this one measures
    m_cursor.stopStepping();
    clearClicks();
    m_probing.setSelecting(m_tool == Tool::None);
    for (BoardView* view : m_views.both()) {
        showCursor(*view, m_tool == Tool::None ? Qt::ArrowCursor : Qt::CrossCursor);
    }
    if (m_hoverView != nullptr) {
        hover(*m_hoverView, m_hoverAt, Qt::NoModifier);
    }
    emit toolChanged();
    reportNextClick();
}

bool MeasureFeature::stepBack() {
    if (!m_clicked.empty()) {
        m_clicked.pop_back();
        if (m_clicked.empty()) {
            clearClicks();
        }
        markClicked();
        updatePreview();
        reportNextClick();
    } else if (m_tool != Tool::None) {
        setTool(Tool::None);
    } else {
        return false;
    }
    return true;
}

void MeasureFeature::reportNextClick() {
    m_tool != Tool::None ? m_hint.show(tr(factsOf(m_tool).hints[m_clicked.size()])) : m_hint.end();
}

void MeasureFeature::clearClicks() {
    m_clicked.clear();
    markClicked();
    updatePreview();
    m_readout.measureFrom(std::nullopt);
}

std::optional<Caught> MeasureFeature::catchAt(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    const Caught* first = m_clicked.empty() ? nullptr : &m_clicked.front();
    return m_cursor.at(view, position, factsOf(m_tool).what, modifiers, first);
}

void MeasureFeature::hover(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    m_hoverView = &view;
    m_hoverAt = position;
    if (m_tool != Tool::None) {
        m_under = catchAt(view, position, modifiers);
        updatePreview();
        // Probing highlights once the pointer rests, and takes back what is not the uppermost as soon as it moves.
        const bool stays = m_highlighted && m_under && m_under->element == m_highlighted;
        if (stays || m_workspace.selection().hovered()) {
            highlightCaught();
        }
    }
}

void MeasureFeature::stepBeneath(int by) {
    m_cursor.step(by);
    if (m_hoverView != nullptr) {
        hover(*m_hoverView, m_hoverAt, Qt::NoModifier);
        highlightCaught();
    }
}

/// Probing knows only what is uppermost. The camera may have moved since the pointer has.
void MeasureFeature::correctHighlight() {
    const auto hovered = m_workspace.selection().hovered();
    const bool isTaken = m_under && m_under->element == hovered;
    if (m_tool == Tool::Objects && m_hoverView != nullptr && hovered && !isTaken) {
        hover(*m_hoverView, m_hoverAt, QGuiApplication::keyboardModifiers());
    }
}

void MeasureFeature::highlightCaught() {
    m_highlighted.reset();
    if (m_tool == Tool::Objects && m_hoverView != nullptr) {
        m_highlighted = m_under ? m_under->element : std::nullopt;
        m_workspace.selection().hover(m_highlighted);
    }
}

void MeasureFeature::updatePreview() {
    m_coming = preview();
    m_readout.snapTo(m_under ? std::optional(m_under->at) : std::nullopt);
    m_pathAhead.cancel();
    m_restBeforePath.start();
    m_views.requestOverlay();
}

void MeasureFeature::markClicked() {
    std::vector<model::BoardElement> elements;
    for (const Caught& caught : m_clicked) {
        if (m_tool == Tool::Objects && caught.element) {
            elements.push_back(*caught.element);
        }
    }
    m_workspace.selection().mark(std::move(elements));
}

void MeasureFeature::click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    if (m_tool == Tool::None) {
        return;
    }
    const std::optional<Caught> caught = catchAt(view, position, modifiers);
    if (!caught) {
        reportWhyNothing(view, position);
        return;
    }
    if (const QString refusal = refusalOf(*caught); !refusal.isEmpty()) {
        m_hint.show(refusal);
        return;
    }
    m_clicked.push_back(*caught);
    m_under = caught;
    if (m_tool == Tool::Objects) {
        m_cursor.stopStepping();  // the next click there begins with what is seen
    }
    markClicked();
    updatePreview();
    if (m_clicked.size() < factsOf(m_tool).clicks) {
        if (m_tool == Tool::Points) {
            m_readout.measureFrom(caught->at);
        }
        reportNextClick();
        return;
    }
    const std::vector<Caught> clicked = m_clicked;
    clearClicks();
    measure(clicked);
}

void MeasureFeature::reportWhyNothing(const BoardView& view, QPointF position) {
    const auto empty = m_tool == Tool::Objects ? m_cursor.emptyAt(view, position) : std::nullopt;
    m_hint.show(empty ? tr("This element on %1 covers nothing, so it has no distance").arg(layerNameOf(*empty))
                      : tr(factsOf(m_tool).nothing));
}

QString MeasureFeature::layerNameOf(const model::BoardElement& at) const {
    return QString::fromStdString(m_index->board->layer(model::layerOf(*m_index, at)).name);
}

QString MeasureFeature::refusalOf(const Caught& caught) const {
    if (m_tool != Tool::Length || m_clicked.empty()) {
        return {};
    }
    const Caught& first = m_clicked.front();
    ASSERT(first.element && caught.element);  // Catch::Copper has one
    const model::NetId net = model::netOf(*m_index, *first.element);
    const model::NetId other = model::netOf(*m_index, *caught.element);
    if (net == other && first.element->copy == caught.element->copy) {
        return {};
    }
    const auto name = [&](const Caught& of, model::NetId id) {
        return QString::fromStdString(model::nameOf(*m_index, model::NetOfCopy{of.element->copy, id}));
    };
    return tr("That is %1: click copper of %2, where the length begins").arg(name(caught, other), name(first, net));
}

void MeasureFeature::measure(const std::vector<Caught>& clicked) {
    if (m_tool == Tool::Length) {
        followNet(clicked[0], clicked[1]);
        return;
    }
    base::Result<Measurement> measurement = measured(clicked);
    if (m_tool == Tool::Objects && measurement && clicked[0].element && clicked[1].element) {
        noteOnNets(clicked, *measurement);
    }
    save(measurement);
}

void MeasureFeature::noteOnNets(const std::vector<Caught>& clicked, Measurement& measurement) const {
    const auto closer = netsCloserThan(*m_index, measurement.distance(), *clicked[0].element, *clicked[1].element);
    if (closer) {
        const QString length = fixedLengthInBoth(closer->distance, m_workspace.unit());
        const QString note = closer->layer.empty() ? tr("their nets come as near as %1 elsewhere").arg(length)
                                                   : tr("their nets come as near as %1 elsewhere, on %2")
                                                         .arg(length, QString::fromStdString(closer->layer));
        measurement.notes.push_back(note.toStdString());
    }
}

base::Result<Measurement> MeasureFeature::measured(const std::vector<Caught>& clicked) const {
    switch (m_tool) {
        case Tool::Objects: return edgeToEdge(*m_index, clicked[0], clicked[1]);
        case Tool::Angle: return angleAt(*m_index, clicked[0], clicked[1], clicked[2]);
        case Tool::Lines: return angleOfLines(*m_index, clicked[0], clicked[1]);
        case Tool::Radius: return radiusOf(*m_index, clicked[0]);
        default: return pointToPoint(*m_index, clicked[0], clicked[1]);
    }
}

std::optional<Measurement> MeasureFeature::preview() const {
    if (!m_under || m_tool == Tool::Length) {
        return std::nullopt;
    }
    std::vector<Caught> clicked = m_clicked;
    clicked.push_back(*m_under);
    if (clicked.size() == factsOf(m_tool).clicks && isQuick(clicked)) {
        const auto measurement = measured(clicked);
        return measurement ? std::optional(*measurement) : std::nullopt;
    }
    return m_tool == Tool::Angle && clicked.size() == 2
               ? std::optional(pointToPoint(*m_index, clicked[0], clicked[1]))  // the first arm
               : std::nullopt;
}

/// Large areas are left to a click: the value would come behind the cursor.
bool MeasureFeature::isQuick(const std::vector<Caught>& clicked) const {
    constexpr std::size_t kMostNodes = 4'000;
    std::size_t nodes = 0;
    for (const Caught& caught : clicked) {
        if (m_tool == Tool::Objects && caught.element) {
            nodes += model::nodeCountOf(m_index->stepOf(caught.element->copy), caught.element->element);
        }
    }
    return nodes <= kMostNodes;
}

void MeasureFeature::followNet(const Caught& from, const Caught& to) {
    m_following = {m_index, from, to};
    m_path.run(pathOf(m_following), tr("Following the net"), tr("There is not enough memory to follow this net"));
}

BackgroundResult<model::NetPath>::Work MeasureFeature::pathOf(const Following& work) {
    return [work](base::Progress& progress) {
        const model::BoardIndex& index = *work.index;
        const model::BoardElement at = *work.from.element;
        return model::pathAlong(index, {at.copy, model::netOf(index, at)}, pathEndOf(index, work.from),
                                pathEndOf(index, work.to), progress);
    };
}

void MeasureFeature::followAhead() {
    if (m_tool == Tool::Length && m_clicked.size() == 1 && m_under && refusalOf(*m_under).isEmpty()) {
        m_ahead = {m_index, m_clicked.front(), *m_under};
        m_pathAhead.run(pathOf(m_ahead), tr("Following the net"), {});
    }
}

void MeasureFeature::takePathAhead() {
    const auto path = m_pathAhead.take();
    const auto length =
        path ? lengthAlong(*m_ahead.index, m_ahead.from, m_ahead.to, *path) : base::Result<Measurement>(path.error());
    if (length) {
        m_coming = *length;
        m_views.requestOverlay();
    }
}

void MeasureFeature::takePath() {
    const auto path = m_path.take();
    const Following done = std::exchange(m_following, {});
    if (path) {
        save(lengthAlong(*done.index, done.from, done.to, *path));
    } else {
        m_workspace.report(path.error().text);
    }
}

void MeasureFeature::measureSpacingAtCursor() {
    if (m_hoverView == nullptr || !m_cursor.isOnBoard(*m_hoverView, m_hoverAt)) {
        m_workspace.report(tr("Point at the board to measure the spacing there"));
        return;
    }
    const auto gap = m_cursor.spacingAt(*m_hoverView, m_hoverAt);
    if (!gap) {
        m_workspace.report(tr("There is no spacing between two nets within 10 mm of the pointer"));
        return;
    }
    save(spacingOn(*m_index, {gap->spacing, gap->from, gap->to, gap->layer, gap->layer}));
}

void MeasureFeature::showSpacing(const std::optional<ShownSpacing>& spacing) {
    m_shownSpacing = spacing;
    m_views.requestOverlay();
}

void MeasureFeature::save(const base::Result<Measurement>& measurement) {
    if (!measurement) {
        m_workspace.report(measurement.error().text);
        return;
    }
    m_isLatestFull = true;
    m_showing->setChecked(true);
    if (const auto& entries = m_saved.entries(); !entries.empty() && isSame(entries.back(), *measurement)) {
        m_workspace.report(tr("Measured already: %1").arg(valueText(*measurement, m_workspace.unit())));
        return;
    }
    m_saved.add(tr("a measurement"), *measurement, "");
    emit measuredNew();
    m_workspace.report((QStringList{valueText(*measurement, m_workspace.unit())} + textsOf(measurement->notes))
                           .join(QStringLiteral("; ")));
}

void MeasureFeature::goTo(int row) {
    const Measurement& measurement = m_saved.entries()[static_cast<std::size_t>(row)];
    if (!m_index || !m_workspace.isOpen(measurement.step)) {
        m_workspace.report(tr("It was measured in step %1").arg(QString::fromStdString(measurement.step)));
        return;
    }
    for (BoardView* view : m_views.both()) {
        const DrawnHeights heights(*view, *m_index->board);
        glm::vec3 low = heights.at(measurement.from);
        glm::vec3 high = low;
        for (const auto& [location, layer] : locationsOf(measurement)) {
            low = glm::min(low, heights.at(location, layer));
            high = glm::max(high, heights.at(location, layer));
        }
        view->controller().show(low, high);
    }
}

void MeasureFeature::paint(QPainter& painter, const BoardView& view) const {
    if (!m_index) {
        return;
    }
    MeasurementPainter on(painter, view, *m_index->board);
    const auto& measurements = m_saved.entries();
    for (std::size_t row = 0; row < measurements.size(); ++row) {
        const bool isShown = m_showing->isChecked() && measurements[row].isShown;
        if (isShown && m_workspace.isOpen(measurements[row].step)) {
            on.paint(measurements[row], m_workspace.unit(), m_isLatestFull && row + 1 == measurements.size());
        }
    }
    if (m_shownSpacing) {
        on.paint(spacingOn(*m_index, *m_shownSpacing), m_workspace.unit(), false);
    }
    paintClicks(on, view);
    on.paintLabels();
}

void MeasureFeature::paintClicks(MeasurementPainter& on, const BoardView& view) const {
    if (m_coming) {
        on.paint(*m_coming, m_workspace.unit(), m_tool != Tool::Angle || m_clicked.size() == 2);
    }
    const auto mark = [&](const Caught& caught) {
        const model::MeasuredEnd end = endOf(*m_index, caught);
        QStringList words;
        for (const std::string& word : {caught.kind == SnapKind::Free ? std::string() : end.snap, end.layer,
                                        model::readableName(end.net), end.item}) {
            words += word.empty() ? QStringList() : QStringList{QString::fromStdString(word)};
        }
        on.paintSnap(end, caught.kind, words.join(QStringLiteral(" · ")));
    };
    if (!m_coming) {
        std::ranges::for_each(m_clicked, mark);
    }
    // What is under the cursor is outlined already: elements need no mark of their own.
    if (m_under && m_hoverView == &view && (m_tool != Tool::Objects || m_under->isOnEdge)) {
        mark(*m_under);
    }
}

}  // namespace ui
