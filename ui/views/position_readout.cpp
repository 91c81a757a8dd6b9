#include "ui/views/position_readout.h"

#include <cmath>

namespace ui {

PositionReadout::PositionReadout(Probing& probing, Workspace& workspace, QObject* parent)
    : QObject(parent), m_workspace(workspace) {
    connect(&probing, &Probing::pointedAt, this, [this](double x, double y) {
        m_pointer = base::PointD{x, y};
        update();
    });
    connect(&probing, &Probing::pointedAway, this, [this] {
        m_pointer.reset();
        update();
    });
    connect(&workspace, &Workspace::unitChanged, this, &PositionReadout::update);
}

void PositionReadout::measureFrom(std::optional<base::PointD> location) {
    m_from = location;
    update();
}

void PositionReadout::snapTo(std::optional<base::PointD> location) {
    m_snapped = location;
    update();
}

void PositionReadout::update() {
    if (!m_pointer) {
        emit changed({});
        return;
    }
    const LengthUnit unit = m_workspace.unit();
    const base::PointD at = m_snapped.value_or(*m_pointer);
    QString text = positionText(at.x, at.y, unit);
    if (m_from) {
        const double dx = at.x - m_from->x;
        const double dy = at.y - m_from->y;
        text += QStringLiteral("   Δ %1   %2").arg(positionText(dx, dy, unit), lengthText(std::hypot(dx, dy), unit));
    }
    const QString note = m_note ? m_note(at) : QString();
    emit changed(note.isEmpty() ? text : text + QStringLiteral("   ") + note);
}

}  // namespace ui
