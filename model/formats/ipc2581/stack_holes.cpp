#include "model/formats/ipc2581/stack_holes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace model::ipc2581 {

namespace {

using formats::DrawnFeature;
using formats::kNoRow;

/// Writers round the two ways to write a hole differently.
constexpr Nm kPlaceReach = 5'000;
constexpr Nm kSizeReach = 1'000;

using Cell = std::pair<Nm, Nm>;
/// Names of layers, as written.
using Span = std::pair<std::string_view, std::string_view>;

Cell cellOf(Point p) {
    const auto cell = [](Nm nm) { return nm / kPlaceReach - (nm % kPlaceReach < 0 ? 1 : 0); };
    return {cell(p.x), cell(p.y)};
}

bool areNear(Point a, Point b) {
    return std::abs(std::int64_t{a.x} - b.x) <= kPlaceReach && std::abs(std::int64_t{a.y} - b.y) <= kPlaceReach;
}

/// Whichever end is named first.
Span spanOf(std::string_view from, std::string_view to) {
    return {std::min(from, to), std::max(from, to)};
}

class HoleJoin {
public:
    HoleJoin(Reading& reading, formats::DrawnStep& step, LayerList& layers)
        : m_reading(reading), m_step(step), m_layers(layers) {
        for (std::size_t layer = 0; layer < step.features.size(); ++layer) {
            const bool hasHoles = layers[layer].isHoles() && layers[layer].drawn.use == LayerUse::Plain;
            for (std::size_t i = 0; hasHoles && i < step.features[layer].size(); ++i) {
                if (step.features[layer][i].kind == formats::DrawnKind::Pad) {
                    m_drawn.emplace(cellOf(step.features[layer][i].a), Drawn{layer, i});
                }
            }
        }
    }

    /// False: no layer draws it.
    bool join(const StackHole& hole) {
        const std::uint32_t line = hole.start.line();
        const Span span = spanOf(hole.from, hole.to);
        const Drawn* const drawn = find(m_reading.rounded(hole.turn.origin, line), diameterOf(hole), span);
        if (drawn == nullptr) {
            return false;
        }
        DrawnFeature& feature = m_step.features[drawn->layer][drawn->feature];
        feature.net = feature.net == kNoRow ? hole.net : feature.net;
        if (spanOfLayer(drawn->layer) != span) {
            m_spans[drawn->layer].insert(span);
        }
        m_reading.report(Severity::Info, line,
                         "a hole of a PadStack that a layer of holes draws too is taken for one hole");
        return true;
    }

    /// What holes say of the layers that draw them.
    void setSpans() {
        for (const auto& [layer, spans] : m_spans) {
            SourceLayer& source = m_layers[layer];
            if (spans.size() == 1) {
                std::tie(source.from, source.to) = *spans.begin();
            } else {
                m_reading.report(
                    Severity::Warning, source.line,
                    "a layer of holes has no span, and its holes have several; all of them pass all copper");
            }
        }
    }

private:
    struct Drawn {
        std::size_t layer;
        std::size_t feature;
    };

    [[nodiscard]] Nm diameterOf(const StackHole& hole) {
        const double written = m_reading.lengthOr(hole.start, "diameter", m_reading.unitNm(), 0.0);
        return m_reading.rounded({written * hole.turn.scale, 0.0}, hole.start.line()).x;
    }

    [[nodiscard]] Span spanOfLayer(std::size_t layer) const { return spanOf(m_layers[layer].from, m_layers[layer].to); }

    /// The hole drawn there, of a layer with this span rather than of one without any.
    [[nodiscard]] const Drawn* find(Point place, Nm diameter, const Span& span) const {
        const Drawn* found = nullptr;
        const Cell middle = cellOf(place);
        for (Nm x = middle.first - 1; x <= middle.first + 1; ++x) {
            for (Nm y = middle.second - 1; y <= middle.second + 1; ++y) {
                const auto [first, last] = m_drawn.equal_range({x, y});
                for (auto at = first; at != last; ++at) {
                    const bool isOfSpan = spanOfLayer(at->second.layer) == span;
                    const bool mayBe = isOfSpan || spanOfLayer(at->second.layer) == Span();
                    if (mayBe && fits(at->second, place, diameter) && (found == nullptr || isOfSpan)) {
                        found = &at->second;
                    }
                }
            }
        }
        return found;
    }

    [[nodiscard]] bool fits(const Drawn& drawn, Point place, Nm diameter) const {
        const DrawnFeature& feature = m_step.features[drawn.layer][drawn.feature];
        const formats::PadShape& shape = m_step.symbols[static_cast<std::size_t>(feature.symbol)].shape;
        return areNear(feature.a, place) && std::abs(shape.width - diameter) <= kSizeReach;
    }

    Reading& m_reading;
    formats::DrawnStep& m_step;
    LayerList& m_layers;
    std::multimap<Cell, Drawn> m_drawn;
    std::map<std::size_t, std::set<Span>> m_spans;  ///< of layers that say none
};

}  // namespace

std::vector<std::size_t> joinDrawnHoles(Reading& reading, std::span<const StackHole> holes, formats::DrawnStep& step,
                                        LayerList& layers) {
    HoleJoin join(reading, step, layers);
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < holes.size(); ++i) {
        if (!join.join(holes[i])) {
            others.push_back(i);
        }
    }
    join.setSpans();
    return others;
}

}  // namespace model::ipc2581
