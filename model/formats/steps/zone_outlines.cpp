#include "model/formats/steps/zone_outlines.h"

#include "model/geometry/boolean.h"
#include "model/geometry/region.h"

namespace model::formats {

ShapeId ZoneOutlines::of(LayerId layer) {
    std::vector<ShapeId> shapes;
    bool isMixed = false;
    for (const Zone& zone : m_builder.soFar().zones) {
        if (zone.shape.isValid() && zone.has(layer)) {
            shapes.push_back(zone.shape);
        }
        isMixed = isMixed || (zone.shape.isValid() && !zone.has(layer));
    }
    if (!isMixed || shapes.empty()) {
        return {};
    }
    const auto [location, isNew] = m_unions.try_emplace(shapes);
    if (isNew) {
        location->second = shapes.size() == 1 ? shapes.front() : united(shapes);
    }
    return location->second;
}

ShapeId ZoneOutlines::united(const std::vector<ShapeId>& shapes) {
    PolygonSet all;
    for (const ShapeId shape : shapes) {
        all.append(discretise(m_builder.shapes(), shape, kBooleanChords));
    }
    const ShapeSketch sketch = sketchOf(unite(all));
    return sketch.isEmpty() ? ShapeId{} : m_builder.addShape(sketch);
}

std::vector<std::uint32_t> outlineGroups(const std::vector<std::string>& keys) {
    std::map<std::string, std::uint32_t> groups;
    std::vector<std::uint32_t> result;
    for (const std::string& key : keys) {
        const auto next = static_cast<std::uint32_t>(groups.size() + 1);
        result.push_back(key.empty() ? 0 : groups.try_emplace(key, next).first->second);
    }
    return result;
}

}  // namespace model::formats
