#include "model/measure/section_dimension.h"

#include <cmath>

namespace model {

namespace {

bool isCorner(const SectionPosition& position) {
    return position.isOnUpright && position.isOnLevel;
}

}  // namespace

bool SectionDimension::isLevel() const {
    const bool areUpright = from.isOnUpright && to.isOnUpright && !(isCorner(from) && isCorner(to));
    return areUpright || from.z == to.z;
}

bool SectionDimension::isHeightAlone() const {
    const bool areLevel = from.isOnLevel && to.isOnLevel && !(isCorner(from) && isCorner(to));
    return areLevel || from.along == to.along;
}

std::pair<SectionPosition, SectionPosition> SectionDimension::ends() const {
    std::pair ends(from, to);
    if (isLevel()) {
        ends.first.z = ends.second.z;
    } else if (isHeightAlone()) {
        ends.first.along = ends.second.along;
    }
    return ends;
}

double SectionDimension::along() const {
    return std::abs(to.along - from.along);
}

double SectionDimension::height() const {
    return std::abs(to.z - from.z);
}

double SectionDimension::length() const {
    return isLevel() ? along() : isHeightAlone() ? height() : std::hypot(along(), height());
}

}  // namespace model
