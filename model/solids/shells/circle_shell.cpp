#include "model/solids/shells/circle_shell.h"

namespace model {

EdgeLoops circleOutline(const CircleGeometry& circle) {
    EdgeLoops loops;
    if (circle.diameter > 0 && circle.innerDiameter < circle.diameter) {
        loops.addCircle(toDouble(circle.centre), circle.diameter / 2.0);
        if (circle.innerDiameter > 0) {
            loops.addCircle(toDouble(circle.centre), circle.innerDiameter / 2.0);
        }
    }
    return loops;
}

}  // namespace model
