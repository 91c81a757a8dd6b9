#include "model/board/board_face.h"

#include <algorithm>
#include <cmath>

namespace model {

Nm BoardFace::besideCopper() const {
    return isFlat ? onCopper() : substrate + outwards() * mask;
}

Nm BoardFace::onCopper() const {
    if (isFlat) {
        return copper + outwards() * mask;
    }
    const Nm thin = copper + outwards() * static_cast<Nm>(std::lround(kMaskOnCopper * mask));
    const Nm level = substrate + outwards() * mask;
    return isTop ? std::max(thin, level) : std::min(thin, level);
}

}  // namespace model
