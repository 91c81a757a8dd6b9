#include "model/formats/gerber/pad_nets.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "model/formats/gerber/netlist_join.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/edges.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;
using formats::kNoRow;

namespace {

constexpr Nm kHoleReach = 2'000;
constexpr Nm kPointReach = 15'000;
constexpr Nm kWidestPad = 10'000'000;  ///< from where it is flashed to any of its points
/// Tools without a size are drawn no wider than this (drill_parser.cpp).
constexpr Nm kSizeless = 10;
/// Leads of components need wider holes than these 20 mil and some rounding; vias rarely do.
constexpr Nm kMostViaDrill = 510'000;

Point middleOf(const DrawnFeature& hole) {
    return hole.kind == DrawnKind::Line ? Point{hole.a.x / 2 + hole.b.x / 2, hole.a.y / 2 + hole.b.y / 2} : hole.a;
}

bool isNear(Point a, Point b) {
    return std::abs(std::int64_t{a.x} - b.x) <= kPointReach && std::abs(std::int64_t{a.y} - b.y) <= kPointReach;
}

}  // namespace

std::int32_t NetNames::row(const std::string& name) {
    const auto [found, isNew] = m_rows.try_emplace(name, static_cast<std::int32_t>(m_step.nets.size()));
    if (isNew) {
        m_step.nets.push_back({name, {}});
    }
    return found->second;
}

PadNets::PadNets(formats::DrawnStep& step, OrderedLayers& layers, PartList& parts, NetNames& nets,
                 Diagnostics& diagnostics)
    : m_step(step), m_layers(layers), m_parts(parts), m_nets(nets), m_diagnostics(diagnostics) {}

void PadNets::run(const std::vector<ReadFile>& files, const BoardFiles& board, bool hasNets) {
    indexPads();
    for (const std::size_t row : board.files) {
        if (files[row].kind == ReadFile::Kind::Netlist) {
            add(files[row], hasNets);
        }
    }
    reportSizeless();
    nameHoles();
    if (!isUseOfHolesTold()) {
        assumeVias();
    }
}

/// Flashes on the copper layers of the step.
void PadNets::indexPads() {
    std::vector<IndexedPad> pads;
    for (const std::int32_t layer : m_layers.copper) {
        const std::vector<DrawnFeature>& features = m_step.features[static_cast<std::size_t>(layer)];
        for (std::size_t i = 0; i < features.size(); ++i) {
            if (features[i].kind == DrawnKind::Pad && !features[i].isNegative) {
                pads.push_back({features[i].a, layer, static_cast<std::int32_t>(i)});
            }
        }
    }
    m_pads = PadIndex(std::move(pads));
}

void PadNets::add(const ReadFile& file, bool hasNets) {
    const std::optional<Point> shift = shiftOf(file.netlist, m_pads);
    if (!shift) {
        m_diagnostics.report(Severity::Warning, file.path, 0,
                             "the points of the netlist lie on no pads, wherever its origin is taken to be; it is "
                             "not used");
        return;
    }
    if (*shift != Point{}) {
        m_diagnostics.report(Severity::Info, file.path, 0,
                             "the netlist counts from another origin, found by matching its points with pads");
    }
    const std::vector<std::string> names = fullNames(file.netlist.nets, m_step.nets);
    if (!hasNets) {
        m_diagnostics.report(Severity::Info, file.path, 0,
                             "the images name no nets; those of the netlist are given to the pads at its points, and "
                             "from there to the copper that touches them");
        for (const D356Point& point : file.netlist.points) {
            giveNet(point, names, *shift);
        }
    }
    giveSizes(file, *shift);
    m_step.netlists.push_back(drawnNetlist(file.netlist, names, *shift, file.path));
}

void PadNets::giveNet(const D356Point& point, const std::vector<std::string>& names, Point shift) {
    const Point at{point.position.x + shift.x, point.position.y + shift.y};
    const std::int32_t net = point.net < 0 ? kNoRow : m_nets.row(names[static_cast<std::size_t>(point.net)]);
    const bool isPin = !point.isVia && !point.refdes.empty() && point.isPlated;
    const std::int32_t component = isPin ? m_parts.component(point.refdes) : kNoRow;
    const LayerSide side = point.access == 0   ? LayerSide::Through
                           : point.access == 1 ? LayerSide::Top
                                               : LayerSide::Bottom;
    for (const IndexedPad& pad : padsAt(at, side)) {
        DrawnFeature& feature = featureOf(pad);
        if (feature.net < 0) {
            feature.net = net;
        }
        if (isPin && feature.component < 0) {
            const LayerSide seen = side == LayerSide::Through ? LayerSide::None : sideOf(pad);
            feature.component = component;
            feature.pin = m_parts.pin(component, point.pin, feature.a, net);
            m_parts.isSeenOn(component, seen, true, point.hole > 0);
        } else if (point.isVia) {
            feature.subnet = SubnetKind::Via;
        }
    }
}

