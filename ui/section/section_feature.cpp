#include "ui/section/section_feature.h"

#include <QComboBox>
#include <QDockWidget>
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "model/board/board_heights.h"
#include "model/export/section_export.h"
#include "model/section/net_line.h"
#include "ui/common/table_view.h"
#include "ui/common/texts.h"
#include "ui/layers/layer_model.h"
#include "ui/section/section_pdf.h"
#include "ui/views/board_views.h"
#include "ui/views/probing.h"
#include "ui/workspace/read_anew.h"

namespace ui {

namespace {

/// How far a key moves the section plane, as a part of the board's larger side.
constexpr double kPlaneStep = 0.02;

/// The 3D view looks down at a section that is recalled, rad.
constexpr float kPitchOfSection = -0.6F;

bool isSamePoint(base::PointD a, base::PointD b) {
    return a.x == b.x && a.y == b.y;
}

/// The first corner of a line that is being drawn is none yet.
bool hasLength(const std::vector<base::PointD>& line) {
    return std::ranges::any_of(line, [&](base::PointD p) { return !isSamePoint(p, line.front()); });
}

}  // namespace

SectionFeature::SectionFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_views(context.views),
      m_hint(context.workspace),
      m_measuringHint(context.workspace),
      m_actions(context.actions),
      m_selection(context.workspace.selection()),
      m_line(context.views.flat()),
      m_plane(context.views),
      m_handle(context.views.solid(), m_plane),
      m_saved(context.workspace, tr("The sections"), &model::session::Session::sections, model::session::saveSections,
              [this](const auto& saved) {
                  listSaved(saved);
                  showDimensions();
              }),
      m_panel(new SectionPanel(m_selection, m_list, context.actions)) {
    m_line.setParent(this);
    m_handle.setParent(this);
    context.addPanel({ActionId::ShowSectionDock, "section", tr("Cross-section"), Qt::BottomDockWidgetArea}, *m_panel);
    m_due.setSingleShot(true);
    m_due.setInterval(0);
    connect(&m_due, &QTimer::timeout, this, &SectionFeature::cut);
    connectLine();
    connect(&m_panel->view(), &SectionView::dimensionsChanged, this, &SectionFeature::saveDimensions);
    connect(m_panel, &SectionPanel::cleared, this, [this] { cutAlong({}); });
    const auto* dock = qobject_cast<QDockWidget*>(m_panel->parentWidget());
    connect(dock->toggleViewAction(), &QAction::toggled, this, [this](bool isOpen) { m_line.setShown(isOpen); });
    connect(&m_panel->list(), &TableView::rowChosen, this, &SectionFeature::goTo);
    connect(&m_panel->list(), &TableView::deleteRequested, this,
            [this](const auto& rows) { m_saved.remove(tr("deleting a section"), rows); });
    connect(&m_list, &SectionListModel::renamed, this,
            [this](int row, const QString& name) { m_saved.rename(tr("the name of a section"), row, name); });
    connect(&m_workspace, &Workspace::boardLeaves, this, &SectionFeature::keep);
    connect(&m_workspace, &Workspace::boardOpened, this, &SectionFeature::setBoard);
    connect(&m_workspace, &Workspace::restacked, this, [this](const LoadedBoard& board) {
        m_index = board.index;
        m_plane.setHeights(board.index);
        cut();
    });
    connect(&m_workspace, &Workspace::unitChanged, &m_panel->view(), &SectionView::setUnit);
    connect(&context.layers, &LayerModel::stylesChanged, this,
            [this, &layers = context.layers] { m_panel->view().setColours(m_colours = layers.colours()); });
    connectCommands(context);
    connectPlane(context);
    connectMeasuring(context);
}

void SectionFeature::connectLine() {
    connect(&m_line, &SectionLine::moved, this, [this] {
        if (m_line.isDrawing()) {
            m_panel->view().fit();  // another line; one whose corner is moved stays as it is seen
        } else if (!m_beforeMove) {
            m_beforeMove = Kept{{}, m_panel->view().dimensions().all(), m_net};
        }
        m_panel->view().setDimensions({});
        m_panel->view().setRuns({});
        m_net.clear();
        m_due.start();
    });
    connect(&m_line, &SectionLine::finished, this, [this] {
        m_beforeMove.reset();
        cut();
        onPlaced();
    });
    connect(&m_line, &SectionLine::putBack, this, [this] {
        cut();
        if (const auto before = std::exchange(m_beforeMove, std::nullopt)) {
            setMarks(*before);
        }
    });
}

void SectionFeature::connectCommands(FeatureContext& context) {
    const auto on = [&](ActionId id, auto slot) { context.on(id, this, slot); };
    on(ActionId::DrawSection, [this](bool isOn) {
        if (isOn) {
            FeatureContext::raise(*m_panel);
        }
        draw(isOn);
    });
    on(ActionId::SectionAlongNet, [this] {
        FeatureContext::raise(*m_panel);
        followNet();
    });
    on(ActionId::OpenAlongSection, [this] {
        if (straightLine()) {
            m_views.reveal(m_views.solid());
        }
        showIn3D();
    });
    on(ActionId::SaveSection, [this] { saveSection(); });
    on(ActionId::ExportSection, [this, &context] {
        if (m_panel->view().section()) {
            context.saveFile(tr("Export section"), tr("section"), {tr("Drawings (*.svg)"), tr("Documents (*.pdf)")},
                             [this](const QString& path) { return drawing(path); });
        } else {
            m_workspace.report(tr("There is no section to export: draw one first"));
        }
    });
    context.escapes.emplace(EscapeRank::Tool, [this] { return m_panel->view().stepBack(); });
    context.escapes.emplace(EscapeRank::Tool, [this] {
        const bool isDrawing = m_line.isDrawing();
        m_line.setDrawing(false);
        return isDrawing;
    });
}

void SectionFeature::connectMeasuring(FeatureContext& context) {
    const SectionView& view = m_panel->view();
    connect(&context.actions[ActionId::MeasurePoints], &QAction::toggled, this, [this](bool isOn) {
        m_measuringHint.end();  // why a click measured nothing, if that is what it says
        m_panel->view().setMeasuring(isOn);
    });
    connect(&view, &SectionView::promptChanged, this, &SectionFeature::showPrompt);
    // Triggered comes after toggled: the tool has said by now what it wants in the other views.
    context.on(ActionId::MeasurePoints, this, [this, &view] { showPrompt(view.prompt()); });
    connect(&view, &SectionView::measured, &m_workspace, qOverload<const QString&>(&Workspace::report));
    connect(&view, &SectionView::refused, this, [this](const QString& why) { m_measuringHint.show(why); });
}

void SectionFeature::showPrompt(const QString& prompt) {
    if (!prompt.isEmpty()) {
        m_measuringHint.show(prompt);
    } else if (!m_panel->view().isMeasuring() || !m_panel->view().section()) {
        m_measuringHint.end();
    }  // else the pointer has only left: the tool is still on, and says what it wants where the pointer comes to
}

/// Keys reach the plane from both views, so they are said while there is one.
void SectionFeature::connectPlane(FeatureContext& context) {
    auto* hint = new Hint(m_workspace, this);
    connect(&m_actions[ActionId::SectionPlane], &QAction::toggled, hint, [this, hint](bool isOn) {
        isOn ? hint->show(
                   tr("Section plane: drag its arrow, or \"%1\" moves it forward, \"%2\" back, \"%3\" rotates it, "
                      "\"%4\" removes it")
                       .arg(keyOf(ActionId::MoveSectionPlaneOn), keyOf(ActionId::MoveSectionPlaneBack),
                            keyOf(ActionId::RotateSectionPlane), keyOf(ActionId::SectionPlane)))
             : hint->end();
    });
    const auto on = [&](ActionId id, auto slot) { context.on(id, this, slot); };
    on(ActionId::SectionPlane, [this](bool isOn) {
        m_plane.setOn(isOn);
        m_actions[ActionId::SectionPlane].setChecked(m_plane.isOn());
    });
    connectPlaneMoves(context);
    on(ActionId::ShowMilledAway, [this](bool isOn) {
        m_plane.setAsDesigned(isOn);
        cut();
    });
    connect(&context.probing, &Probing::pointedAt, this, [this](double x, double y) {
        m_plane.pointAt(base::PointD{x, y});
    });
    connect(&context.probing, &Probing::pointedAway, this, [this] { m_plane.pointAt(std::nullopt); });
}

void SectionFeature::connectPlaneMoves(FeatureContext& context) {
    const auto on = [&](ActionId id, auto slot) {
        context.on(id, this, [this, slot] {
            if (m_plane.isOn()) {
                m_views.reveal(m_views.solid());
                slot();
            } else {
                m_workspace.report(
                    tr("There is no section plane: \"%1\" makes one").arg(keyOf(ActionId::SectionPlane)));
            }
        });
    };
    on(ActionId::RotateSectionPlane, [this] { m_plane.rotate(); });
    on(ActionId::MoveSectionPlaneOn, [this] { m_plane.move(kPlaneStep); });
    on(ActionId::MoveSectionPlaneBack, [this] { m_plane.move(-kPlaneStep); });
}

QString SectionFeature::keyOf(ActionId id) const {
    return m_actions[id].shortcut().toString(QKeySequence::NativeText);
}

void SectionFeature::keep(const LoadedBoard& next) {
    m_kept.reset();
    if (!isReadAnew(m_workspace, next)) {
        return;
    }
    m_line.setDrawing(false);  // what is only half drawn is given up
    m_kept = Kept{m_line.line(), m_panel->view().dimensions().all(), m_net};
}

void SectionFeature::setBoard(const LoadedBoard& board) {
    m_index = board.index;
    m_line.clear();
    m_beforeMove.reset();
    m_plane.setBoard(board, m_kept.has_value());
    m_actions[ActionId::SectionPlane].setChecked(m_plane.isOn());
    m_actions[ActionId::DrawSection].setChecked(false);
    m_panel->view().setDimensions({});
    m_panel->view().setRuns({});
    m_net.clear();
    if (m_kept && hasLength(m_kept->line)) {
        restoreKept();
    } else {
        m_panel->view().fit();
        cut();
    }
    m_kept.reset();
}

void SectionFeature::restoreKept() {
    m_line.setLine(m_kept->line);
    cut();
    const std::optional<model::Section>& section = m_panel->view().section();
    if (!section || section->pieces.empty()) {
        m_workspace.reportError(
            tr("The line of the cross-section does not meet the board as it is now, so the cross-section was closed."));
        cutAlong({});
        return;
    }
    setMarks(*m_kept);
}

void SectionFeature::setMarks(const Kept& kept) {
    std::vector<model::LayerRun> runs = runsAlong(kept.net);
    m_net = runs.empty() ? std::string() : kept.net;
    m_panel->view().setRuns(std::move(runs));
    m_panel->view().setDimensions(kept.dimensions);
    showDimensions();
}

std::vector<model::LayerRun> SectionFeature::runsAlong(const std::string& net) const {
    const auto& steps = m_index->tree.steps;
    for (std::uint32_t step = 0; !net.empty() && step < steps.size(); ++step) {
        const auto& nets = steps[step]->nets;
        const auto found = std::ranges::find(nets, net, &model::Net::name);
        if (found == nets.end()) {
            continue;
        }
        const model::NetId id{static_cast<std::size_t>(found - nets.begin())};
        const base::Result<model::NetLine> line = model::lineAlong(*m_index, {m_selection.firstCopyOf(step), id});
        if (line && std::ranges::equal(line->line, m_line.line(), isSamePoint)) {
            return model::runsOf(*line);
        }
    }
    return {};
}

void SectionFeature::onPlaced() {
    m_hint.end();
    m_actions[ActionId::DrawSection].setChecked(false);
    QTimer::singleShot(0, this, &SectionFeature::followIn3D);  // that cuts the board once more: in an event of its own
}

void SectionFeature::followIn3D() {
    if (m_plane.isAlongLine() && straightLine()) {
        showIn3D();
    }
}

void SectionFeature::showIn3D() {
    if (const auto line = straightLine()) {
        m_plane.cutAlong(line->first, line->second);
        m_actions[ActionId::SectionPlane].setChecked(true);
    } else {
        m_workspace.report(tr("Draw a section with a straight line first"));
    }
}

void SectionFeature::draw(bool isOn) {
    m_line.setDrawing(isOn);
    if (isOn) {
        m_hint.show(
            tr("Drag a line, or click its corners: a double click or Enter ends it, Backspace takes the "
               "last corner back, Esc gives up"));
    }
}

void SectionFeature::cutAlong(std::vector<base::PointD> line, std::vector<model::LayerRun> runs, std::string net) {
    m_beforeMove.reset();
    m_net = std::move(net);
    m_line.setLine(std::move(line));
    m_panel->view().setRuns(std::move(runs));
    m_panel->view().fit();
    cut();
    m_panel->view().setDimensions({});
    showDimensions();
}

void SectionFeature::cut() {
    m_due.stop();
    if (m_index == nullptr || !hasLength(m_line.line())) {
        m_panel->view().setSection(nullptr, std::nullopt);
        m_panel->setNotes({});
        return;
    }
    model::SectionRequest request{m_line.line(), {}};
    if (!m_actions[ActionId::ShowMilledAway].isChecked()) {
        request.milled = render::milledOfSteps(*m_workspace.board()->model);
    }
    base::Result<model::Section> section = model::makeSection(*m_index, request);
    if (!section) {
        m_panel->view().setSection(nullptr, std::nullopt);
        m_panel->setNotes(QString::fromStdString(section.error().text));
        return;
    }
    m_panel->setNotes(textsOf(section->notes).join(QStringLiteral(" · ")));
    m_panel->view().setSection(m_index, std::move(*section));
}

std::optional<std::pair<base::PointD, base::PointD>> SectionFeature::straightLine() const {
    if (m_line.line().size() != 2) {
        return std::nullopt;
    }
    return std::pair(m_line.line().front(), m_line.line().back());
}

void SectionFeature::followNet() {
    const std::vector<model::BoardNet> nets = m_selection.selectionNets();
    if (m_index == nullptr || nets.size() != 1) {
        m_workspace.report(tr("Select one net first: a click on its copper, or in the Nets panel"));
        return;
    }
    const model::BoardNet& net = nets.front();
    if (const base::Result<model::NetLine> line =
            model::lineAlong(*m_index, {m_selection.firstCopyOf(net.step), net.net})) {
        const model::Document& step = *m_index->tree.steps[net.step];
        cutAlong(line->line, model::runsOf(*line), step.nets[net.net.row()].name);
        onPlaced();
    } else {
        m_workspace.report(line.error().text);
    }
}

void SectionFeature::saveSection() {
    const std::optional<model::Section>& section = m_panel->view().section();
    if (!section) {
        m_workspace.report(tr("There is no section to save: draw one first"));
        return;
    }
    m_saved.addAndReport(tr("saving a section"), {{}, {}, section->line, m_panel->view().dimensions().all()},
                         "Section ");
}

void SectionFeature::listSaved(const std::vector<model::session::SavedSection>& saved) {
    TableView& table = m_panel->list();
    const bool isAsMany = static_cast<int>(saved.size()) == m_list.rowCount();
    const std::string current = table.currentIndex().data().toString().toStdString();
    m_list.setSections(saved);
    if (!isAsMany) {  // the list began anew, and of two sections of one line its current row tells which one is shown
        const auto at = std::ranges::find(saved, current, &model::session::SavedSection::name);
        const int row = at != saved.end() ? static_cast<int>(at - saved.begin()) : -1;
        table.setCurrentIndex(m_list.index(row, SectionListModel::Name));
    }
}

void SectionFeature::goTo(int row) {
    const model::session::SavedSection& saved = m_saved.entries()[static_cast<std::size_t>(row)];
    if (!m_workspace.isOpen(saved.step)) {
        const auto& steps = m_index->board->job.steps;
        const bool isKnown = std::ranges::find(steps, saved.step) != steps.end();
        m_workspace.report((isKnown ? tr("%1 is a section of step %2, which is not open")
                                    : tr("%1 is a section of step %2, which this board does not have"))
                               .arg(QString::fromStdString(saved.name), QString::fromStdString(saved.step)));
        return;
    }
    const std::vector<model::SectionDimension> dimensions = saved.dimensions;  // of two of one line each has its own
    cutAlong(saved.line);
    m_panel->view().setDimensions(dimensions);
    onPlaced();
    showLine();
}

std::optional<int> SectionFeature::shownRow() const {
    const std::optional<model::Section>& section = m_panel->view().section();
    const auto isShown = [&](const model::session::SavedSection& saved) {
        return section && m_workspace.isOpen(saved.step) && std::ranges::equal(saved.line, section->line, isSamePoint);
    };
    const auto& list = m_saved.entries();
    const int chosen = m_panel->list().currentIndex().row();
    if (chosen >= 0 && chosen < static_cast<int>(list.size()) && isShown(list[static_cast<std::size_t>(chosen)])) {
        return chosen;
    }
    const auto found = std::ranges::find_if(list, isShown);
    return found == list.end() ? std::nullopt : std::optional(static_cast<int>(found - list.begin()));
}

void SectionFeature::saveDimensions() {
    if (const std::optional<int> row = shownRow()) {
        m_saved.change(
            tr("the dimensions of a section"), *row,
            [dimensions = m_panel->view().dimensions().all()](auto& saved) { saved.dimensions = dimensions; });
    }
}

void SectionFeature::showDimensions() {
    if (const std::optional<int> row = shownRow()) {
        m_panel->view().setDimensions(m_saved.entries()[static_cast<std::size_t>(*row)].dimensions);
    }
}

void SectionFeature::showLine() {
    const std::vector<base::PointD>& line = m_line.line();
    glm::vec3 low(1e30F);
    glm::vec3 high(-1e30F);
    const auto [bottom, top] = model::boardHeights(*m_index->board);
    for (const base::PointD& corner : line) {
        for (const model::Nm z : {bottom, top}) {
            const glm::vec3 at = m_views.flat().position().toModel(corner, static_cast<double>(z));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    }
    m_views.flat().controller().show(low, high);
    CameraController& solid = m_views.solid().controller();
    if (const auto ends = straightLine()) {
        showIn3D();
        render::CameraPose pose = solid.camera().pose();
        pose.yaw = -static_cast<float>(std::atan2(ends->second.y - ends->first.y, ends->second.x - ends->first.x));
        pose.pitch = kPitchOfSection;
        solid.setPose(pose);
    }
    solid.show(low, high);
}

base::Result<std::string> SectionFeature::drawing(const QString& path) const {
    const std::optional<model::Section>& section = m_panel->view().section();
    if (!section) {
        return base::Error{base::ErrorCode::BadUsage, "There is no section to export: draw one first."};
    }
    model::SectionPicture how;
    for (const QColor& colour : m_colours) {
        how.colours.push_back(colour.rgb() & 0xffffffU);
    }
    how.heightTimes = m_panel->heightsBox().currentData().toDouble();
    const SectionView& view = m_panel->view();
    how.runs = view.runs();
    how.net = m_net;
    for (const model::SectionDimension& dimension : view.dimensions().all()) {
        how.dimensions.push_back({dimension, view.textOf(dimension).toStdString(), view.isShownStale(dimension)});
    }
    if (path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) {
        return sectionPdf(model::sectionSheet(*m_index->board, *section, how),
                          QString::fromStdString(m_index->board->job.name));
    }
    return model::sectionSvg(*m_index->board, *section, how);
}

}  // namespace ui
