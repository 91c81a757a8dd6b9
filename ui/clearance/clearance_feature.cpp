#include "ui/clearance/clearance_feature.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <limits>

#include "model/base/ascii.h"
#include "model/board/copies.h"
#include "model/clearance/kicad_project_rules.h"
#include "model/clearance/rule_file.h"
#include "model/design_rules/design_rule_check.h"
#include "model/export/stackup_clearance_export.h"
#include "model/session/session.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/common/paths.h"
#include "ui/common/table_view.h"
#include "ui/common/texts.h"
#include "ui/layers/layer_model.h"
#include "ui/views/position_readout.h"

namespace ui {

namespace {

constexpr float kLeastAroundMm = 0.3F;  ///< around a spacing that is shown
constexpr float kTimesAround = 2.0F;    ///< at least so many widths of it
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kNarrowest = 500;  ///< more than anybody steps through
constexpr std::size_t kDrawn = 100;      ///< locations of a rule in a report with drawings

/// The rules that a board begins with need no place in its session: those of its project, or else the common ones.
std::optional<model::RuleTable> ownRules(const LoadedBoard& board, const model::RuleTable& rules) {
    const bool hasProject = board.projectRules && !board.projectRules->table.rules.empty();
    const bool isFirst = rules == (hasProject ? board.projectRules->table : model::defaultRules());
    return isFirst ? std::nullopt : std::optional(rules);
}

/// What a board begins with. What is left out of its project is so under rules that were edited, too.
model::RuleFile rulesOf(const LoadedBoard& board) {
    model::RuleFile rules = board.projectRules.value_or(model::RuleFile{});
    rules.table = board.session.designRules.value_or(model::defaultRules());
    return rules;
}

/// What of the file is not checked, for the list of messages.
model::Diagnostics messagesOf(const model::RuleFile& file) {
    model::Diagnostics messages;
    for (const model::LeftOutRule& one : file.leftOut) {
        messages.report(model::Severity::Info, one.file.filename().string(), one.line, "design rules: " + one.text);
    }
    for (const std::string& unused : file.unused) {
        messages.report(model::Severity::Info, {}, 0, "design rules: " + unused);
    }
    return messages;
}

}  // namespace

ClearanceFeature::ClearanceFeature(FeatureContext& context)
    : QObject(&context.window),
      m_workspace(context.workspace),
      m_views(context.views),
      m_probing(context.probing),
      m_selection(context.workspace.selection()),
      m_shown(m_selection, m_views, this),
      m_plan(context.plan),
      m_savedRules(
          m_workspace, tr("The rules"), [this](const model::RuleFile& rules) { setRules(rules); },
          model::session::saveDesignRules,
          [this](const model::RuleFile& rules) { return ownRules(*m_workspace.board(), rules.table); }),
      m_waivers(m_workspace, context.settings, this),
      m_lens(m_views, m_workspace, this),
      m_distances(m_views, m_probing, m_workspace, this),
      m_panel(new ClearancePanel(m_locations, m_rules, context.actions)) {
    m_locations.setParent(this);
    m_rules.setParent(this);
    context.addPanel({ActionId::ShowClearanceDock, "clearances", tr("Clearances"), Qt::BottomDockWidgetArea}, *m_panel);
    m_workspace.watch(m_search.background(), [] { return tr("Clearances"); });
    connect(&m_workspace, &Workspace::boardOpened, this, &ClearanceFeature::setBoard);
    connect(&m_workspace, &Workspace::restacked, this, &ClearanceFeature::endThroughStackup);
    connect(&m_workspace, &Workspace::unitChanged, this, &ClearanceFeature::setUnit);
    connect(&m_search.background(), &Background::finished, this, &ClearanceFeature::take);
    connect(&m_rules, &RuleModel::edited, this, &ClearanceFeature::remember);
    connect(&m_rules, &RuleModel::refused, &m_workspace, &Workspace::errorReported);
    connect(&m_shown, &ShownFinding::ended, this, [this] { m_workspace.showSpacing(std::nullopt); });
    connectCommands(context);
    connectFiles(context);
    connectWaivers(context);
    connectPanel(context);
}

void ClearanceFeature::connectCommands(FeatureContext& context) {
    const auto on = [&](ActionId id, auto slot) {
        context.on(id, this, [this, slot, &action = context.actions[id]](bool isOn) {
            if (isOn || !action.isCheckable()) {
                FeatureContext::raise(*m_panel);
            }
            slot(isOn);
        });
    };
    on(ActionId::SearchClearances, [this](bool) { search(); });
    on(ActionId::CheckRules, [this](bool) {
        m_panel->showRules();
        search();
    });
    on(ActionId::Lens, [this](bool isOn) { m_lens.setOn(isOn); });
    on(ActionId::ClearanceMap, [this](bool isOn) { m_distances.setOn(isOn); });
    context.on(ActionId::EditRules, this, [this, &window = context.window] { editRules(window); });
    context.on(ActionId::NextClearance, this, [this] { step(1); });
    context.on(ActionId::PreviousClearance, this, [this] { step(-1); });
}

void ClearanceFeature::connectFiles(FeatureContext& context) {
    context.on(ActionId::ExportClearances, this, [this, &context] {
        if (answer()) {
            context.saveFile(tr("Export clearances"), tr("clearances"), exportFilters(),
                             [this](const QString& path) { return report(path); });
        } else {
            m_workspace.report(tr("There is nothing to export: find clearances or check rules first"));
        }
    });
    connect(m_panel, &ClearancePanel::rulesAsked, this, [this, &context] {
        context.openFile(tr("Open rules"), tr("Rules (*.json *.kicad_dru *.kicad_pro *.kicad_pcb);;All files (*)"),
                         context.settings.lastFolder(m_workspace.boardFolder()), [this](const QString& path) {
                             const base::Result<QString> opened = openRules(path);
                             opened ? m_workspace.report(*opened) : m_workspace.reportSaved(opened.error(), path);
                         });
    });
    connect(m_panel, &ClearancePanel::rulesSaved, this, [this, &context] {
        context.saveFile(tr("Save rules"), tr("rules"), {tr("Rules (*.json)")},
                         [this](const QString&) { return model::toJson(m_rules.rules()); });
    });
}

void ClearanceFeature::connectWaivers(FeatureContext& context) {
    connect(&m_waivers, &RuleWaivers::changed, this, &ClearanceFeature::checkAnew);
    connect(m_panel, &ClearancePanel::waiverAsked, this, [this, &window = context.window](const auto& rows) {
        RuleWaivers::List waivers;
        std::ranges::transform(rows, std::back_inserter(waivers), [&](int row) { return m_locations.waiverFor(row); });
        m_waivers.request(waivers, window);
    });
    connect(m_panel, &ClearancePanel::withdrawalAsked, this, [this](const auto& rows) {
        std::vector<std::size_t> waivers;
        std::ranges::transform(rows, std::back_inserter(waivers),
                               [&](int row) { return *m_locations.location(row).waiver; });
        withdraw(waivers);
    });
    connect(m_panel, &ClearancePanel::goneWaiversAsked, this, [this] {
        if (const auto& checked = answerOf(ClearancePanel::What::Rules)) {
            withdraw(goneWaivers(checked->result));
        }
    });
    connect(m_panel, &ClearancePanel::waiversAsked, this, [this, &context] {
        context.openFile(tr("Open waivers"), tr("Waivers (*.json);;All files (*)"),
                         context.settings.lastFolder(m_workspace.boardFolder()), [this](const QString& path) {
                             const base::Status opened = m_waivers.read(path);
                             opened ? m_workspace.report(tr("Waivers of %1").arg(path))
                                    : m_workspace.reportSaved(opened, path);
                         });
    });
    connect(m_panel, &ClearancePanel::waiversSaved, this, [this, &context] {
        context.saveFile(tr("Save waivers"), tr("waivers"), {tr("Waivers (*.json)")},
                         [this](const QString&) { return model::toJson(m_waivers.list()); });
    });
}

void ClearanceFeature::withdraw(const std::vector<std::size_t>& rows) {
    RuleWaivers::List waivers;
    for (const std::size_t row : rows) {
        waivers.push_back(answerOf(ClearancePanel::What::Rules)->request.waivers[row]);
    }
    m_waivers.withdraw(waivers);
}

QStringList ClearanceFeature::exportFilters() const {
    QStringList filters{tr("Text (*.txt)"), tr("Tables (*.csv)"), tr("JSON (*.json)")};
    if (m_panel->what() == ClearancePanel::What::Rules) {
        filters += {tr("Page with drawings (*.html)"), tr("JUnit (*.xml)"), tr("SARIF (*.sarif)")};
    }
    return filters;
}

void ClearanceFeature::connectPanel(FeatureContext& context) {
    connect(m_panel, &ClearancePanel::chosen, this, &ClearanceFeature::show);
    connect(m_panel, &ClearancePanel::whatChanged, this, &ClearanceFeature::list);
    connect(m_panel, &ClearancePanel::lensMoved, &m_lens, &Lens::setReach);
    connect(&m_lens, &Lens::reported, m_panel, &ClearancePanel::showLens);
    m_lens.setReach(m_panel->lensReach());
    m_distances.setLayer([this] { return mappedLayer(); });
    m_distances.setReach(m_panel->mapReach());
    connect(m_panel, &ClearancePanel::mapReachChanged, &m_distances, &ClearanceMapOverlay::setReach);
    connect(&m_distances, &ClearanceMapOverlay::reported, m_panel, &ClearancePanel::showMap);
    // The views take their styles from the same signal, before the map looks at them in a moment.
    connect(&context.layers, &LayerModel::stylesChanged, &m_distances, &ClearanceMapOverlay::refresh);
    context.position.setNote([this](base::PointD at) { return m_distances.textAt(at); });
}

/// The current layer if it is copper that is to be seen, else the nearest such one.
model::LayerId ClearanceFeature::mappedLayer() const {
    const model::LayerId current = m_workspace.currentLayer();
    const std::vector<render::LayerStyle>& styles = m_views.flat().styles();
    const bool isSeen = current.isValid() && current.row() < styles.size() && styles[current.row()].isVisible;
    return isSeen && m_workspace.board()->document->layer(current).isCopper() ? current : m_plan.namedLayer();
}

void ClearanceFeature::setBoard(const LoadedBoard& board) {
    m_answers = {};
    m_isThroughStale = false;
    list();
    if (m_savedRules.open()) {
        setRules(rulesOf(board));
    }
    m_waivers.open(board);
    m_rules.setResults({});
}

void ClearanceFeature::endThroughStackup() {
    auto& found = m_answers[static_cast<std::size_t>(ClearancePanel::What::ThroughStackup)];
    const bool isSearched = m_search.isRunning() && m_wanted.throughStackup;
    if (!found && !isSearched) {
        return;
    }
    if (isSearched) {
        m_search.cancel();
    }
    found.reset();
    m_isThroughStale = true;
    if (m_panel->what() == ClearancePanel::What::ThroughStackup) {
        list();
    }
}

void ClearanceFeature::setUnit(LengthUnit unit) {
    m_locations.setUnit(unit);
    m_rules.setUnit(unit);
    m_panel->setUnit(unit);
}

std::optional<ClearanceRequest> ClearanceFeature::request() {
    ClearanceRequest request;
    request.isOfRules = m_panel->what() == ClearancePanel::What::Rules;
    request.rules = m_rules.rules();
    request.leftOut = m_ruleFile.leftOut.size();
    request.waivers = m_waivers.list();
    request.question.count = kNarrowest;
    if (request.isOfRules) {
        return request;
    }
    if (m_panel->what() == ClearancePanel::What::ThroughStackup) {
        return throughStackup(std::move(request));
    }
    switch (m_panel->where()) {
        case ClearancePanel::Where::Board: break;
        case ClearancePanel::Where::View: request.question.within = m_plan.shownBox(); break;
        case ClearancePanel::Where::Layer: {
            const model::LayerId layer = m_workspace.currentLayer();
            if (!layer.isValid() || !m_workspace.board()->document->layer(layer).isCopper()) {
                m_workspace.reportError(tr("The current layer is no copper layer; choose one in the Layers panel."));
                return std::nullopt;
            }
            request.question.layer = layer;
            break;
        }
        case ClearancePanel::Where::Nets: {
            const std::vector<model::BoardNet> nets = m_selection.selectionNets();
            if (nets.size() != 2 || nets[0].step != 0 || nets[1].step != 0) {
                reportNoTwoNets();
                return std::nullopt;
            }
            request.question.between = {nets[0].net, nets[1].net};
            break;
        }
    }
    return request;
}

void ClearanceFeature::reportNoTwoNets() {
    m_workspace.reportError(
        tr("Select two nets of the board first: N over the copper of one and Ctrl+N over that of the "
           "other, or Ctrl and a click in the Nets panel."));
}

/// Of the whole board, or of the two highlighted nets in all copies.
std::optional<ClearanceRequest> ClearanceFeature::throughStackup(ClearanceRequest request) {
    request.throughStackup.emplace().count = kNarrowest;
    if (m_panel->where() == ClearancePanel::Where::Board) {
        return request;
    }
    if (m_panel->where() != ClearancePanel::Where::Nets) {
        m_workspace.reportError(
            tr("Through the stackup is measured of the board or between the two highlighted nets, not on one layer "
               "or in a view."));
        return std::nullopt;
    }
    const std::vector<model::BoardNet> nets = m_selection.selectionNets();
    const auto nameOf = [&](const model::BoardNet& at) {
        return m_selection.tree().steps[at.step]->nets[at.net.row()].name;
    };
    if (nets.size() != 2 || nameOf(nets[0]) == nameOf(nets[1])) {
        reportNoTwoNets();
        return std::nullopt;
    }
    request.throughStackup->between = {nameOf(nets[0]), nameOf(nets[1])};
    return request;
}

void ClearanceFeature::search() {
    m_workspace.cancelLoading();
    m_current.reset();
    if (std::optional<ClearanceRequest> wanted = request()) {
        run(std::move(*wanted));
    }
}

void ClearanceFeature::checkAnew() {
    if (const auto& checked = answerOf(ClearancePanel::What::Rules)) {
        const int row = m_locations.isOfRules() ? m_panel->currentRow() : -1;
        m_current = row < 0 ? std::nullopt : std::optional(m_locations.location(row));
        m_place = m_panel->place();
        ClearanceRequest again = checked->request;
        again.waivers = m_waivers.list();
        run(std::move(again));
    }
}

void ClearanceFeature::run(ClearanceRequest request) {
    m_searched = m_workspace.board()->document;
    m_wanted = std::move(request);
    m_search.run([board = m_searched,
                  request = m_wanted](base::Progress& progress) { return searchClearances(*board, request, progress); },
                 tr("Measuring clearances"), tr("There is not enough memory to measure clearances"));
}

void ClearanceFeature::take() {
    base::Result<ClearanceResult> result = m_search.take();
    if (!result) {
        m_workspace.reportError(QString::fromStdString(result.error().text));
        return;
    }
    const auto kind = m_wanted.isOfRules        ? ClearancePanel::What::Rules
                      : m_wanted.throughStackup ? ClearancePanel::What::ThroughStackup
                                                : ClearancePanel::What::Smallest;
    m_answers[static_cast<std::size_t>(kind)] = ClearanceAnswer{m_wanted, m_searched, std::move(*result)};
    m_isThroughStale = m_isThroughStale && kind != ClearancePanel::What::ThroughStackup;
    if (m_wanted.isOfRules && m_rules.rules() == m_wanted.rules) {
        m_rules.setResults(resultsOf(m_wanted.rules, answerOf(kind)->result));
    }
    if (kind != m_panel->what()) {
        return;  // it is listed when it is asked for again
    }
    list();
    restoreCurrent();
    const QStringList told = QStringList{m_locations.summary()} + textsOf(answer()->result.notes);
    m_workspace.report((m_wanted.isOfRules ? tr("Rules: %1") : tr("Clearances: %1")).arg(told.join("; ")));
}

void ClearanceFeature::restoreCurrent() {
    if (!m_current) {
        return;
    }
    const int row = m_locations.rowOf(*m_current);
    const bool isMoved = row >= 0 && m_locations.location(row).waiver.has_value() != m_current->waiver.has_value();
    if (isMoved) {
        m_panel->returnTo(m_place);
    } else {
        m_panel->setCurrentRow(row);
    }
}

void ClearanceFeature::list() {
    m_shown.end();
    if (answer()) {
        listAnswer();
    } else {
        m_locations.setSpacings(nullptr, {}, {}, true);
    }
    m_panel->setNotes(notes());
}

QString ClearanceFeature::notes() const {
    if (answer()) {
        return textsOf(answer()->result.notes).join('\n');
    }
    return m_isThroughStale && m_panel->what() == ClearancePanel::What::ThroughStackup
               ? tr("Thicknesses have changed since the last search: find the clearances again.")
               : QString();
}

void ClearanceFeature::listAnswer() {
    const auto& [request, board, result] = *answer();
    if (request.throughStackup) {
        m_locations.setThroughStackup(board, result.throughStackup, result.names, result.isCut);
    } else {
        m_locations.setSpacings(board, spacingsOf(result), request.isOfRules ? request.rules : model::RuleTable{},
                                isComplete(result), result.isCut);
    }
}

void ClearanceFeature::step(int by) {
    const QAbstractItemModel& rows = *m_panel->table().model();
    if (rows.rowCount() == 0) {
        m_workspace.report(answer() ? tr("The list of clearances is empty")
                                    : tr("There is no list to step through: find clearances or check rules first"));
        return;
    }
    const int now = m_panel->table().currentIndex().row();  // -1: none
    const int next = now < 0 ? (by > 0 ? 0 : rows.rowCount() - 1) : now + by;
    m_panel->table().setCurrentIndex(rows.index((next + rows.rowCount()) % rows.rowCount(), ClearanceModel::First));
}

void ClearanceFeature::show(const ClearanceModel::Location& location) {
    location.throughStackup ? showThrough(*location.throughStackup) : showPlain(location);
}

void ClearanceFeature::showThrough(const model::StackupClearance& found) {
    showSides({found.a, found.b}, {found.layerA, found.layerB},
              {found.spacing, found.a, found.b, found.layerA, found.layerB, found.height});
}

void ClearanceFeature::showPlain(const ClearanceModel::Location& location) {
    const std::uint32_t row = m_selection.firstCopyOf(location.step);
    const model::StepCopy& copy = m_selection.tree().copies[row];
    const model::Document& step = *m_selection.tree().steps[location.step];
    const model::LayerId layer = step.layerOfCopy(location.found.layer, copy.isFlipped);
    std::vector<model::BoardElement> sides;
    std::vector<model::LayerId> layers{layer};
    for (const model::ElementId side : {location.found.a, location.found.b}) {
        if (side.isValid()) {
            sides.push_back({row, side});
            layers.push_back(m_selection.layerOf({row, side}));
        }
    }
    const model::Spacing& s = location.found.spacing;
    const model::Spacing onBoardNow{s.distance, copy.placement.apply(s.from), copy.placement.apply(s.to)};
    showSides(std::move(sides), std::move(layers),
              {onBoardNow, {row, location.found.a}, {row, location.found.b}, layer, layer});
}

void ClearanceFeature::showSides(std::vector<model::BoardElement> sides, std::vector<model::LayerId> layers,
                                 const ShownSpacing& spacing) {
    m_shown.show(std::move(sides), std::move(layers));
    const model::Spacing& s = spacing.spacing;
    const float around = std::max(kLeastAroundMm, kTimesAround * static_cast<float>(base::toMm(s.distance)));
    m_probing.showPosition({(s.from.x + s.to.x) / 2, (s.from.y + s.to.y) / 2}, spacing.fromLayer, around);
    m_workspace.showSpacing(spacing);
}

void ClearanceFeature::setRules(const model::RuleFile& rules) {
    if (!(m_rules.rules() == rules.table)) {
        m_rules.setRules(rules.table);
    }
    m_ruleFile = rules;
    emit rulesListed(messagesOf(rules));
}

model::RuleFile ClearanceFeature::withTable(const model::RuleTable& table) const {
    model::RuleFile rules = m_ruleFile;
    rules.table = table;
    return rules;
}

void ClearanceFeature::remember(const model::RuleTable& before) {
    if (m_workspace.board() != nullptr && !(before == m_rules.rules())) {
        m_savedRules.edit(tr("the rules"), withTable(before), withTable(m_rules.rules()));
    }
}

QStringList ClearanceFeature::ruleLayers() const {
    QStringList names;
    for (const model::Layer& layer : m_workspace.board()->document->layers) {
        if (model::isRuled(layer)) {
            names += QString::fromStdString(layer.name);
        }
    }
    return names;
}

void ClearanceFeature::editRules(QWidget& parent) {
    std::vector<std::string> nets;
    for (const model::Document* step : model::distinctSteps(*m_workspace.board()->document)) {
        for (const model::Net& net : step->nets) {
            nets.push_back(net.name);
        }
    }
    auto* dialog = new RuleDialog(m_rules.rules(), std::move(nets), m_workspace.unit(), &parent);
    dialog->rules().setLayers(ruleLayers());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const model::RuleTable before = m_rules.rules();
        if (const model::RuleTable& after = dialog->rules().rules(); !(after == before)) {
            m_rules.setRules(after);  // otherwise what was found of them stays true
        }
        FeatureContext::raise(*m_panel);  // not before: who gives up finds the window as it was
        m_panel->showRules();
        remember(before);
    });
    dialog->open();
}

