#include "model/solids/solids.h"

#include <algorithm>
#include <map>

#include "model/base/parallel.h"
#include "model/board/flip.h"
#include "model/board/holes.h"
#include "model/geometry/boolean.h"
#include "model/geometry/curve_edges.h"
#include "model/geometry/region.h"
#include "model/solids/bodies.h"
#include "model/solids/cutouts.h"
#include "model/solids/substrates.h"

namespace model {

namespace {

/// Areas that differ by less of them are the same but for the chords of their arcs.
constexpr double kSameArea = 1e-6;

/// A plate with holes that becomes a layer.
struct Plate {
    Layer layer;
    ShapeId outline;
    std::vector<LayerId> wholeLayers;  ///< all of their elements are cut out
    std::vector<LayerId> openHoles;    ///< hole layers, of which those are cut out that solder mask does not close
    ShapeSketch sketch;                ///< the result
};

Layer plateLayer(std::string name, LayerType type, LayerSide side, Nm bottom, Nm top, Source source) {
    Layer layer;
    layer.name = std::move(name);
    layer.type = type;
    layer.side = side;
    layer.isSynthetic = true;
    layer.z = bottom;
    layer.thickness = top - bottom;
    layer.thicknessSource = source;
    return layer;
}

bool hasArcs(const ShapeTable& shapes, ShapeId shape) {
    return std::ranges::any_of(shapes.contoursOf(shape), [&](const Contour& contour) {
        return std::ranges::any_of(shapes.nodesOf(contour), [](const PathNode& node) { return isArc(node.edge); });
    });
}

/// What all of the shapes cover together; where one of them lies in the others, that one, with its arcs. None where
/// they cover nothing together.
ShapeId intersectionOf(DocumentBuilder& builder, const std::vector<ShapeId>& shapes) {
    if (shapes.size() < 2) {
        return shapes.empty() ? ShapeId{} : shapes.front();
    }
    std::vector<PolygonSet> outlines;
    for (const ShapeId shape : shapes) {
        outlines.push_back(discretise(builder.shapes(), shape, kBooleanChords));
    }
    PolygonSet all = outlines.front();
    for (std::size_t i = 1; i < outlines.size(); ++i) {
        all = intersect(all, outlines[i]);
    }
    const auto area = static_cast<double>(twiceArea(all));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto own = static_cast<double>(twiceArea(outlines[i]));
        if (own - area <= kSameArea * own) {
            return shapes[i];
        }
    }
    const ShapeSketch sketch = sketchOf(all);
    if (sketch.isEmpty()) {
        return {};
    }
    if (std::ranges::any_of(shapes, [&](ShapeId shape) { return hasArcs(builder.shapes(), shape); })) {
        builder.diagnostics().report(Severity::Warning, "", 0,
                                     "outlines of zones cross each other; where the substrate is within both of them "
                                     "its outline has straight edges within 1 µm in place of arcs");
    }
    return builder.addShape(sketch);
}

void planBody(DocumentBuilder& builder, std::vector<Plate>& plates) {
    std::vector<SubstratePart> parts = substratesOf(builder.soFar());
    std::map<std::vector<ShapeId>, ShapeId> outlines;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto [outline, isNew] = outlines.try_emplace(parts[i].outlines);
        if (isNew) {
            outline->second = intersectionOf(builder, parts[i].outlines);
        }
        std::string name = parts.size() == 1 ? "board" : "board " + std::to_string(i + 1);
        plates.push_back({plateLayer(std::move(name), LayerType::Body, LayerSide::Through, parts[i].bottom,
                                     parts[i].top, Source::Derived),
                          outline->second,
                          std::move(parts[i].holes),
                          {},
                          {}});
    }
}

/// Hole layers that come out on the side of the board a mask lies on.
std::vector<LayerId> holesUnder(const Document& document, const Layer& mask) {
    std::vector<LayerId> holes;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& layer = document.layers[row];
        const bool isHoles = model::isHoles(layer.type);
        const bool comesOut =
            mask.side == LayerSide::Top ? layer.z + layer.thickness >= mask.z : layer.z <= mask.z + mask.thickness;
        if (isHoles && comesOut) {
            holes.emplace_back(row);
        }
    }
    return holes;
}

void planSolderMasks(const Document& document, std::vector<Plate>& plates) {
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& mask = document.layers[row];
        if (mask.type != LayerType::SolderMask || mask.context != LayerContext::Board) {
            continue;
        }
        Layer layer = plateLayer(mask.name + " solder mask", LayerType::SolderMask, mask.side, mask.z,
                                 mask.z + mask.thickness, mask.thicknessSource);
        layer.openings = LayerId{row};
        Plate plate{std::move(layer), mask.profile.isValid() ? mask.profile : document.profile, {}, {}, {}};
        plate.wholeLayers = {LayerId{row}};
        plate.openHoles = holesUnder(document, mask);
        plates.push_back(std::move(plate));
    }
}

