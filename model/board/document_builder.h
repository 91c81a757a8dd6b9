#pragma once

#include <map>
#include <memory>
#include <string_view>
#include <unordered_map>

#include "model/board/document.h"

namespace model {

/// The one mutable stage of a document. Readers add layers first, then elements layer by layer (`beginLayer`), and
/// finish. Not thread-safe: parse in parallel, build in order, so that ids do not depend on the number of threads.
class DocumentBuilder {
public:
    /// What every element needs besides its geometry.
    struct Origin {
        NetId net;
        SymbolId symbol;
        AttributeSetId attributes;
        std::uint32_t feature = 0;
        std::uint32_t line = 0;
        std::uint8_t flags = 0;
        SubnetId subnet;
    };

    JobInfo& job() { return m_document->job; }
    Diagnostics& diagnostics() { return m_document->diagnostics; }
    ReadTimes& times() { return m_document->times; }

    LayerId addLayer(Layer layer);
    [[nodiscard]] Layer& layer(LayerId id) { return m_document->layers[id.row()]; }
    [[nodiscard]] std::vector<Layer>& layers() { return m_document->layers; }
    NetId addNet(std::string name, Range properties = {});
    SubnetId addSubnet(const Subnet& subnet);
    [[nodiscard]] Subnet& subnet(SubnetId id) { return m_document->subnets.edit()[id.row()]; }
    StringId string(std::string_view text);  ///< row of the text, added on first use
    Range addProperties(std::span<const Property> properties);
    SymbolId symbol(std::string_view name);  ///< row of the name, added on first use
    /// Row of this set of attributes, added on first use; none for an empty one.
    AttributeSetId attributes(const AttributeValues& values);
    /// Makes room for shapes with so many nodes in all, so that tables need not grow towards them.
    void expectNodes(std::size_t nodes) { m_document->shapes.nodes.edit().reserve(nodes); }
    /// Slits are healed into holes (model/geometry/slits.h), and holes are put behind the island that contains them, in
    /// whatever order they were sketched.
    ShapeId addShape(ShapeSketch sketch);
    [[nodiscard]] const ShapeTable& shapes() const { return m_document->shapes; }
    void addTool(DrillTool tool) { m_document->tools.push_back(std::move(tool)); }
    /// `package.pins` is filled in.
    PackageId addPackage(Package package, std::span<const PackagePin> pins);
    /// `component.firstPin`, `pinCount` and the pins' `component` are filled in.
    ComponentId addComponent(Component component, std::span<const Pin> pins);
    /// `group.elements` is filled in.
    void addGroup(ElementGroup group, std::span<const ElementId> elements);
    void addNetPoint(const NetPoint& point) { m_document->netPoints.push_back(point); }
    void setProfile(ShapeId shape, Source source = Source::Job) {
        m_document->profile = shape;
        m_document->profileSource = source;
    }
    void addZone(Zone zone) { m_document->zones.push_back(std::move(zone)); }
    /// A step to place copies of; it must have the same layer rows. Returns its row.
    std::uint32_t addStep(std::shared_ptr<const Document> step);
    void addInstance(const StepInstance& instance);
    void addBody(const Body& body) { m_document->bodies.push_back(body); }
    void addPlatedSpan(const PlatedSpan& span) { m_document->platedSpans.push_back(span); }
    void setStackup(Stackup stackup) { m_document->stackup = std::move(stackup); }
    void setBoardThickness(Nm thickness) { m_document->boardThickness = thickness; }

    /// All elements added from now on belong to this layer; a layer can be begun once.
    void beginLayer(LayerId layer);
    ElementId addLine(const LineGeometry& line, const Origin& origin);
    ElementId addArc(const ArcGeometry& arc, const Origin& origin);
    ElementId addCircle(const CircleGeometry& circle, const Origin& origin);
    ElementId addTrail(std::span<const PathNode> nodes, Nm width, const Origin& origin, Nm innerWidth = 0);
    /// One width per edge: `widths` has one entry less than `nodes`.
    ElementId addTrail(std::span<const PathNode> nodes, std::span<const Nm> widths, const Origin& origin);
    ElementId addArea(const AreaGeometry& area, const Origin& origin);
    /// An area that several features made together. `features` rise.
    ElementId addPaintedArea(const AreaGeometry& area, const Origin& origin, std::span<const std::uint32_t> features);

    /// What has been added so far, for steps that derive more from it (body, negative layers).
    [[nodiscard]] const Document& soFar() const { return *m_document; }

    /// Fills the derived columns (counts, net lists, extents) and freezes. The builder is empty afterwards.
    [[nodiscard]] std::shared_ptr<const Document> finish();

private:
    ElementId addElement(ElementKind kind, std::size_t geometry, const Origin& origin);
    void giveBackReserves();
    void countCopies();
    void measureExtents();

    std::shared_ptr<Document> m_document = std::make_shared<Document>();
    std::unordered_map<std::string, SymbolId> m_symbols;
    std::unordered_map<std::string, StringId> m_strings{{"", StringId{0}}};
    std::map<AttributeValues, AttributeSetId> m_attributeSets;
    LayerId m_layer;
};

/// Fills Document::netStart and netElements from the nets of the elements.
void indexNets(Document& document);

}  // namespace model
