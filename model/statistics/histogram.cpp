#include "model/statistics/histogram.h"

#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>

#include "model/base/assert.h"

namespace model {

namespace {

struct Value {
    Nm length = 0;
    StepElement at;
    auto operator<=>(const Value&) const = default;
};

std::uint64_t keyOf(Point p) {
    return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32U | static_cast<std::uint32_t>(p.y);
}

bool isOnCopper(const Document& document, ElementId id) {
    return document.layer(document.elements.layer[id.row()]).isBoardCopper();
}

std::optional<Nm> widthOf(const Document& document, ElementId id) {
    const std::uint32_t row = document.elements.geometry[id.row()];
    switch (document.elements.kind[id.row()]) {
        case ElementKind::Line: return document.lines[row].width;
        case ElementKind::Arc: return document.arcs[row].width;
        case ElementKind::Trail: return document.trails[row].width;
        default: return std::nullopt;
    }
}

/// The circle of an element, if it is one.
const CircleGeometry* circleOf(const Document& document, ElementId id) {
    return document.elements.kind[id.row()] == ElementKind::Circle
               ? &document.circles[document.elements.geometry[id.row()]]
               : nullptr;
}

class Measuring {
public:
    Measuring(const Document& document, Measure measure) : m_document(document), m_measure(measure) {
        if (measure == Measure::AnnularRing) {
            findPads();
        }
    }

    [[nodiscard]] std::optional<Nm> lengthOf(ElementId id) const {
        const std::uint8_t flags = m_document.elements.flags[id.row()];
        if (m_measure == Measure::TrackWidth) {
            const bool isTrack = (flags & (kHole | kPad)) == 0 && isOnCopper(m_document, id);
            return isTrack ? widthOf(m_document, id) : std::nullopt;
        }
        const CircleGeometry* hole = circleOf(m_document, id);
        if (hole == nullptr || (flags & kHole) == 0) {
            return std::nullopt;
        }
        return m_measure == Measure::HoleDiameter ? std::optional(hole->diameter) : ringOf(*hole, flags);
    }

private:
    void findPads() {
        for (std::size_t row = 0; row < m_document.elements.size(); ++row) {
            const ElementId id{row};
            const CircleGeometry* pad = circleOf(m_document, id);
            if (pad != nullptr && (m_document.elements.flags[row] & kHole) == 0 && isOnCopper(m_document, id)) {
                const auto [at, isFirst] = m_pads.try_emplace(keyOf(pad->centre), pad->diameter);
                at->second = std::min(at->second, pad->diameter);
            }
        }
    }

    [[nodiscard]] std::optional<Nm> ringOf(const CircleGeometry& hole, std::uint8_t flags) const {
        const auto pad = m_pads.find(keyOf(hole.centre));
        const bool hasRing = (flags & kPlated) != 0 && pad != m_pads.end();
        return hasRing ? std::optional((pad->second - hole.diameter) / 2) : std::nullopt;
    }

    const Document& m_document;
    Measure m_measure;
    std::unordered_map<std::uint64_t, Nm> m_pads;  ///< smallest round pad by its centre
};

std::size_t distinctLengths(const std::vector<Value>& values) {
    std::size_t count = values.empty() ? 0 : 1;
    for (std::size_t i = 1; i < values.size(); ++i) {
        count += values[i].length != values[i - 1].length ? 1 : 0;
    }
    return count;
}

std::vector<std::uint32_t> copiesOfSteps(const StepTree& tree) {
    std::vector<std::uint32_t> counts(tree.steps.size());
    for (const StepCopy& copy : tree.copies) {
        ++counts[copy.step];
    }
    return counts;
}

void addValues(const Document& document, std::uint32_t step, Measure measure, std::vector<Value>& values) {
    const Measuring measuring(document, measure);
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        const ElementId id{row};
        if (const std::optional<Nm> length = measuring.lengthOf(id)) {
            values.push_back({*length, {step, id}});
        }
    }
}

/// Values are in order; a new bar begins where the number of the bin does.
void fillBars(const std::vector<Value>& values, std::span<const std::uint32_t> copies, std::size_t mostBars,
              Histogram& out) {
    const bool isExact = distinctLengths(values) <= mostBars;
    const std::int64_t least = values.front().length;
    const std::int64_t span = values.back().length - least + 1;
    const auto binOf = [&](const Value& value) {
        return isExact ? std::int64_t{value.length}
                       : (value.length - least) * static_cast<std::int64_t>(mostBars) / span;
    };
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        if (i == 0 || binOf(values[i]) != binOf(values[i - 1])) {
            out.bars.push_back({values[i].length, values[i].length, {i, 0}, 0});
        }
        out.bars.back().most = values[i].length;
        ++out.bars.back().elements.count;
        out.bars.back().count += copies[values[i].at.step];
        out.elements.push_back(values[i].at);
    }
}

}  // namespace

Histogram histogramOf(const Document& board, Measure measure, std::size_t mostBars) {
    ASSERT(mostBars > 0);
    const StepTree tree = unfoldCopies(board);
    std::vector<Value> values;
    for (std::uint32_t step = 0; step < tree.steps.size(); ++step) {
        addValues(*tree.steps[step], step, measure, values);
    }
    std::ranges::sort(values);
    Histogram out;
    if (!values.empty()) {
        fillBars(values, copiesOfSteps(tree), mostBars, out);
    }
    return out;
}

std::vector<BoardElement> elementsOf(const Document& board, const Histogram& histogram, const HistogramBar& bar) {
    const StepTree tree = unfoldCopies(board);
    std::vector<std::vector<ElementId>> ofSteps(tree.steps.size());
    for (const StepElement& at : std::span(histogram.elements).subspan(bar.elements.first, bar.elements.count)) {
        ofSteps[at.step].push_back(at.element);
    }
    std::vector<BoardElement> elements;
    for (std::uint32_t copy = 0; copy < tree.copies.size(); ++copy) {
        for (const ElementId element : ofSteps[tree.copies[copy].step]) {
            elements.push_back({copy, element});
        }
    }
    std::ranges::sort(elements);
    return elements;
}

}  // namespace model
