#include "ui/measuring.h"

#include <QGuiApplication>
#include <QWindow>
#include <cmath>
#include <numbers>

#include "model/measure/local_gap.h"
#include "ui/measurement_painter.h"

namespace ui {

using model::SnapKind;
using model::session::MeasuredEnd;
using model::session::Measurement;

namespace {

/// A place moved onto the nearest line through `from` whose direction is a multiple of `step` radians.
base::PointD locked(const MeasuredEnd& from, base::PointD place, double step) {
    const base::PointD way = {place.x - from.x, place.y - from.y};
    const double angle = std::round(std::atan2(way.y, way.x) / step) * step;
    const double length = way.x * std::cos(angle) + way.y * std::sin(angle);
    return {from.x + length * std::cos(angle), from.y + length * std::sin(angle)};
}

/// The step of directions that held keys ask for; none: any.
std::optional<double> lockOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::ShiftModifier)     ? std::optional(std::numbers::pi / 2)
           : modifiers.testFlag(Qt::ControlModifier) ? std::optional(std::numbers::pi / 4)
                                                     : std::nullopt;
}

void showCursor(BoardView& view, Qt::CursorShape shape) {
    if (auto* window = qobject_cast<QWindow*>(&view.canvas())) {
        window->setCursor(shape);
    } else if (auto* widget = qobject_cast<QWidget*>(&view.canvas())) {
        widget->setCursor(shape);
    }
}

}  // namespace

Measuring::Measuring(BoardViews& views, Probing& probing, MeasurementKeeping& kept, QObject* parent)
    : QObject(parent), m_views(views), m_probing(probing), m_kept(kept) {
    for (BoardView* view : views.both()) {
        watch(*view);
    }
    connect(&kept, &MeasurementKeeping::changed, this, [this] { m_views.requestOverlay(); });
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
    m_index = board.index;
    m_place.origin = board.model->origin;
    m_snapper.reset();
    m_picker.reset();
    if (m_index) {
        m_snapper.emplace(m_index);
        m_picker.emplace(m_index);
    }
    m_hoverView = nullptr;
    m_isLatestFull = false;
    setTool(Tool::None);
}

void Measuring::setHeights(std::shared_ptr<const model::Document> document) {
    if (m_index) {
        m_index = model::withHeights(*m_index, std::move(document));
    }
}

void Measuring::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    m_kept.list().setUnit(unit);
    m_views.requestOverlay();
}

void Measuring::setTool(Tool tool) {
    m_tool = m_index ? tool : Tool::None;
    forgetFirst();
    m_under.reset();
    m_probing.setSelecting(m_tool == Tool::None);
    for (BoardView* view : m_views.both()) {
        showCursor(*view, m_tool == Tool::None ? Qt::ArrowCursor : Qt::CrossCursor);
    }
    if (m_tool != Tool::None && m_hoverView != nullptr) {
        hover(*m_hoverView, m_hoverAt, Qt::NoModifier);
    }
    emit toolChanged();
    if (m_tool == Tool::Points) {
        emit told(QStringLiteral("Click two points; Shift straight, Ctrl in steps of 45°, Alt catches nothing"));
    } else if (m_tool == Tool::Objects) {
        emit told(QStringLiteral("Click two elements to measure from edge to edge"));
    }
}

bool Measuring::stepBack() {
    if (m_first) {
        forgetFirst();
        return true;
    }
    const bool hadTool = m_tool != Tool::None;
    if (hadTool) {
        setTool(Tool::None);
    }
    return hadTool;
}

void Measuring::forgetFirst() {
    m_first.reset();
    m_views.requestOverlay();
    emit begunAt(std::nullopt);
}