bool isWithin(Point location, const PathNodes& contour) {
    int winding = 0;
    forEachEdge(contour, [&](const Edge& edge) { winding += windingAround(edge, toDouble(location)); });
    return winding != 0;
}

/// What the outline of a step encloses, its cut-outs filled: each island that lies in no other.
ShapeSketch filled(const ShapeTable& shapes, ShapeId outline) {
    std::vector<PathNodes> islands;
    for (const Contour& contour : shapes.contoursOf(outline)) {
        if (!contour.isHole) {
            islands.push_back(shapes.nodesOf(contour));
        }
    }
    ShapeSketch sketch;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        bool isInAnother = false;
        for (std::size_t j = 0; j < islands.size() && !isInAnother; ++j) {
            // Of two that are equal one stays.
            isInAnother = i != j && isWithin(islands[i][0].point, islands[j]) &&
                          (j < i || !isWithin(islands[j][0].point, islands[i]));
        }
        if (!isInAnother) {
            sketch.beginContour(false);
            sketch.addNodes(islands[i]);
        }
    }
    return sketch;
}

/// Cuts what a document and, below it, its copies take away. A copy with an outline is cut out with all that this
/// encloses: it has solids of its own, and its cut-outs are open in the panel too. One without lies on ours.
class PlateCutter {
public:
    explicit PlateCutter(const Plate& plate) : m_plate(plate) {}

    void take(const Document& document, const Placement& placement, bool isFlipped) {
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            takeLayer(document, LayerId{row}, placement, isFlipped);
        }
        for (const StepInstance& instance : document.instances) {
            const Document& step = *document.steps[instance.step];
            const Placement location = placement.after(instance.placement);
            if (step.profile.isValid()) {
                ShapeTable enclosed;
                const ShapeId outline = enclosed.add(filled(step.shapes, step.profile));
                m_cutouts.add(enclosed, outline, location);
            } else {
                take(step, location, isFlipped != instance.isFlipped);
            }
        }
    }
    [[nodiscard]] const Cutouts& cutouts() const { return m_cutouts; }

private:
    void takeLayer(const Document& document, LayerId id, const Placement& placement, bool isFlipped) {
        const LayerId own = document.layerOfCopy(id, isFlipped);
        const bool isWhole = std::ranges::find(m_plate.wholeLayers, own) != m_plate.wholeLayers.end();
        const bool isOpen = std::ranges::find(m_plate.openHoles, own) != m_plate.openHoles.end();
        const Range& range = document.layer(id).elements;
        for (std::uint32_t i = 0; (isWhole || isOpen) && i < range.count; ++i) {
            const ElementId element{range.first + i};
            if (isWhole || !isTented(document, element)) {
                m_cutouts.add(document, element, placement);
            }
        }
    }

    const Plate& m_plate;
    Cutouts m_cutouts;
};

/// A mask without any opening is taken for one the job says nothing about.
bool isUnknown(const Document& document, const Plate& plate) {
    return plate.layer.type == LayerType::SolderMask && document.layer(plate.wholeLayers[0]).elements.count == 0;
}

void cutPlate(const Document& document, Plate& plate, const base::Progress& progress) {
    if (!plate.outline.isValid() || isUnknown(document, plate)) {
        return;
    }
    PlateCutter cutter(plate);
    cutter.take(document, {}, false);
    plate.sketch = subtract(document.shapes, plate.outline, cutter.cutouts(), progress);
}

}  // namespace

bool isTented(const Document& document, ElementId hole) {
    const Box box = document.boxOf(hole);
    return (document.elements.flags[hole.row()] & kPlated) != 0 && std::min(box.width(), box.height()) <= kWidestTent;
}

bool addSolids(DocumentBuilder& builder, const base::Progress& progress) {
    const Document& document = builder.soFar();
    std::vector<Plate> plates;
    planBody(builder, plates);
    planSolderMasks(document, plates);
    base::parallelFor(plates.size(), [&](std::size_t i) { cutPlate(document, plates[i], progress); });
    for (Plate& plate : plates) {
        builder.beginLayer(builder.addLayer(std::move(plate.layer)));
        if (!plate.sketch.isEmpty()) {
            builder.addArea({builder.addShape(plate.sketch), {}}, {});
        }
    }
    setSyntheticOpposites(builder.layers());
    return !progress.isCancelled();
}

void placeSolids(Document& document) {
    const std::vector<SubstratePart> parts = substratesOf(document);
    auto part = parts.begin();
    for (Layer& layer : document.layers) {
        if (layer.type == LayerType::Body && layer.isSynthetic && part != parts.end()) {
            layer.z = part->bottom;
            layer.thickness = part->top - part->bottom;
            ++part;
        } else if (layer.type == LayerType::SolderMask && layer.isSynthetic) {
            const Layer& mask = document.layer(layer.openings);
            layer.z = mask.z;
            layer.thickness = mask.thickness;
        }
    }
    placeBodies(document);
}

}  // namespace model
