#include "model/formats/kicad/unused_pads.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace model::kicad {

void UnusedPads::draw() {
    std::vector<std::int32_t> rows;
    for (const Waiting& waiting : m_waiting) {
        rows.push_back(waiting.row);
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (const std::int32_t row : rows) {
        std::vector<Waiting> pads;
        std::ranges::copy_if(m_waiting, std::back_inserter(pads), [&](const Waiting& w) { return w.row == row; });
        drawOn(row, pads);
    }
    m_waiting.clear();
}

void UnusedPads::drawOn(std::int32_t row, const std::vector<Waiting>& pads) {
    std::vector<std::pair<Point, std::int32_t>> ends;  // by x, with their nets
    const auto& features = m_canvas.step().features;
    if (static_cast<std::size_t>(row) < features.size()) {
        for (const formats::DrawnFeature& feature : features[static_cast<std::size_t>(row)]) {
            if (feature.subnet == SubnetKind::Trace) {
                ends.emplace_back(feature.a, feature.net);
                ends.emplace_back(feature.b, feature.net);
            }
        }
    }
    std::ranges::sort(ends);
    for (const Waiting& pad : pads) {
        bool isConnected = pad.reach < 0.0;
        const Point from{asNm(pad.at.x - pad.reach), std::numeric_limits<Nm>::min()};
        for (auto end = std::ranges::lower_bound(ends, std::pair(from, std::numeric_limits<std::int32_t>::min()));
             !isConnected && end != ends.end() && end->first.x <= pad.at.x + pad.reach; ++end) {
            isConnected = end->second == pad.origin.net &&
                          std::hypot(end->first.x - pad.at.x, end->first.y - pad.at.y) <= pad.reach;
        }
        if (isConnected) {
            m_canvas.drawPad(row, pad.origin, pad.symbol, pad.at, pad.clockwiseDeg);
        }
    }
}

}  // namespace model::kicad
