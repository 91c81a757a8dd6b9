#include "model/board/document_builder.h"

#include <algorithm>
#include <numeric>

#include "model/base/assert.h"
#include "model/geometry/nesting.h"
#include "model/geometry/slits.h"

namespace model {

LayerId DocumentBuilder::addLayer(Layer layer) {
    m_document->layers.push_back(std::move(layer));
    return LayerId{m_document->layers.size() - 1};
}

NetId DocumentBuilder::addNet(std::string name, Range properties) {
    m_document->nets.push_back({std::move(name), properties});
    return NetId{m_document->nets.size() - 1};
}

SubnetId DocumentBuilder::addSubnet(const Subnet& subnet) {
    m_document->subnets.push_back(subnet);
    return SubnetId{m_document->subnets.size() - 1};
}

StringId DocumentBuilder::string(std::string_view text) {
    const auto [location, isNew] = m_strings.try_emplace(std::string(text), StringId{m_document->strings.size()});
    if (isNew) {
        m_document->strings.push_back(std::string(text));
    }
    return location->second;
}

namespace {

/// Appends rows to a table and says where they are.
template <class T>
Range append(base::Table<T>& table, std::span<const T> rows) {
    const Range range{static_cast<std::uint32_t>(table.size()), static_cast<std::uint32_t>(rows.size())};
    table.edit().insert(table.end(), rows.begin(), rows.end());
    return range;
}

}  // namespace

Range DocumentBuilder::addProperties(std::span<const Property> properties) {
    return append(m_document->properties, properties);
}

SymbolId DocumentBuilder::symbol(std::string_view name) {
    const auto [location, isNew] = m_symbols.try_emplace(std::string(name), SymbolId{m_document->symbols.size()});
    if (isNew) {
        m_document->symbols.push_back(std::string(name));
    }
    return location->second;
}

AttributeSetId DocumentBuilder::attributes(const AttributeValues& values) {
    if (values.empty()) {
        return {};
    }
    const auto [location, isNew] = m_attributeSets.try_emplace(values, m_document->attributeSets.size());
    if (isNew) {
        m_document->attributeSets.push_back(values);
    }
    return location->second;
}

ShapeId DocumentBuilder::addShape(ShapeSketch sketch) {
    if (std::optional<ShapeSketch> healed = healSlits(sketch)) {
        sketch = std::move(*healed);
    }
    return m_document->shapes.add(nestHoles(std::move(sketch)));
}

ComponentId DocumentBuilder::addComponent(Component component, std::span<const Pin> pins) {
    const ComponentId id{m_document->components.size()};
    const Range range = append(m_document->pins, pins);
    component.firstPin = range.first;
    component.pinCount = range.count;
    for (std::uint32_t i = 0; i < range.count; ++i) {
        m_document->pins.edit()[range.first + i].component = id;
    }
    m_document->components.push_back(std::move(component));
    return id;
}

PackageId DocumentBuilder::addPackage(Package package, std::span<const PackagePin> pins) {
    package.pins = append(m_document->packagePins, pins);
    m_document->packages.push_back(std::move(package));
    return PackageId{m_document->packages.size() - 1};
}

void DocumentBuilder::addGroup(ElementGroup group, std::span<const ElementId> elements) {
    group.elements = append(m_document->groupElements, elements);
    m_document->groups.push_back(group);
}

std::uint32_t DocumentBuilder::addStep(std::shared_ptr<const Document> step) {
    m_document->steps.push_back(std::move(step));
    return static_cast<std::uint32_t>(m_document->steps.size() - 1);
}

void DocumentBuilder::addInstance(const StepInstance& instance) {
    ASSERT(instance.step < m_document->steps.size());
    m_document->instances.push_back(instance);
}

void DocumentBuilder::beginLayer(LayerId id) {
    ASSERT(layer(id).elements.count == 0);
    m_layer = id;
    layer(id).elements.first = static_cast<std::uint32_t>(m_document->elements.size());
}

ElementId DocumentBuilder::addElement(ElementKind kind, std::size_t geometry, const Origin& origin) {
    ASSERT(m_layer.isValid());
    ElementTable& table = m_document->elements;
    table.kind.push_back(kind);
    table.flags.push_back(origin.flags);
    table.layer.push_back(m_layer);
    table.net.push_back(origin.net);
    table.subnet.push_back(origin.subnet);
    table.symbol.push_back(origin.symbol);
    table.geometry.push_back(static_cast<std::uint32_t>(geometry));
    table.firstFeature.push_back(origin.feature);
    table.line.push_back(origin.line);
    table.attributes.push_back(origin.attributes);
    Layer& owner = layer(m_layer);
    ++owner.elements.count;
    ++owner.counts[static_cast<std::size_t>(kind)];
    return ElementId{table.size() - 1};
}

ElementId DocumentBuilder::addLine(const LineGeometry& line, const Origin& origin) {
    m_document->lines.push_back(line);
    return addElement(ElementKind::Line, m_document->lines.size() - 1, origin);
}

ElementId DocumentBuilder::addArc(const ArcGeometry& arc, const Origin& origin) {
    m_document->arcs.push_back(arc);
    return addElement(ElementKind::Arc, m_document->arcs.size() - 1, origin);
}

ElementId DocumentBuilder::addCircle(const CircleGeometry& circle, const Origin& origin) {
    m_document->circles.push_back(circle);
    return addElement(ElementKind::Circle, m_document->circles.size() - 1, origin);
}

ElementId DocumentBuilder::addTrail(std::span<const PathNode> nodes, Nm width, const Origin& origin, Nm innerWidth) {
    const ElementId trail = addTrail(nodes, std::vector<Nm>(nodes.size() - 1, width), origin);
    m_document->trails.edit().back().innerWidth = innerWidth;
    return trail;
}

ElementId DocumentBuilder::addTrail(std::span<const PathNode> nodes, std::span<const Nm> widths, const Origin& origin) {
    ASSERT(nodes.size() >= 2 && widths.size() + 1 == nodes.size());
    base::Table<PathNode>& all = m_document->trailNodes;
    m_document->trails.push_back({static_cast<std::uint32_t>(all.size()), static_cast<std::uint32_t>(nodes.size()),
                                  *std::ranges::max_element(widths)});
    append(all, nodes);
    append(m_document->trailWidths, widths);
    m_document->trailWidths.push_back(0);
    return addElement(ElementKind::Trail, m_document->trails.size() - 1, origin);
}

ElementId DocumentBuilder::addArea(const AreaGeometry& area, const Origin& origin) {
    ASSERT(area.shape.row() < m_document->shapes.size());
    m_document->areas.push_back(area);
    return addElement(ElementKind::Area, m_document->areas.size() - 1, origin);
}

ElementId DocumentBuilder::addPaintedArea(const AreaGeometry& area, const Origin& origin,
                                          std::span<const std::uint32_t> features) {
    const ElementId element = addArea(area, origin);
    PaintedSources& painted = m_document->painted;
    const Range range = append(painted.features, features);
    painted.areas.push_back({element, range.first, range.count});
    return element;
}

std::shared_ptr<const Document> DocumentBuilder::finish() {
    indexNets(*m_document);
    countCopies();
    measureExtents();
    giveBackReserves();
    std::shared_ptr<const Document> frozen = std::move(m_document);
    m_document = std::make_shared<Document>();
    m_symbols.clear();
    m_strings = {{"", StringId{0}}};
    m_attributeSets.clear();
    m_layer = {};
    return frozen;
}

/// Tables double while they grow; a frozen one keeps what it holds, and a quarter at most.
void DocumentBuilder::giveBackReserves() {
    const auto shrinkOne = [](auto& rows) {
        if (rows.capacity() - rows.size() > rows.size() / 4) {
            rows.shrink_to_fit();
        }
    };
    const auto shrink = [&](auto&... tables) { (shrinkOne(tables.edit()), ...); };
    Document& d = *m_document;
    ElementTable& e = d.elements;
    shrink(e.kind, e.flags, e.layer, e.net, e.subnet, e.symbol, e.geometry, e.firstFeature, e.line, e.attributes);
    shrink(d.lines, d.arcs, d.circles, d.trails, d.trailNodes, d.trailWidths, d.areas);
    shrink(d.shapes.shapes, d.shapes.contours, d.shapes.nodes, d.painted.areas, d.painted.features);
    shrink(d.bodies, d.platedSpans);
}

void DocumentBuilder::countCopies() {
    Document& d = *m_document;
    for (Layer& l : d.layers) {
        std::ranges::copy(l.counts, l.countsWithCopies.begin());
    }
    for (const StepInstance& instance : d.instances) {
        const std::vector<Layer>& copied = d.steps[instance.step]->layers;
        for (std::size_t row = 0; row < std::min(copied.size(), d.layers.size()); ++row) {
            Layer& onto = layer(d.layerOfCopy(LayerId{row}, instance.isFlipped));
            for (std::size_t kind = 0; kind < kElementKindCount; ++kind) {
                onto.countsWithCopies[kind] += copied[row].countsWithCopies[kind];
            }
        }
    }
}

void DocumentBuilder::measureExtents() {
    Document& d = *m_document;
    for (const Layer& l : d.layers) {
        // Components may reach far over the board.
        if (l.context != LayerContext::Board || l.type == LayerType::Document || l.type == LayerType::ComponentBody) {
            continue;
        }
        for (std::uint32_t i = 0; i < l.elements.count; ++i) {
            d.extent.include(d.boxOf(ElementId{l.elements.first + i}));
        }
    }
    for (const StepInstance& instance : d.instances) {
        d.extent.include(instance.placement.boxOf(d.steps[instance.step]->extent));
    }
    d.board = d.profile.isValid() ? d.shapes.shapes[d.profile.row()].box : d.extent;
}

void indexNets(Document& d) {
    std::vector<std::uint32_t>& start = d.netStart.edit();
    start.assign(d.nets.size() + 1, 0);
    for (const NetId net : d.elements.net) {
        if (net.isValid()) {
            ++start[net.row() + 1];
        }
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<ElementId>& elements = d.netElements.edit();
    elements.resize(start.back());
    std::vector<std::uint32_t> next = start;
    for (std::size_t row = 0; row < d.elements.size(); ++row) {
        if (const NetId net = d.elements.net[row]; net.isValid()) {
            elements[next[net.row()]++] = ElementId{row};
        }
    }
}

}  // namespace model