std::optional<Measuring::Pointed> Measuring::pointedAt(BoardView& view, QPointF position) {
    Pointed pointed;
    pointed.layers = m_probing.layersOf(view);
    const auto [origin, direction] = view.controller().rayAt(position);
    pointed.isFromBelow = direction.z > 0.0F;
    if (view.kind() == BoardView::Kind::Flat) {
        pointed.place = m_place.toJob(origin);
        return pointed;
    }
    const std::vector<model::Hit> hits = m_probing.hitsAt(view, position);
    const std::optional<glm::vec3> face = view.controller().boardPointAt(position);
    if (hits.empty() && !face) {
        return std::nullopt;
    }
    // The picker counts its steps in millimetres.
    const glm::vec3 seen =
        hits.empty() ? *face : origin + glm::normalize(direction) * static_cast<float>(hits.front().depth);
    pointed.place = m_place.toJob(seen);
    pointed.layer = hits.empty() ? model::LayerId{} : hits.front().layer;
    for (std::size_t row = 0; row < pointed.layers.size(); ++row) {
        pointed.layers[row].isVisible = pointed.layer == model::LayerId{row};
    }
    return pointed;
}

std::optional<Measuring::Caught> Measuring::catchAt(BoardView& view, QPointF position,
                                                    Qt::KeyboardModifiers modifiers) {
    const std::optional<Pointed> pointed = pointedAt(view, position);
    if (!pointed || pointed->layers.empty()) {
        return std::nullopt;
    }
    const std::optional<double> lock = m_first ? lockOf(modifiers) : std::nullopt;
    const double reach = kCatchPixels * static_cast<double>(view.controller().mmPerPixel()) * base::kNmPerMm;
    model::SnapPoint snap{SnapKind::Free, pointed->place, {}, pointed->layer, 0.0};
    if (!modifiers.testFlag(Qt::AltModifier)) {
        snap = m_snapper->at(pointed->place, reach, pointed->layers, pointed->isFromBelow);
        snap.layer = snap.kind == SnapKind::Free ? pointed->layer : snap.layer;
    }
    const base::PointD at = lock ? locked(m_first->end, snap.at, *lock) : snap.at;
    const auto element = snap.kind == SnapKind::Free ? std::nullopt : std::optional(snap.element);
    return Caught{endOf(at, snap.layer, element, snap.kind), snap.kind, snap.layer, element};
}

std::optional<Measuring::Caught> Measuring::elementAt(BoardView& view, QPointF position) {
    const std::vector<model::Hit> hits = m_probing.hitsAt(view, position);
    const std::optional<Pointed> pointed = hits.empty() ? std::nullopt : pointedAt(view, position);
    if (!pointed) {
        return std::nullopt;
    }
    const model::Hit& hit = hits.front();
    return Caught{endOf(pointed->place, hit.layer, hit.at, SnapKind::Free), SnapKind::Free, hit.layer, hit.at};
}

MeasuredEnd Measuring::endOf(base::PointD at, model::LayerId layer, std::optional<model::BoardElement> element,
                             SnapKind kind) const {
    MeasuredEnd end{at.x, at.y, {}, {}, toString(kind)};
    if (layer.isValid()) {
        end.layer = m_index->board->layer(layer).name;
    }
    if (element && element->element.isValid()) {
        const model::NetId net = model::netOf(*m_index, *element);
        const model::Document& step = *m_index->tree.steps[m_index->tree.copies[element->copy].step];
        end.net = net.isValid() ? step.nets[net.row()].name : "";
    }
    return end;
}

Measurement Measuring::between(const Caught& from, const Caught& to) const {
    Measurement measurement;
    measurement.from = from.end;
    measurement.to = to.end;
    measurement.dz = model::heightBetween(*m_index->board, from.layer, to.layer).value_or(0.0);
    return measurement;
}

void Measuring::hover(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    m_hoverView = &view;
    m_hoverAt = position;
    if (m_tool == Tool::Points) {
        m_under = catchAt(view, position, modifiers);
        view.requestOverlay();
    }
}

void Measuring::click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers) {
    if (m_tool == Tool::Points) {
        if (const auto caught = catchAt(view, position, modifiers)) {
            clickPoint(*caught);
        }
    } else if (m_tool == Tool::Objects) {
        if (const auto caught = elementAt(view, position)) {
            clickObject(*caught);
        }
    }
}

void Measuring::clickPoint(const Caught& caught) {
    m_under = caught;
    if (!m_first) {
        m_first = caught;
        emit begunAt(base::PointD{caught.end.x, caught.end.y});
        m_views.requestOverlay();
        return;
    }
    const Measurement measurement = between(*m_first, caught);
    forgetFirst();
    keep(measurement, {});
}

