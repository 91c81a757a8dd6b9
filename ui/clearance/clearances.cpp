#include "ui/clearance/clearances.h"

#include <QComboBox>
#include <QSaveFile>
#include <algorithm>
#include <limits>

#include "model/board/copies.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/common/paths.h"
#include "ui/common/table_view.h"
#include "ui/workspace/state_edit.h"

namespace ui {

namespace {

constexpr float kLeastAroundMm = 0.3F;  ///< around a gap that is shown
constexpr float kTimesAround = 2.0F;    ///< at least so many widths of it
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kNarrowest = 500;  ///< more than anybody steps through

base::Status write(const QString& path, const QByteArray& text) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        return base::Error{base::ErrorCode::OutputFailed,
                           (path + QStringLiteral(" cannot be written: ") + file.errorString()).toStdString()};
    }
    return base::Done{};
}

}  // namespace

Clearances::Clearances(BoardViews& views, Probing& probing, SelectionModel& selection, const PlanPainter& plan,
                       const ActionSet& actions, QUndoStack& history, QObject* parent)
    : QObject(parent),
      m_views(views),
      m_probing(probing),
      m_selection(selection),
      m_plan(plan),
      m_history(history),
      m_lens(views, selection),
      m_distances(views, selection),
      m_panel(new ClearancePanel(m_locations, m_rules, actions)) {
    connect(&m_checker, &ClearanceChecker::progressed, this, &Clearances::progressed);
    connect(&m_checker, &ClearanceChecker::found, this, &Clearances::take);
    connect(&m_checker, &ClearanceChecker::failed, this, &Clearances::failed);
    connect(&m_rules, &RuleModel::edited, this, &Clearances::remember);
    connect(&m_rules, &RuleModel::refused, this, &Clearances::failed);
    connect(m_panel, &ClearancePanel::chosen, this, &Clearances::show);
    connect(m_panel, &ClearancePanel::lensMoved, &m_lens, &Lens::setReach);
    connect(&m_lens, &Lens::reported, m_panel, &ClearancePanel::showLens);
    m_lens.setReach(m_panel->lensReach());
    connect(&m_selection, &SelectionModel::selectionChanged, this, [this] {
        if (m_isShowing && m_selection.selected() != m_sides) {
            endShowing();
        }
    });
    connectDistances();
}

void Clearances::connectDistances() {
    ClearanceMapBar& bar = m_panel->distances();
    m_distances.setLayer([this] { return mappedLayer(); });
    m_distances.setReach(bar.reach());
    connect(&bar, &ClearanceMapBar::reachChanged, &m_distances, &ClearanceMapOverlay::setReach);
    connect(&m_distances, &ClearanceMapOverlay::reported, &bar, &ClearanceMapBar::showText);
    connect(&m_probing, &Probing::pointedAt, &m_distances, [this](double x, double y) {
        m_distances.pointAt(base::PointD{x, y});
    });
    connect(&m_probing, &Probing::pointedAway, &m_distances, [this] { m_distances.pointAt(std::nullopt); });
}

/// The current layer if it is copper that is to be seen, else the nearest such one.
model::LayerId Clearances::mappedLayer() const {
    const model::LayerId current = m_currentLayer();
    const std::vector<render::LayerStyle>& styles = m_views.flat().styles();
    const bool isSeen = current.isValid() && current.row() < styles.size() && styles[current.row()].isVisible;
    return isSeen && m_board->layer(current).isCopper() ? current : m_plan.namedLayer();
}

void Clearances::setBoard(const LoadedBoard& board) {
    m_checker.cancel();
    m_board = board.document;
    m_asked.reset();
    m_result = {};
    endShowing();
    m_locations.setSpacings(nullptr, {}, {});
    m_rules.setCounts({});
    m_panel->setRemarks({});
    m_lens.setBoard(board);
    m_distances.setBoard(board);
}

void Clearances::setUnit(LengthUnit unit) {
    m_unit = unit;
    m_locations.setUnit(unit);
    m_rules.setUnit(unit);
    m_panel->setUnit(unit);
    m_lens.setUnit(unit);
    m_distances.setUnit(unit);
}

std::optional<ClearanceRequest> Clearances::request() {
    ClearanceRequest request;
    request.isOfRules = m_panel->what() == ClearancePanel::What::Rules;
    request.rules = m_rules.rules();
    request.question.count = kNarrowest;
    if (request.isOfRules) {
        return request;
    }
    switch (m_panel->where()) {
        case ClearancePanel::Where::Board: break;
        case ClearancePanel::Where::View: request.question.within = m_plan.shownBox(); break;
        case ClearancePanel::Where::Layer: {
            const model::LayerId layer = m_currentLayer();
            if (!layer.isValid() || !m_board->layer(layer).isCopper()) {
                emit failed(QStringLiteral("The current layer is no copper layer; choose one in the Layers panel."));
                return std::nullopt;
            }
            request.question.layer = layer;
            break;
        }
        case ClearancePanel::Where::Nets: {
            const std::vector<model::BoardNet>& nets = m_selection.nets();
            if (nets.size() != 2 || nets[0].step != 0 || nets[1].step != 0) {
                emit failed(
                    QStringLiteral("Highlight two nets of the board first: N over their copper, or Ctrl and a "
                                   "click in the Nets panel."));
                return std::nullopt;
            }
            request.question.between = {nets[0].net, nets[1].net};
            break;
        }
    }
    return request;
}

