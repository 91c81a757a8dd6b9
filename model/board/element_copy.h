#pragma once

#include <map>

#include "model/board/document_builder.h"

namespace model {

/// Copies elements from one document to the current layer of another, shared shapes once.
class ElementCopier {
public:
    /// Both must live as long as the copier.
    ElementCopier(DocumentBuilder& builder, const Document& from) : m_builder(builder), m_from(from) {}

    ElementId copy(ElementId element, const DocumentBuilder::Origin& origin);

private:
    [[nodiscard]] ShapeId shape(ShapeId shape);

    DocumentBuilder& m_builder;
    const Document& m_from;
    std::map<ShapeId, ShapeId> m_shapes;
};

}  // namespace model
