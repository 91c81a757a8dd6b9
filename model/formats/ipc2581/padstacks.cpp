#include "model/formats/ipc2581/padstacks.h"

#include <algorithm>
#include <set>

#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnFeature;
using formats::DrawnKind;

/// Writers round the places of pads and of holes differently; places this near, or up to twice as far, are one.
constexpr Nm kReach = 5'000;

using Cell = std::pair<Nm, Nm>;

Cell cellOf(Point p) {
    const auto cell = [](Nm nm) { return nm / kReach - (nm % kReach < 0 ? 1 : 0); };
    return {cell(p.x), cell(p.y)};
}

Point middleOf(const DrawnFeature& feature, const formats::DrawnStep& step) {
    if (feature.kind == DrawnKind::Region) {
        return boxOf(step.regions[static_cast<std::size_t>(feature.region)]).middle();
    }
    Box box;
    box.include(feature.a);
    box.include(feature.kind == DrawnKind::Line ? feature.b : feature.a);
    return box.middle();
}

/// Where layers of holes draw holes and slots.
std::set<Cell> holesOf(const formats::DrawnStep& step, const LayerList& layers) {
    std::set<Cell> cells;
    for (std::size_t layer = 0; layer < step.features.size(); ++layer) {
        if (layers[layer].isHoles()) {
            for (const DrawnFeature& feature : step.features[layer]) {
                cells.insert(cellOf(middleOf(feature, step)));
            }
        }
    }
    return cells;
}

bool hasNear(const std::set<Cell>& cells, Cell cell) {
    for (Nm x = cell.first - 1; x <= cell.first + 1; ++x) {
        for (Nm y = cell.second - 1; y <= cell.second + 1; ++y) {
            if (cells.contains({x, y})) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

void Padstacks::add(XmlCursor& at) {
    Padstack& padstack = m_padstacks[at.value("name")];
    forEachChild(at, [&] {
        if (at.name() == "PadstackPadDef" || at.name() == "PadStackPadDef") {
            addPad(at, padstack);
        } else if (at.name() == "PadstackHoleDef" || at.name() == "PadStackHoleDef") {
            const double unitNm = m_reading.unitNm();
            padstack.widestHole = std::max(padstack.widestHole, m_reading.lengthOr(at, "diameter", unitNm, 0.0));
            padstack.holes.push_back(
                {m_reading.lengthOr(at, "x", unitNm, 0.0), m_reading.lengthOr(at, "y", unitNm, 0.0)});
        } else {
            m_reading.reportUnknown(at);
        }
    });
}

void Padstacks::addPad(XmlCursor& at, Padstack& padstack) {
    const std::string_view use = at.value("padUse");
    const std::string_view layer = at.value("layerRef");
    Turn turn;
    std::vector<XmlCursor> shapes;
    forEachChild(at, [&] {
        if (!readTurn(m_reading, at, m_reading.unitNm(), turn)) {
            shapes.push_back(at);
        }
    });
    for (XmlCursor& shape : shapes) {  // a Location may follow them
        if (use.empty() || use == "REGULAR") {
            padstack.pads.push_back({layer, turn, std::move(shape)});
        } else if (use == "THERMAL") {
            padstack.thermals.emplace_back(layer, shape.value("id"));
        } else if (use == "ANTIPAD") {
            padstack.antipads.emplace_back(layer, shape.value("id"));
        }
    }
}

bool Padstack::isThermal(std::string_view layer, std::string_view shape) const {
    const auto has = [&](const std::vector<NamedShape>& shapes) {
        return std::ranges::find(shapes, NamedShape(layer, shape)) != shapes.end();
    };
    return !shape.empty() && has(thermals) && !has(antipads);
}

const Padstack* Padstacks::find(std::string_view name) const {
    const auto found = m_padstacks.find(name);
    return found == m_padstacks.end() ? nullptr : &found->second;
}

void Padstacks::use(const Padstack& padstack, const Turn& turn, std::uint32_t line) {
    for (const PointD hole : padstack.holes) {
        const Point turned = m_reading.rounded(turn.apply(hole), line);
        const Point opposite = m_reading.rounded({turn.origin.x - hole.x, turn.origin.y - hole.y}, line);
        m_holes.try_emplace({turned.x, turned.y}, HoleUse{turned, opposite, line});
    }
}

void Padstacks::reportMissingHoles(const formats::DrawnStep& step, const LayerList& layers) const {
    const std::set<Cell> drawn = holesOf(step, layers);
    std::vector<std::uint32_t> missing;
    for (const auto& [place, hole] : m_holes) {
        if (!hasNear(drawn, cellOf(hole.turned)) && !hasNear(drawn, cellOf(hole.opposite))) {
            missing.push_back(hole.line);
        }
    }
    std::ranges::sort(missing);  // messages name the first one
    for (const std::uint32_t line : missing) {
        m_reading.report(Severity::Warning, line,
                         "a padstack has a hole where no layer of holes draws one; it is missing");
    }
}

}  // namespace model::ipc2581
