#include "model/formats/ipc2581/stackup_reader.h"

#include <algorithm>

#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

namespace {

struct Row {
    std::size_t layer = 0;
    double sequence = 0.0;
    bool hasSequence = false;
};

struct RawStack {
    Stack stack;
    std::optional<double> thicknessNm;
    std::string_view measured;
    std::size_t copperCount = 0;
};

class StackupReader {
public:
    StackupReader(Reading& reading, const Specs& specs, LayerList& layers)
        : m_reading(reading), m_specs(specs), m_layers(layers) {}

    Stackups read() {
        for (const XmlSection& section : m_reading.outline().sections) {
            if (section.name == "Stackup") {
                readStack(section);
            }
        }
        Stackups result;
        if (m_raw.empty()) {
            m_reading.report(Severity::Info, 0, "the file has no stackup; thicknesses are assumed");
            return result;
        }
        const auto main = std::ranges::max_element(m_raw, {}, &RawStack::copperCount);
        result.order = main->stack.layers;
        result.boardNm = boardThickness(*main);
        for (const RawStack& raw : m_raw) {
            merge(raw.stack.layers, result.order);
            result.stacks.push_back(raw.stack);
        }
        nameOuterDielectrics(main->stack.layers);
        return result;
    }

private:
    void readStack(const XmlSection& section) {
        XmlCursor at = m_reading.at(section);
        at.next();
        RawStack raw;
        raw.stack.name = at.value("name");
        raw.measured = at.value("whereMeasured");
        const double overall = m_reading.lengthOr(at, "overallThickness", m_reading.unitNm(), 0.0);
        raw.thicknessNm = overall > 0.0 ? std::optional(overall) : std::nullopt;
        std::vector<Row> rows;
        forEachChild(at, [&] {
            if (at.name() == "StackupGroup") {
                forEachChild(at, [&] { readRow(at, rows); });
            } else {
                readRow(at, rows);
            }
        });
        if (std::ranges::all_of(rows, &Row::hasSequence)) {
            std::ranges::stable_sort(rows, {}, &Row::sequence);
        }
        for (const Row& row : rows) {
            if (std::ranges::find(raw.stack.layers, row.layer) == raw.stack.layers.end()) {
                raw.stack.layers.push_back(row.layer);
                raw.copperCount += m_layers[row.layer].isCopper() ? 1 : 0;
            }
        }
        turnUp(raw.stack.layers);
        m_raw.push_back(std::move(raw));
    }

    void readRow(XmlCursor& at, std::vector<Row>& rows) {
        if (at.name() != "StackupLayer") {
            if (at.name() != "CADDataLayerRef") {
                m_reading.reportUnknown(at);
            }
            return;
        }
        const std::string_view name = at.value("layerOrGroupRef");
        if (m_layers.find(name) < 0) {
            m_reading.report(Severity::Warning, at.line(),
                             "the stackup has a row for a layer that is not listed; it is taken for a dielectric");
        }
        const std::size_t layer = m_layers.findOrAdd(name, LayerType::Dielectric, at.line());
        const std::optional<double> sequence = realOf(at.value("sequence"));
        rows.push_back({layer, sequence.value_or(0.0), sequence.has_value()});
        LayerFacts& facts = m_layers[layer].drawn.facts;
        const double thickness = m_reading.lengthOr(at, "thickness", m_reading.unitNm(), 0.0);
        if (thickness > 0.0) {
            facts.thicknessNm = thickness;
        }
        const bool isCopper = m_layers[layer].isCopper();
        facts.material.type = m_layers[layer].drawn.type == LayerType::Dielectric ? dielectricType(layer) : "";
        forEachChild(at, [&] {
            const Spec* const spec = at.name() == "SpecRef" ? m_specs.find(at) : nullptr;
            if (spec != nullptr) {
                Specs::describe(*spec, isCopper, facts.material);
            } else if (at.name() != "SpecRef") {
                m_reading.reportUnknown(at);
            }
        });
    }

    [[nodiscard]] std::string dielectricType(std::size_t layer) const {
        const std::string_view function = m_layers[layer].function;
        return function == "DIELCORE" ? "CORE" : function == "DIELPREG" ? "PREPREG" : "";
    }