void Clearances::measure() {
    if (std::optional<ClearanceRequest> asked = m_board ? request() : std::nullopt) {
        m_checker.start(m_board, std::move(*asked));
        emit started();
    }
}

void Clearances::take(const std::shared_ptr<const model::Document>& board, const ClearanceRequest& request,
                      const ClearanceResult& answer) {
    endShowing();
    m_asked = request;
    m_result = answer;
    m_locations.setSpacings(board, spacingsOf(answer), request.isOfRules ? request.rules : model::RuleTable{});
    if (request.isOfRules && m_rules.rules() == request.rules) {
        m_rules.setCounts(countsOf(answer));
    }
    QStringList words{m_locations.summary()};
    for (const std::string& note : answer.notes) {
        words += QString::fromStdString(note);
    }
    m_panel->setRemarks(words.mid(1).join('\n'));
    emit finished(words.join(QStringLiteral("; ")));
}

void Clearances::step(int by) {
    const QAbstractItemModel& rows = *m_panel->table().model();
    if (rows.rowCount() == 0) {
        return;
    }
    const int now = m_panel->table().currentIndex().row();  // -1: none
    const int next = now < 0 ? (by > 0 ? 0 : rows.rowCount() - 1) : now + by;
    m_panel->table().setCurrentIndex(rows.index((next + rows.rowCount()) % rows.rowCount(), 0));
}

void Clearances::show(const ClearanceModel::Location& location) {
    const model::StepTree& tree = m_selection.tree();
    const auto copy = std::ranges::find(tree.copies, location.step, &model::StepCopy::step);
    const auto row = static_cast<std::uint32_t>(copy - tree.copies.begin());
    const model::Document& step = *tree.steps[location.step];
    const auto onBoard = [&](model::LayerId layer) { return step.layerOfCopy(layer, copy->isFlipped); };
    const model::LayerId layer = onBoard(location.found.layer);
    m_sides.clear();
    std::vector<model::LayerId> layers{layer};
    for (const model::ElementId side : {location.found.a, location.found.b}) {
        if (side.isValid()) {
            m_sides.push_back({row, side});
            layers.push_back(onBoard(step.elements.layer[side.row()]));
        }
    }
    const model::Spacing& gap = location.found.spacing;
    m_isShowing = false;  // what was shown before ends with its selection
    m_selection.select(m_sides);
    m_sides = m_selection.selected();
    m_isShowing = true;
    m_views.setContrastLayers(std::move(layers));
    const model::Spacing shown{gap.distance, copy->placement.apply(gap.from), copy->placement.apply(gap.to)};
    const float around = std::max(kLeastAroundMm, kTimesAround * static_cast<float>(base::toMm(gap.distance)));
    m_probing.showPosition({(shown.from.x + shown.to.x) / 2, (shown.from.y + shown.to.y) / 2}, layer, around);
    emit spacingShown(model::LocalSpacing{shown, {row, location.found.a}, {row, location.found.b}, layer});
}

void Clearances::endShowing() {
    m_isShowing = false;
    m_views.setContrastLayers({});
    emit spacingShown(std::nullopt);
}

void Clearances::remember(const model::RuleTable& before) {
    if (!(before == m_rules.rules())) {
        m_history.push(new StateEdit<model::RuleTable>(QStringLiteral("the rules"), before, m_rules.rules(),
                                                       [this](const model::RuleTable& rules) {
                                                           if (!(m_rules.rules() == rules)) {
                                                               m_rules.setRules(rules);
                                                           }
                                                       }));
    }
}

void Clearances::editRules(QWidget& parent) {
    std::vector<std::string> nets;
    for (const model::Document* step : model::distinctSteps(*m_board)) {
        for (const model::Net& net : step->nets) {
            nets.push_back(net.name);
        }
    }
    auto* dialog = new RuleDialog(m_rules.rules(), std::move(nets), m_unit, &parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const model::RuleTable before = m_rules.rules();
        m_rules.setRules(dialog->rules().rules());
        m_panel->whatBox().setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        remember(before);
    });
    dialog->open();
}

base::Status Clearances::exportReport(const QString& path) const {
    const auto format = model::reportFormatOf(toPath(path).extension().string());
    if (!format || !m_asked) {
        return base::Error{base::ErrorCode::BadUsage,
                           m_asked ? "A report is written as .txt, .csv or .json."
                                   : "Nothing was measured or checked yet, so there is nothing to export."};
    }
    const std::string report = m_asked->isOfRules ? model::ruleReport(m_asked->rules, m_result.rules, *format, kAll)
                                                  : model::clearanceReport(m_result.clearances, *format);
    return write(path, QByteArray::fromStdString(report));
}

base::Status Clearances::openRules(const QString& path) {
    base::Result<model::RuleTable> rules = model::readRules(toPath(path));
    if (!rules) {
        return rules.error();
    }
    const model::RuleTable before = m_rules.rules();
    m_rules.setRules(std::move(*rules));
    remember(before);
    return base::Done{};
}

base::Status Clearances::saveRules(const QString& path) const {
    return write(path, QByteArray::fromStdString(model::toJson(m_rules.rules())));
}

}  // namespace ui
