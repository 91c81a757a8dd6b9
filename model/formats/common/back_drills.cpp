#include "model/formats/common/back_drills.h"

#include <algorithm>
#include <map>
#include <string>

#include "model/geometry/box_index.h"
#include "model/geometry/vectors.h"

namespace model::formats {

namespace {

/// Symbols and tools are rounded apart by this much.
constexpr double kTolerance = 1'000;

bool isWidening(const Layer& layer) {
    return layer.use == LayerUse::Backdrill || layer.use == LayerUse::DualDiameter;
}

bool isHoles(const Layer& layer) {
    return (layer.type == LayerType::Drill || layer.type == LayerType::Rout) && layer.spanTop.isValid() &&
           layer.spanBottom.isValid();
}

class PlatingCutter {
public:
    explicit PlatingCutter(DocumentBuilder& builder) : m_builder(builder), m_document(builder.soFar()) {}

    void run() {
        std::vector<Box> boxes;
        for (std::uint32_t row = 0; row < m_document.elements.size(); ++row) {
            const ElementId element{row};
            if (isPlatedHole(m_document.elements.flags[row]) && isHoles(layerOf(element))) {
                m_plated.push_back(element);
                boxes.push_back(m_document.boxOf(element));
            }
        }
        const BoxIndex index(boxes);
        for (const Layer& layer : m_document.layers) {
            for (std::uint32_t i = 0; i < layer.elements.count && isWidening(layer) && isHoles(layer); ++i) {
                cutAround(ElementId{layer.elements.first + i}, index);
            }
        }
        for (const auto& [hole, span] : m_spans) {
            m_builder.addPlatedSpan(span);
        }
    }

private:
    [[nodiscard]] const Layer& layerOf(ElementId element) const {
        return m_document.layer(m_document.elements.layer[element.row()]);
    }

    /// nullptr if it is not round.
    [[nodiscard]] const CircleGeometry* roundOf(ElementId element) const {
        const bool isRound = m_document.elements.kind[element.row()] == ElementKind::Circle;
        return isRound ? &m_document.circles[m_document.elements.geometry[element.row()]] : nullptr;
    }

    void cutAround(ElementId drill, const BoxIndex& index) {
        if (isPlatedHole(m_document.elements.flags[drill.row()])) {
            return;  // the wider part of a plated hole is plated itself
        }
        index.visit(m_document.boxOf(drill), [&](std::uint32_t row) { cut(m_plated[row], drill); });
    }

    void cut(ElementId hole, ElementId drill) {
        const Layer& over = layerOf(drill);
        PlatedSpan span = spanOf(hole);
        if (!span.top.isValid() || span.bottom < over.spanTop || over.spanBottom < span.top) {
            return;
        }
        const CircleGeometry* inner = roundOf(hole);
        const CircleGeometry* outer = roundOf(drill);
        const bool areRound = inner != nullptr && outer != nullptr;
        const double away = areRound ? distance(base::toDouble(inner->centre), base::toDouble(outer->centre)) : 0.0;
        if (areRound && away >= inner->diameter / 2.0 + outer->diameter / 2.0) {
            return;  // beside it
        }
        if (!areRound || away + inner->diameter / 2.0 > outer->diameter / 2.0 + kTolerance) {
            return report(Severity::Warning, "does not cover the plated hole it meets, which stays as it is", drill);
        }
        if (span.top < over.spanTop && over.spanBottom < span.bottom) {
            return report(Severity::Warning, "begins and ends within a plated hole, which stays as it is", drill);
        }
        report(Severity::Info, "takes the plating of a hole from the copper of its span", drill);
        m_spans[hole] = left(span, over);
    }

    [[nodiscard]] PlatedSpan spanOf(ElementId hole) const {
        const auto found = m_spans.find(hole);
        return found != m_spans.end() ? found->second
                                      : PlatedSpan{hole, layerOf(hole).spanTop, layerOf(hole).spanBottom};
    }

    [[nodiscard]] PlatedSpan left(PlatedSpan span, const Layer& over) const {
        const bool takesTop = over.spanTop <= span.top;
        const bool takesBottom = over.spanBottom >= span.bottom;
        if (takesTop && takesBottom) {
            return {span.hole, {}, {}};
        }
        (takesTop ? span.top : span.bottom) = takesTop ? nextCopper(over.spanBottom, 1) : nextCopper(over.spanTop, -1);
        return span;
    }

    /// There is one: the span of the hole reaches farther.
    [[nodiscard]] LayerId nextCopper(LayerId from, int step) const {
        auto row = static_cast<std::ptrdiff_t>(from.row()) + step;
        while (!m_document.layers[static_cast<std::size_t>(row)].isCopper()) {
            row += step;
        }
        return LayerId{static_cast<std::size_t>(row)};
    }

    void report(Severity severity, const std::string& what, ElementId drill) {
        const bool isBackDrill = layerOf(drill).use == LayerUse::Backdrill;
        const std::string text =
            (isBackDrill ? "a back-drill " : "the wider part of a hole (countersink, counterbore) ") + what;
        m_builder.diagnostics().report(severity, layerOf(drill).file, m_document.elements.line[drill.row()], text,
                                       drill);
    }

    DocumentBuilder& m_builder;
    const Document& m_document;
    std::vector<ElementId> m_plated;
    std::map<ElementId, PlatedSpan> m_spans;
};

}  // namespace

void cutPlating(DocumentBuilder& builder) {
    if (std::ranges::any_of(builder.soFar().layers, isWidening)) {
        PlatingCutter(builder).run();
    }
}

}  // namespace model::formats