    /// Some write from the bottom.
    void turnUp(std::vector<std::size_t>& rows) const {
        const auto isCopper = [this](std::size_t row) { return m_layers[row].isCopper(); };
        const auto first = std::ranges::find_if(rows, isCopper);
        const auto last = std::find_if(rows.rbegin(), rows.rend(), isCopper);
        const bool isReversed = first != rows.end() && m_layers[*first].drawn.side == LayerSide::Bottom &&
                                m_layers[*last].drawn.side == LayerSide::Top;
        if (isReversed) {
            std::ranges::reverse(rows);
        }
    }

    /// Puts rows that `order` lacks before the row that follows them, or behind the last one.
    static void merge(const std::vector<std::size_t>& rows, std::vector<std::size_t>& order) {
        std::vector<std::size_t> missing;
        std::size_t last = rows.empty() ? 0 : rows.front();
        const auto isKnown = [&](std::size_t row) { return std::ranges::find(order, row) != order.end(); };
        for (const std::size_t row : rows) {
            if (!isKnown(row)) {
                missing.push_back(row);
                continue;
            }
            order.insert(std::ranges::find(order, row), missing.begin(), missing.end());
            missing.clear();
            last = row;
        }
        const auto behind = std::ranges::find(order, last);
        order.insert(behind == order.end() ? behind : behind + 1, missing.begin(), missing.end());
    }

    /// Without masks, pastes and print that the thickness counts in.
    [[nodiscard]] std::optional<double> boardThickness(const RawStack& raw) const {
        if (!raw.thicknessNm || raw.measured != "MASK") {
            return raw.thicknessNm;
        }
        double nm = *raw.thicknessNm;
        for (const std::size_t row : raw.stack.layers) {
            nm -= m_layers[row].isSurface() ? m_layers[row].drawn.facts.thicknessNm.value_or(0.0) : 0.0;
        }
        return nm > 0.0 ? std::optional(nm) : std::nullopt;
    }

    /// From the first to the last copper layer.
    [[nodiscard]] std::vector<std::size_t> core(const std::vector<std::size_t>& rows) const {
        const auto isCopper = [this](std::size_t row) { return m_layers[row].isCopper(); };
        const auto first = std::ranges::find_if(rows, isCopper);
        const auto last = std::find_if(rows.rbegin(), rows.rend(), isCopper).base();
        return first < last ? std::vector<std::size_t>(first, last) : std::vector<std::size_t>();
    }

    /// Dielectrics outside of the copper of a stackup are laid on it, unless they fill the board elsewhere or carry its
    /// only copper.
    void nameOuterDielectrics(const std::vector<std::size_t>& main) {
        const std::vector<std::size_t> board = core(main);
        for (const RawStack& raw : m_raw) {
            const std::vector<std::size_t> inside = core(raw.stack.layers);
            const bool isSingle = inside.size() == 1 && inside == board;
            for (const std::size_t row : raw.stack.layers) {
                const auto has = [row](const std::vector<std::size_t>& rows) {
                    return std::ranges::find(rows, row) != rows.end();
                };
                if (!has(inside) && !has(board) && !(isSingle && isSubstrate(m_layers[row].function))) {
                    layOn(m_layers[row]);
                }
            }
        }
    }

    static bool isSubstrate(std::string_view function) { return function == "DIELBASE" || function == "DIELCORE"; }

    static void layOn(SourceLayer& layer) {
        if (layer.drawn.type != LayerType::Dielectric) {
            return;
        }
        const std::string_view function = layer.function;
        const LayerUse use = function == "DIELCOVERLAY"                            ? LayerUse::Coverlay
                             : function == "DIELADHV" || function == "DIELBONDPLY" ? LayerUse::Adhesive
                             : isSubstrate(function)                               ? LayerUse::Stiffener
                                                                                   : LayerUse::Plain;
        if (use != LayerUse::Plain) {
            layer.drawn.type = LayerType::Mask;
            layer.drawn.use = use;
            layer.drawn.useName = textOf(function);
        }
    }

    Reading& m_reading;
    const Specs& m_specs;
    LayerList& m_layers;
    std::vector<RawStack> m_raw;
};

}  // namespace

Stackups readStackups(Reading& reading, const Specs& specs, LayerList& layers) {
    return StackupReader(reading, specs, layers).read();
}

}  // namespace model::ipc2581
