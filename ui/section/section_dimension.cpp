#include "ui/section/section_dimension.h"

#include <cmath>

namespace ui {

void SectionDimension::add(const SectionPosition& location) {
    if (m_from && !m_to) {
        m_to = location;
    } else {
        m_from = location;
        m_to.reset();
    }
}

bool SectionDimension::isAlongAlone() const {
    const bool areUpright = m_from->isOnUpright && m_to->isOnUpright && !(m_from->isOnLevel && m_to->isOnLevel);
    return areUpright || m_from->z == m_to->z;
}

bool SectionDimension::isHeightAlone() const {
    const bool areLevel = m_from->isOnLevel && m_to->isOnLevel && !(m_from->isOnUpright && m_to->isOnUpright);
    return areLevel || m_from->along == m_to->along;
}

std::optional<std::pair<SectionPosition, SectionPosition>> SectionDimension::ends() const {
    if (!m_to) {
        return std::nullopt;
    }
    std::pair ends(*m_from, *m_to);
    if (isAlongAlone()) {
        ends.first.z = ends.second.z;
    } else if (isHeightAlone()) {
        ends.first.along = ends.second.along;
    }
    return ends;
}

QString SectionDimension::text(LengthUnit unit) const {
    if (!m_to) {
        return {};
    }
    const double along = std::abs(m_to->along - m_from->along);
    const double height = std::abs(m_to->z - m_from->z);
    const QString alongText = SectionDimension::tr("%1 along").arg(lengthText(along, unit));
    const QString heightText = SectionDimension::tr("%1 high").arg(lengthText(height, unit));
    if (isAlongAlone()) {
        return alongText;
    }
    if (isHeightAlone()) {
        return heightText;
    }
    return SectionDimension::tr("%1, %2, %3 apart")
        .arg(alongText, heightText, lengthText(std::hypot(along, height), unit));
}

}  // namespace ui