base::Result<std::string> ClearanceFeature::report(const QString& path) const {
    const auto format = model::reportFormatOf(base::lowerCase(toPath(path).extension().string()));
    if (!answer()) {
        return base::Error{base::ErrorCode::BadUsage,
                           "Nothing was measured or checked yet, so there is nothing to export."};
    }
    const auto& [request, board, result] = *answer();
    if (!format || (!request.isOfRules && model::isOfRulesAlone(*format))) {
        return base::Error{base::ErrorCode::BadUsage,
                           "A report is written as .txt, .csv or .json, on rules also as .html, .xml or .sarif."};
    }
    const std::size_t most = *format == model::ReportFormat::Html ? kDrawn : kAll;
    const model::ReportContext context{m_workspace.board()->request.path,
                                       QCoreApplication::applicationVersion().toStdString()};
    return request.isOfRules        ? model::ruleReport(request.rules, result.rules, *format, most, context)
           : request.throughStackup ? model::stackupClearanceReport(*board, result.throughStackup, *format)
                                    : model::clearanceReport(result.clearances, *format);
}

base::Result<QString> ClearanceFeature::openRules(const QString& path) {
    ASSIGN_OR_RETURN(model::RuleFile file, model::readRules(toPath(path)));
    model::leaveOutUnusedClasses(file, *m_workspace.board()->document);
    for (model::LeftOutRule& one : file.leftOut) {
        one.file = one.file.empty() ? toPath(path) : one.file;
    }
    if (m_rules.rules() == file.table) {
        setRules(file);
    } else {
        m_savedRules.edit(tr("the rules"), withTable(m_rules.rules()), file);
    }
    return file.leftOut.empty() ? tr("Rules of %1").arg(path)
                                : tr("Rules of %1; what is left out of them is in the list of messages").arg(path);
}

}  // namespace ui
