#pragma once

#include <vector>

#include "model/packages/body_plan.h"
#include "render/modelling/area_meshes.h"
#include "shaders/shared/board.h"

namespace render {

/// What bodies of components look like besides the prism that the document holds: leads, terminals, pins, marks and
/// designators. All of it belongs to the body's element: it is highlighted, hidden and found as one.
class BodyDetails {
public:
    explicit BodyDetails(const model::Document& document);

    /// Appends a mesh of each kind of part and character, in package coordinates; each is made once. Characters know
    /// already that they have no walls (ShapeMesh::next): print has no height to see.
    void takeMeshes(std::vector<ShapeMesh>& meshes);

    /// Gives the instance of a body its own height and material. What is no body stays as it is.
    void paint(model::ElementId element, shader::AreaInstance& instance) const;

    /// A part of a body: a mesh laid on the board.
    struct Part {
        model::ElementId element;
        std::uint32_t mesh = 0;
        model::Placement placement;
        model::Nm bottom = 0;  ///< from the face the body stands on, upwards
        model::Nm top = 0;
        model::BodyMaterial material = model::BodyMaterial::Moulding;
    };
    /// By element, rising.
    [[nodiscard]] const std::vector<Part>& parts() const { return m_parts; }

private:
    /// What a plan becomes.
    struct Made {
        model::Nm top = 0;
        model::BodyMaterial material = model::BodyMaterial::Moulding;
    };

    void addParts(const model::Body& body, const model::BodyPlan& plan);
    void addDesignator(const model::Body& body, const model::BodyPlan& plan);

    const model::Document& m_document;
    std::vector<Made> m_made;  ///< by body
    /// What becomes a mesh.
    struct Shape {
        model::PolygonSet polygons;
        bool isPrint = false;
    };
    std::vector<Shape> m_shapes;
    std::vector<Part> m_parts;  ///< their mesh counts from the first of `m_shapes` until meshes are taken
    std::map<const model::BodyPart*, std::uint32_t> m_shapeOfPart;
    std::map<std::pair<char32_t, model::Nm>, std::uint32_t> m_shapeOfCharacter;
};

/// Sets what an instance has from a part beside its mesh and its place.
void describePart(const BodyDetails::Part& part, shader::AreaInstance& instance);

}  // namespace render
