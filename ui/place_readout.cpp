#include "ui/place_readout.h"

#include <cmath>

namespace ui {

PlaceReadout::PlaceReadout(Probing& probing, StatusLine& line, QObject* parent) : QObject(parent), m_line(line) {
    connect(&probing, &Probing::pointedAt, this, [this](double x, double y) {
        m_cursor = base::PointD{x, y};
        show();
    });
    connect(&probing, &Probing::pointedAway, this, [this] {
        m_cursor.reset();
        show();
    });
}

void PlaceReadout::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    show();
}

void PlaceReadout::measureFrom(std::optional<base::PointD> place) {
    m_from = place;
    show();
}

void PlaceReadout::show() {
    if (!m_cursor) {
        m_line.showPlace({});
        return;
    }
    QString text = models::placeText(m_cursor->x, m_cursor->y, m_unit);
    if (m_from) {
        const double dx = m_cursor->x - m_from->x;
        const double dy = m_cursor->y - m_from->y;
        text += QStringLiteral("   Δ %1   %2")
                    .arg(models::placeText(dx, dy, m_unit), models::lengthText(std::hypot(dx, dy), m_unit));
    }
    const QString note = m_note ? m_note(*m_cursor) : QString();
    m_line.showPlace(note.isEmpty() ? text : text + QStringLiteral("   ") + note);
}

}  // namespace ui