/// Those that lie there or, where there is none, the pad around the point if it is only one on its layer: pads of odd
/// shapes are not always flashed by their middle.
std::vector<IndexedPad> PadNets::padsAt(Point at, LayerSide side) {
    std::vector<IndexedPad> pads;
    const auto take = [&](Nm reach, auto isMeant) {
        m_pads.visit(at, reach, [&](const IndexedPad& pad) {
            if ((side == LayerSide::Through || side == sideOf(pad)) && isMeant(pad)) {
                pads.push_back(pad);
            }
        });
    };
    take(kPointReach, [](const IndexedPad&) { return true; });
    if (!pads.empty()) {
        return pads;
    }
    take(kWidestPad, [&](const IndexedPad& pad) { return isWithin(at, featureOf(pad)); });
    const std::vector<IndexedPad> all = pads;
    std::erase_if(pads,
                  [&](const IndexedPad& pad) { return std::ranges::count(all, pad.layer, &IndexedPad::layer) > 1; });
    return pads;
}

bool PadNets::isWithin(Point at, const DrawnFeature& pad) {
    if (pad.symbol < 0) {
        return false;
    }
    const auto [found, isNew] = m_symbolBoxes.try_emplace(pad.symbol);
    if (isNew) {
        found->second = boxOf(outlineOf(m_step.symbols[static_cast<std::size_t>(pad.symbol)].shape));
    }
    return found->second.holds(
        rounded(unplaced(base::toDouble(at), Placement{pad.a, pad.clockwiseDeg, pad.isMirrored})));
}

DrawnFeature& PadNets::featureOf(const IndexedPad& pad) {
    return m_step.features[static_cast<std::size_t>(pad.layer)][static_cast<std::size_t>(pad.feature)];
}

LayerSide PadNets::sideOf(const IndexedPad& pad) const {
    return m_layers.layers[static_cast<std::size_t>(pad.layer)].side;
}

bool PadNets::holdsHoles(std::size_t layer) const {
    const LayerType type = m_layers.layers[layer].type;
    return type == LayerType::Drill || type == LayerType::Rout;
}

/// Holes of the netlist that lie in the middle of what a tool without a size makes tell its size.
void PadNets::giveSizes(const ReadFile& file, Point shift) {
    std::vector<const D356Point*> holes;
    for (const D356Point& point : file.netlist.points) {
        if (point.hole > 0) {
            holes.push_back(&point);
        }
    }
    for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
        if (!holdsHoles(layer)) {
            continue;
        }
        for (const std::int32_t symbol : sizelessTools(layer)) {
            if (giveSize(layer, symbol, holes, shift)) {
                m_diagnostics.report(Severity::Info, m_layers.layers[layer].file, 0,
                                     "the size of a tool is that of the netlist's holes where it drills");
            }
        }
    }
}

std::set<std::int32_t> PadNets::sizelessTools(std::size_t layer) const {
    std::set<std::int32_t> tools;
    for (const DrawnFeature& hole : m_step.features[layer]) {
        const bool isSizeless =
            hole.symbol >= 0 && m_step.symbols[static_cast<std::size_t>(hole.symbol)].shape.width <= kSizeless;
        if (isSizeless) {
            tools.insert(hole.symbol);
        }
    }
    return tools;
}

/// Tools without a size that no netlist has given one, where they drill first.
void PadNets::reportSizeless() {
    for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
        if (!holdsHoles(layer)) {
            continue;
        }
        for (const std::int32_t tool : sizelessTools(layer)) {
            const auto hole = std::ranges::find(m_step.features[layer], tool, &DrawnFeature::symbol);
            m_diagnostics.report(Severity::Warning, m_layers.layers[layer].file, hole->line,
                                 "a tool has no size, and no netlist tells it; its holes are drawn as points");
        }
    }
}

