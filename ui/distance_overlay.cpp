#include "ui/distance_overlay.h"

#include <QPainter>

namespace ui {

using model::DistanceField;

DistanceOverlay::DistanceOverlay(BoardViews& views, models::SelectionModel& selection, QObject* parent)
    : QObject(parent), m_views(views), m_selection(selection) {
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(0);
    connect(&m_refresh, &QTimer::timeout, this, &DistanceOverlay::ask);
    connect(&selection, &models::SelectionModel::selectionChanged, this, &DistanceOverlay::refresh);
    connect(&selection, &models::SelectionModel::netsChanged, this, &DistanceOverlay::refresh);
    connect(&views.flat().controller(), &CameraController::moved, this, &DistanceOverlay::refresh);  // turned over?
    connect(&m_work.background(), &Background::finished, this, &DistanceOverlay::deliver);
    for (BoardView* view : views.both()) {
        m_pictures[static_cast<std::size_t>(view->kind())] = new DistancePicture(*view, this);
        connect(m_pictures[static_cast<std::size_t>(view->kind())], &DistancePicture::failed, this,
                &DistanceOverlay::told);
        view->addPainter([this, view](QPainter& painter) { paintLegend(painter, *view); });
    }
}

void DistanceOverlay::setBoard(const LoadedBoard& board) {
    m_work.cancel();
    m_question.reset();
    m_cursor.reset();
    m_board = board.document;
    m_place.origin = board.model->origin;
    show(nullptr);
    refresh();
}

void DistanceOverlay::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    m_views.requestOverlay();
}

void DistanceOverlay::setOn(bool isOn) {
    m_isOn = isOn;
    refresh();
}

void DistanceOverlay::setReach(double nm) {
    m_reach = nm;
    for (DistancePicture* picture : m_pictures) {
        picture->setReach(nm);
    }
}

void DistanceOverlay::pointAt(std::optional<base::PointD> place) {
    m_cursor = place;
    if (m_field) {
        m_views.requestOverlay();
    }
}

bool DistanceOverlay::isPending() const {
    return m_refresh.isActive() || m_work.isRunning() || m_pictures[0]->isPending() || m_pictures[1]->isPending();
}

/// Does nothing if what is asked is what was asked before.
void DistanceOverlay::ask() {
    std::optional<Question> question;
    if (m_isOn && m_board) {
        question = Question{m_layer(), m_selection.ownElements()};
    }
    if (question == m_question) {
        return;
    }
    m_work.cancel();
    m_question = question;
    show(nullptr);
    if (!question) {
        emit told({});
    } else if (!question->layer.isValid()) {
        emit told(QStringLiteral("show a copper layer"));
    } else {
        work(std::move(*question));
    }
}

void DistanceOverlay::work(Question question) {
    using Field = std::shared_ptr<const DistanceField>;
    const auto measure = [board = m_board, question = std::move(question)](base::Progress& progress) {
        base::Result<DistanceField> field = question.targets.empty()
                                                ? DistanceField::betweenNets(*board, question.layer, progress)
                                                : DistanceField::toTargets(*board, question.layer, question.targets);
        return field ? base::Result<Field>(std::make_shared<const DistanceField>(std::move(*field))) : field.error();
    };
    m_work.ask(measure, "Measuring distances", "not enough memory for a map of this layer");
    emit told(QStringLiteral("measuring…"));
}

void DistanceOverlay::deliver() {
    if (const auto field = m_work.take()) {
        show(*field);
        emit told(legend().title);
    } else {
        emit told(reasonFor(field.error()));
    }
}

void DistanceOverlay::show(std::shared_ptr<const DistanceField> field) {
    m_field = std::move(field);
    for (DistancePicture* picture : m_pictures) {
        const bool hasOutline = m_board && !m_board->board.isEmpty();
        picture->setReach(m_reach);
        picture->setField(m_field, hasOutline ? m_board->board : m_field ? m_field->extent() : model::Box(), m_place);
    }
}

QString DistanceOverlay::reasonFor(const base::Error& error) const {
    QString text = QString::fromStdString(error.text);
    if (m_question->targets.empty() && m_board->nets.empty()) {
        text += QStringLiteral("; the board has no nets: Board, Nets from the copper finds them");
    }
    if (m_selection.tree().copies.size() > 1) {
        text += QStringLiteral("; steps that the panel places are mapped when they are opened by themselves");
    }
    return text;
}

QString DistanceOverlay::targetName() const {
    const std::vector<model::BoardNet>& nets = m_selection.nets();
    if (nets.size() == 1 && m_selection.selected().empty()) {
        return QString::fromStdString(m_board->nets[nets.front().net.row()].name);
    }
    return !m_selection.title().isEmpty() && nets.empty() ? m_selection.title() : QStringLiteral("the selection");
}

DistanceLegend DistanceOverlay::legend() const {
    DistanceLegend legend;
    legend.reach = m_reach;
    legend.unit = m_unit;
    if (m_field) {
        const QString layer = QString::fromStdString(m_board->layer(m_field->layer()).name);
        legend.title = m_field->kind() == DistanceField::Kind::BetweenNets
                           ? QStringLiteral("%1: gaps between nets").arg(layer)
                           : QStringLiteral("%1: distance to %2").arg(layer, targetName());
        if (m_cursor) {
            legend.mark = m_field->at(*m_cursor, model::kMostMapReach);
        }
    }
    return legend;
}

QString DistanceOverlay::textAt(base::PointD place) const {
    const double value = m_field ? m_field->at(place, model::kMostMapReach) : 0.0;
    if (value <= 0.0 || value > model::kMostMapReach) {
        return {};
    }
    const bool isGap = m_field->kind() == DistanceField::Kind::BetweenNets;
    return QStringLiteral("%1 %2").arg(isGap ? QStringLiteral("gap") : QStringLiteral("distance"),
                                       models::lengthText(value, m_unit));
}

void DistanceOverlay::paintLegend(QPainter& painter, const BoardView& view) const {
    if (m_field) {
        legend().paint(painter, view.controller().viewport());
    }
}

}  // namespace ui
