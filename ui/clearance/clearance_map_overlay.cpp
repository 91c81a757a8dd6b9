#include "ui/clearance/clearance_map_overlay.h"

#include <QGuiApplication>
#include <QPainter>

#include "ui/common/net_name.h"

namespace ui {

using model::BoardDistances;
using model::DistanceField;

ClearanceMapOverlay::ClearanceMapOverlay(BoardViews& views, Probing& probing, Workspace& workspace, QObject* parent)
    : QObject(parent), m_views(views), m_workspace(workspace), m_selection(workspace.selection()) {
    connect(&workspace, &Workspace::boardOpened, this, &ClearanceMapOverlay::setBoard);
    connect(&workspace, &Workspace::unitChanged, this, [this] { m_views.requestOverlay(); });
    connect(&workspace, &Workspace::currentLayerChanged, this, &ClearanceMapOverlay::refresh);
    connect(&probing, &Probing::pointedAt, this, [this](double x, double y) { pointAt(base::PointD{x, y}); });
    connect(&probing, &Probing::pointedAway, this, [this] { pointAt(std::nullopt); });
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(0);
    connect(&m_refresh, &QTimer::timeout, this, &ClearanceMapOverlay::ask);
    connect(&m_selection, &SelectionModel::selectionChanged, this, &ClearanceMapOverlay::refresh);
    connect(&m_selection, &SelectionModel::netsChanged, this, &ClearanceMapOverlay::refresh);
    connect(&views.flat().controller(), &CameraController::moved, this, &ClearanceMapOverlay::refresh);  // flipped?
    connect(&m_work.background(), &Background::finished, this, &ClearanceMapOverlay::deliver);
    for (BoardView* view : views.both()) {
        m_pictures[static_cast<std::size_t>(view->kind())] = new ClearanceMapPicture(*view, this);
        connect(m_pictures[static_cast<std::size_t>(view->kind())], &ClearanceMapPicture::failed, this,
                &ClearanceMapOverlay::reported);
        view->addPainter([this, view](QPainter& painter) { paintLegend(painter, *view); });
        view->addCorner([this, view] {
            return m_field ? legend().place(QGuiApplication::font(), view->controller().viewport()) : QRectF();
        });
    }
}

void ClearanceMapOverlay::setBoard(const LoadedBoard& board) {
    m_work.cancel();
    m_question.reset();
    m_cursor.reset();
    m_board = board.document;
    show(nullptr);
    refresh();
}

void ClearanceMapOverlay::setOn(bool isOn) {
    m_isOn = isOn;
    refresh();
}

void ClearanceMapOverlay::setReach(double nm) {
    m_reach = nm;
    for (ClearanceMapPicture* picture : m_pictures) {
        picture->setReach(nm);
    }
}

void ClearanceMapOverlay::pointAt(std::optional<base::PointD> location) {
    m_cursor = location;
    if (m_field) {
        m_views.requestOverlay();
    }
}

bool ClearanceMapOverlay::isPending() const {
    return m_refresh.isActive() || m_work.isRunning() || m_pictures[0]->isPending() || m_pictures[1]->isPending();
}

/// Does nothing if what is asked is what was asked before.
void ClearanceMapOverlay::ask() {
    std::optional<Question> question;
    if (m_isOn && m_board) {
        question = Question{m_layer(), targets()};
    }
    if (question == m_question) {
        return;
    }
    m_work.cancel();
    m_question = question;
    show(nullptr);
    if (!question) {
        emit reported({});
    } else if (!question->layer.isValid()) {
        emit reported(tr("show a copper layer"));
    } else {
        work(std::move(*question));
    }
}

void ClearanceMapOverlay::work(Question question) {
    using Field = std::shared_ptr<const BoardDistances>;
    const auto measure = [board = m_board, question = std::move(question)](base::Progress& progress) {
        base::Result<BoardDistances> field = question.targets.empty()
                                                 ? BoardDistances::betweenNets(*board, question.layer, progress)
                                                 : BoardDistances::toTargets(*board, question.layer, question.targets);
        return field ? base::Result<Field>(std::make_shared<const BoardDistances>(std::move(*field))) : field.error();
    };
    m_work.run(measure, tr("Measuring distances"), tr("not enough memory for a map of this layer"));
    emit reported(tr("measuring…"));
}

void ClearanceMapOverlay::deliver() {
    if (const auto field = m_work.take()) {
        show(*field);
        const std::string note = m_field->note();
        emit reported(legend().title + (note.empty() ? QString() : "; " + QString::fromStdString(note)));
    } else {
        emit reported(reasonFor(field.error()));
    }
}

void ClearanceMapOverlay::show(std::shared_ptr<const BoardDistances> field) {
    m_field = std::move(field);
    for (ClearanceMapPicture* picture : m_pictures) {
        const bool hasOutline = m_board && !m_board->board.isEmpty();
        picture->setReach(m_reach);
        picture->setField(m_field, hasOutline ? m_board->board : m_field ? m_field->extent() : model::Box());
    }
}

QString ClearanceMapOverlay::reasonFor(const base::Error& error) const {
    QString text = QString::fromStdString(error.text);
    if (m_question->targets.empty() && m_board->nets.empty()) {
        text += tr("; the board has no nets: Board, Infer nets from copper finds them");
    }
    return text;
}

/// What is selected or highlighted, in all copies.
std::vector<model::BoardElement> ClearanceMapOverlay::targets() const {
    std::vector<model::BoardElement> targets = m_selection.selected();
    const model::StepTree& tree = m_selection.tree();
    for (const model::BoardNet& net : m_selection.nets()) {
        for (std::uint32_t copy = 0; copy < tree.copies.size(); ++copy) {
            if (tree.copies[copy].step == net.step) {
                for (const model::ElementId element : tree.steps[net.step]->elementsOf(net.net)) {
                    targets.push_back({copy, element});
                }
            }
        }
    }
    return targets;
}

QString ClearanceMapOverlay::targetName() const {
    const std::vector<model::BoardNet>& nets = m_selection.nets();
    if (nets.size() == 1 && m_selection.selected().empty()) {
        return netName(*m_selection.tree().steps[nets.front().step], nets.front().net);
    }
    return !m_selection.title().isEmpty() && nets.empty() ? m_selection.title() : tr("the selection");
}

ClearanceMapLegend ClearanceMapOverlay::legend() const {
    ClearanceMapLegend legend;
    legend.reach = m_reach;
    legend.unit = m_workspace.unit();
    if (m_field) {
        const QString layer = QString::fromStdString(m_board->layer(m_field->layer()).name);
        legend.title = m_field->kind() == DistanceField::Kind::BetweenNets
                           ? tr("%1: spacing between nets").arg(layer)
                           : tr("%1: distance to %2").arg(layer, targetName());
        if (m_cursor) {
            legend.mark = m_field->at(*m_cursor, model::kMostMapReach);
        }
    }
    return legend;
}

QString ClearanceMapOverlay::textAt(base::PointD location) const {
    const double value = m_field ? m_field->at(location, model::kMostMapReach) : 0.0;
    if (value <= 0.0 || value > model::kMostMapReach) {
        return {};
    }
    const bool isSpacing = m_field->kind() == DistanceField::Kind::BetweenNets;
    return QStringLiteral("%1 %2").arg(isSpacing ? tr("spacing") : tr("distance"),
                                       lengthText(value, m_workspace.unit()));
}

void ClearanceMapOverlay::paintLegend(QPainter& painter, const BoardView& view) const {
    if (m_field) {
        legend().paint(painter, view.controller().viewport());
    }
}

}  // namespace ui
