#include "ui/shell/position_readout.h"

#include <cmath>

namespace ui {

PositionReadout::PositionReadout(Probing& probing, StatusLine& line, QObject* parent) : QObject(parent), m_line(line) {
    connect(&probing, &Probing::pointedAt, this, [this](double x, double y) {
        m_cursor = base::PointD{x, y};
        show();
    });
    connect(&probing, &Probing::pointedAway, this, [this] {
        m_cursor.reset();
        show();
    });
}

void PositionReadout::setUnit(LengthUnit unit) {
    m_unit = unit;
    show();
}

void PositionReadout::measureFrom(std::optional<base::PointD> location) {
    m_from = location;
    show();
}

void PositionReadout::show() {
    if (!m_cursor) {
        m_line.showPosition({});
        return;
    }
    QString text = positionText(m_cursor->x, m_cursor->y, m_unit);
    if (m_from) {
        const double dx = m_cursor->x - m_from->x;
        const double dy = m_cursor->y - m_from->y;
        text +=
            QStringLiteral("   Δ %1   %2").arg(positionText(dx, dy, m_unit), lengthText(std::hypot(dx, dy), m_unit));
    }
    const QString note = m_note ? m_note(*m_cursor) : QString();
    m_line.showPosition(note.isEmpty() ? text : text + QStringLiteral("   ") + note);
}

}  // namespace ui