bool PadNets::giveSize(std::size_t layer, std::int32_t symbol, const std::vector<const D356Point*>& holes,
                       Point shift) {
    Nm size = 0;
    bool isPlated = false;
    for (const DrawnFeature& made : m_step.features[layer]) {
        if (made.symbol != symbol) {
            continue;
        }
        const auto found = std::ranges::find_if(holes, [&](const D356Point* hole) {
            return isNear({hole->position.x + shift.x, hole->position.y + shift.y}, middleOf(made));
        });
        if (found == holes.end() || (size > 0 && (*found)->hole != size)) {
            return false;
        }
        size = (*found)->hole;
        isPlated = isPlated || (*found)->isPlated;
    }
    formats::DrawnSymbol& tool = m_step.symbols[static_cast<std::size_t>(symbol)];
    tool.shape.width = size;
    const int number = parseInteger(std::string_view(tool.name).substr(1, tool.name.find(' ') - 1)).value_or(-1);
    tool.name = "T" + std::to_string(number) + " " + shortNumber(base::toMm(size)) + " mm";
    for (DrillTool& row : m_layers.layers[layer].tools) {
        if (row.number == number) {
            row.finishedSize = row.drillSize = size;
        }
    }
    for (DrawnFeature& made : m_step.features[layer]) {
        if (made.symbol == symbol && made.plating == Plating::NotSaid) {
            made.plating = isPlated ? Plating::Plated : Plating::NonPlated;
        }
    }
    return true;
}

/// Plated holes have the net of the pads around them, and what these are.
void PadNets::nameHoles() {
    for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
        if (!holdsHoles(layer)) {
            continue;
        }
        for (DrawnFeature& hole : m_step.features[layer]) {
            if (hole.plating == Plating::NonPlated) {
                continue;
            }
            bool isVia = false;
            m_pads.visit(middleOf(hole), kHoleReach, [&](const IndexedPad& pad) {
                const DrawnFeature& flash = featureOf(pad);
                hole.net = hole.net < 0 ? flash.net : hole.net;
                isVia = isVia || flash.subnet == SubnetKind::Via;
            });
            if (isVia) {
                hole.plating = Plating::Via;
            }
        }
    }
}

/// By pins, which other holes then lack, by points of a netlist, or by attributes of the drills.
bool PadNets::isUseOfHolesTold() const {
    const auto isTold = [this](const DrawnFeature& hole) {
        return hole.plating == Plating::Via ||
               (hole.attributes >= 0 && std::ranges::count(m_step.attributes[static_cast<std::size_t>(hole.attributes)],
                                                           ".AperFunction", &formats::Words::value_type::first) > 0);
    };
    bool isAnyTold = std::ranges::any_of(m_step.components, [](const auto& part) { return !part.pins.empty(); });
    for (std::size_t layer = 0; layer < m_layers.layers.size() && !isAnyTold; ++layer) {
        isAnyTold = holdsHoles(layer) && std::ranges::any_of(m_step.features[layer], isTold);
    }
    return isAnyTold;
}

/// All holes of tools that mostly drill pads: some lie in pours only. Whether wider ones take pins or screws stays
/// open.
void PadNets::assumeVias() {
    for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
        if (!holdsHoles(layer)) {
            continue;
        }
        const std::set<std::int32_t> tools = viaTools(layer);
        for (DrawnFeature& hole : m_step.features[layer]) {
            if (tools.contains(hole.symbol) && mayBeVia(hole)) {
                hole.subnet = SubnetKind::Via;
                m_diagnostics.report(Severity::Info, m_layers.layers[layer].file, hole.line,
                                     "nothing in the job tells vias from other plated holes; tools of up to 0.51 mm "
                                     "that mostly drill pads of several copper layers are taken to make vias");
            }
        }
    }
}

std::set<std::int32_t> PadNets::viaTools(std::size_t layer) const {
    std::map<std::int32_t, std::int64_t> balances;  // holes that join pads less all others
    for (const DrawnFeature& hole : m_step.features[layer]) {
        if (mayBeVia(hole)) {
            balances[hole.symbol] += joinsPads(hole) ? 1 : -1;
        }
    }
    std::set<std::int32_t> tools;
    for (const auto& [tool, balance] : balances) {
        if (balance > 0) {
            tools.insert(tool);
        }
    }
    return tools;
}

/// Round, not said to be non-plated, of a size that is known and fits a via.
bool PadNets::mayBeVia(const DrawnFeature& hole) const {
    if (hole.kind != DrawnKind::Pad || hole.symbol < 0 || hole.plating == Plating::NonPlated) {
        return false;
    }
    const formats::PadShape& shape = m_step.symbols[static_cast<std::size_t>(hole.symbol)].shape;
    return shape.kind == formats::PadShape::Kind::Round && shape.width > kSizeless && shape.width <= kMostViaDrill;
}

bool PadNets::joinsPads(const DrawnFeature& hole) const {
    std::set<std::int32_t> layers;
    m_pads.visit(middleOf(hole), kHoleReach, [&](const IndexedPad& pad) { layers.insert(pad.layer); });
    return layers.size() > 1;
}

}  // namespace model::gerber
