#include "render/modelling/body_details.h"

#include <numeric>

#include "model/packages/designator.h"

namespace render {

namespace {

static_assert(model::kBodyMaterialCount == shader::kMaterialCount + 1);

float millimetres(model::Nm length) {
    return static_cast<float>(base::toMm(length));
}

}  // namespace

BodyDetails::BodyDetails(const model::Document& document) : m_document(document) {
    model::BodyPlans plans(document);
    for (const model::Body& body : document.bodies) {
        const model::BodyPlan* plan = body.component.isValid() ? &plans.of(body.component) : nullptr;
        if (plan == nullptr || plan->box.isEmpty()) {
            // The document may have a body that no plan was made for: it is drawn as it is.
            m_made.push_back({body.height, model::BodyMaterial::Moulding});
            continue;
        }
        m_made.push_back({plan->bodyTop, plan->material});
        addParts(body, *plan);
        addDesignator(body, *plan);
    }
}

void BodyDetails::addParts(const model::Body& body, const model::BodyPlan& plan) {
    const model::Component& component = m_document.components[body.component.row()];
    const model::Placement placement = component.package.isValid() ? component.placement : model::Placement{};
    for (const model::BodyPart& part : plan.parts) {
        const auto [found, isNew] = m_shapeOfPart.try_emplace(&part, static_cast<std::uint32_t>(m_shapes.size()));
        if (isNew) {
            m_shapes.push_back({part.polygons});
        }
        m_parts.push_back({body.element, found->second, placement, part.bottom, part.top, part.material});
    }
}

void BodyDetails::addDesignator(const model::Body& body, const model::BodyPlan& plan) {
    const model::Component& component = m_document.components[body.component.row()];
    for (const model::PrintedCharacter& printed : model::printDesignator(component, plan)) {
        const auto [found, isNew] = m_shapeOfCharacter.try_emplace({printed.character, printed.height},
                                                                   static_cast<std::uint32_t>(m_shapes.size()));
        if (isNew) {
            m_shapes.push_back({model::characterStrokes(printed.character, printed.height), true});
        }
        if (!m_shapes[found->second].polygons.polygons.empty()) {
            m_parts.push_back({body.element, found->second, printed.placement, plan.bodyTop,
                               plan.bodyTop + model::kPrint, model::printOn(plan.material)});
        }
    }
}

void BodyDetails::takeMeshes(std::vector<ShapeMesh>& meshes) {
    const auto first = static_cast<std::uint32_t>(meshes.size());
    for (Shape& shape : m_shapes) {
        ShapeMesh& mesh = meshes.emplace_back();
        mesh.polygons = std::move(shape.polygons);
        if (shape.isPrint) {
            mesh.next.resize(mesh.polygons.points.size());
            std::iota(mesh.next.begin(), mesh.next.end(), 0U);
        }
    }
    for (Part& part : m_parts) {
        part.mesh += first;
    }
    m_shapes.clear();
    m_shapeOfPart.clear();
    m_shapeOfCharacter.clear();
}

void BodyDetails::paint(model::ElementId element, shader::AreaInstance& instance) const {
    if (const model::Body* body = m_document.bodyOf(element)) {
        const Made& made = m_made[static_cast<std::size_t>(body - m_document.bodies.data())];
        instance.height = millimetres(made.top);
        instance.material = static_cast<std::uint32_t>(made.material);
    }
}

void describePart(const BodyDetails::Part& part, shader::AreaInstance& instance) {
    instance.element = part.element.value;
    instance.floor = millimetres(part.bottom);
    instance.height = millimetres(part.top);
    instance.material = static_cast<std::uint32_t>(part.material);
}

}  // namespace render
