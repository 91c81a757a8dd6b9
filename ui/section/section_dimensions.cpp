#include "ui/section/section_dimensions.h"

namespace ui {

bool SectionDimensions::add(const model::SectionPosition& location) {
    if (!m_from) {
        m_from = location;
        return false;
    }
    m_all.push_back({*m_from, location});
    m_from.reset();
    return true;
}

bool SectionDimensions::giveUp() {
    const bool isBegun = m_from.has_value();
    m_from.reset();
    return isBegun;
}

void SectionDimensions::removeLast() {
    if (!giveUp() && !m_all.empty()) {
        m_all.pop_back();
    }
}

QString dimensionText(const model::SectionDimension& dimension, LengthUnit unit) {
    const QString length = lengthInBoth(dimension.length(), unit);
    if (dimension.isLevel() || dimension.isUpright()) {
        return length;
    }
    return QCoreApplication::translate("ui::SectionDimensions", "%1; %2 along, %3 high")
        .arg(length, lengthText(dimension.along(), unit), lengthText(dimension.height(), unit));
}

}  // namespace ui