void Measuring::clickObject(const Caught& caught) {
    if (!m_first) {
        m_first = caught;
        emit told(QStringLiteral("From %1: click the second element")
                      .arg(QString::fromStdString(model::nameOf(*m_index, *caught.element))));
        m_views.requestOverlay();
        return;
    }
    base::Progress progress;
    const auto separation = model::separationOf(*m_index, *m_first->element, *caught.element, progress);
    forgetFirst();
    const model::Way* way = separation ? separation->main() : nullptr;
    if (way == nullptr) {
        emit told(separation ? QString::fromStdString(separation->remarks.front())
                             : QString::fromStdString(separation.error().text));
        return;
    }
    Measurement measurement;
    measurement.from = endOf(way->gap.from, way->from.layer, way->from.at, SnapKind::Edge);
    measurement.to = endOf(way->gap.to, way->to.layer, way->to.at, SnapKind::Edge);
    measurement.dz = way->dz;
    measurement.overlap = way->relation == model::Relation::Overlapping ? way->overlap : 0.0;
    measurement.isGap = true;
    keep(std::move(measurement), separation->remarks);
}

void Measuring::measureGapAtCursor() {
    const std::optional<Pointed> pointed =
        m_picker && m_hoverView != nullptr ? pointedAt(*m_hoverView, m_hoverAt) : std::nullopt;
    if (!pointed) {
        emit told(QStringLiteral("Point at the board to measure the gap there"));
        return;
    }
    // In 3D what is seen may be lacquer or laminate: all visible layers count.
    const auto gap = model::gapAt(*m_picker, pointed->place, m_probing.layersOf(*m_hoverView));
    if (!gap) {
        emit told(QStringLiteral("There is no gap between two nets within 10 mm of the cursor"));
        return;
    }
    Measurement measurement;
    measurement.from = endOf(gap->gap.from, gap->layer, gap->from, SnapKind::Edge);
    measurement.to = endOf(gap->gap.to, gap->layer, gap->to, SnapKind::Edge);
    measurement.isGap = true;
    keep(std::move(measurement), {});
}

void Measuring::keep(Measurement measurement, const std::vector<std::string>& remarks) {
    QStringList said{models::valueText(measurement)};
    for (const std::string& remark : remarks) {
        said += QString::fromStdString(remark);
    }
    m_isLatestFull = true;
    m_kept.keep(std::move(measurement));
    emit told(said.join(QStringLiteral("; ")));
}

void Measuring::goTo(int row) {
    const Measurement& measurement = m_kept.list().measurements()[static_cast<std::size_t>(row)];
    if (!m_index || !m_kept.isHere(measurement)) {
        emit told(QStringLiteral("It was measured in step %1").arg(QString::fromStdString(measurement.step)));
        return;
    }
    for (BoardView* view : m_views.both()) {
        const glm::vec3 a = drawnPlaceOf(*view, m_place, *m_index->board, measurement.from);
        const glm::vec3 b = drawnPlaceOf(*view, m_place, *m_index->board, measurement.to);
        view->controller().show(glm::min(a, b), glm::max(a, b));
    }
}

void Measuring::paint(QPainter& painter, const BoardView& view) const {
    if (!m_index) {
        return;
    }
    const MeasurementPainter on(painter, view, m_place, *m_index->board);
    const auto& measurements = m_kept.list().measurements();
    for (std::size_t row = 0; row < measurements.size(); ++row) {
        if (measurements[row].isShown && m_kept.isHere(measurements[row])) {
            on.paint(measurements[row], m_unit, m_isLatestFull && row + 1 == measurements.size());
        }
    }
    if (m_first && m_under) {
        on.paint(between(*m_first, *m_under), m_unit, true);
    } else if (m_first) {
        on.paintSnap(m_first->end, m_first->kind);
    }
    if (m_under && m_hoverView == &view) {
        on.paintSnap(m_under->end, m_under->kind);
    }
}

}  // namespace ui
