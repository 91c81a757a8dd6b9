#pragma once

#include <map>
#include <vector>

#include "model/board/document_builder.h"

namespace model::formats {

/// Where layers exist by the zones of a document (Document::zones), which must all be there before.
class ZoneOutlines {
public:
    explicit ZoneOutlines(DocumentBuilder& builder) : m_builder(builder) {}

    /// What the zones that have the layer cover together; zones that share an edge become one region. None if all or
    /// none of the zones with an outline have it: it is bounded by none of them.
    [[nodiscard]] ShapeId of(LayerId layer);

private:
    [[nodiscard]] ShapeId united(const std::vector<ShapeId>& shapes);

    DocumentBuilder& m_builder;
    std::map<std::vector<ShapeId>, ShapeId> m_unions;  ///< by the shapes that are united
};

/// Layer::outlineGroup by what decides where each layer exists, in all steps: a word per layer, the same for layers
/// with the same outline, empty for the board's.
[[nodiscard]] std::vector<std::uint32_t> outlineGroups(const std::vector<std::string>& keys);

}  // namespace model::formats
