#include "model/export/clearance_map_export.h"

#include <cmath>

#include "model/board/copies.h"
#include "model/text/formatting.h"

namespace model {

namespace {

std::string nameOf(const Document& step, NetId net) {
    return net.isValid() ? csvField(step.nets[net.row()].name) : "";
}

}  // namespace

std::string clearanceMapCsv(const Document& board, LayerId layer, const ClearanceMap& map) {
    const StepTree tree = unfoldCopies(board);
    const std::string onLayer = csvField(board.layer(layer).name);
    std::string text = "step,copy,layer,x_nm,y_nm,spacing_nm,net_a,net_b\n";
    for (std::size_t cell = 0; cell < map.nm.size(); ++cell) {
        if (!(map.nm[cell] > 0.0F) || std::isinf(map.nm[cell])) {
            continue;
        }
        const MapNets& nets = map.nets[cell];
        const Document& step = *tree.steps[tree.copies[nets.copy].step];
        const PointD at = map.frame.centreOf(static_cast<double>(cell % map.frame.width),
                                             static_cast<double>(cell / map.frame.width));
        text += csvField(step.job.step) + ',' + std::to_string(nets.copy) + ',' + onLayer + ',' +
                std::to_string(std::llround(at.x)) + ',' + std::to_string(std::llround(at.y)) + ',' +
                std::to_string(std::llround(map.nm[cell])) + ',' + nameOf(step, nets.nearest) + ',' +
                nameOf(step, nets.other) + '\n';
    }
    return text;
}

}  // namespace model
