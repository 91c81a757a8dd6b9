// What bodies of components look like besides the prism that the document holds.
#include "render/modelling/body_details.h"

#include <QtTest>

#include "model/solids/bodies.h"

using model::Document;
using model::DocumentBuilder;
using model::LayerSide;
using model::Nm;
using model::Point;
using render::BodyDetails;

namespace {

constexpr Nm kMm = 1'000'000;

/// Two capacitors of one package on the top, one on the bottom.
std::shared_ptr<const Document> board() {
    DocumentBuilder builder;
    model::PackagePin pins[2];
    pins[0].position = {-2 * kMm, 0};
    pins[1].position = {2 * kMm, 0};
    const model::PackageId package = builder.addPackage({}, pins);
    const char* const names[] = {"C1", "C12", "C2"};
    for (int i = 0; i < 3; ++i) {
        model::Component component;
        component.refdes = names[i];
        component.package = package;
        component.height = kMm;
        component.side = i < 2 ? LayerSide::Top : LayerSide::Bottom;
        component.placement = {{10 * i * kMm, 0}, 90.0 * i, i == 2};
        builder.addComponent(std::move(component), {});
    }
    model::addBodies(builder, {kMm, kMm});
    return builder.finish();
}

std::size_t countOf(const BodyDetails& details, model::ElementId element, model::BodyMaterial material) {
    return static_cast<std::size_t>(std::ranges::count_if(details.parts(), [&](const BodyDetails::Part& part) {
        return part.element == element && part.material == material;
    }));
}

}  // namespace

class BodyDetailsTest : public QObject {
    Q_OBJECT

private slots:
    void partsBelongToTheElementOfTheirBody() {
        const auto d = board();
        BodyDetails details(*d);
        QCOMPARE(d->bodies.size(), std::size_t{3});
        const std::size_t letters[] = {2, 3, 2};
        for (std::size_t row = 0; row < 3; ++row) {
            const model::ElementId element = d->bodies[row].element;
            QCOMPARE(countOf(details, element, model::BodyMaterial::Metal), std::size_t{1});
            QCOMPARE(countOf(details, element, model::BodyMaterial::Print), letters[row]);
        }
    }

    void equalPartsShareAMesh() {
        const auto d = board();
        BodyDetails details(*d);
        std::vector<render::ShapeMesh> meshes(5);
        details.takeMeshes(meshes);
        // The ends of all three, and the characters C, 1 and 2.
        QCOMPARE(meshes.size(), std::size_t{5 + 1 + 3});
        for (const BodyDetails::Part& part : details.parts()) {
            QVERIFY(part.mesh >= 5 && part.mesh < meshes.size());
            QVERIFY(!meshes[part.mesh].polygons.polygons.empty());
        }
    }

    void printHasNoWalls() {
        const auto d = board();
        BodyDetails details(*d);
        std::vector<render::ShapeMesh> meshes;
        details.takeMeshes(meshes);
        base::Progress progress;
        render::triangulateShapes(meshes, {}, progress);
        for (const BodyDetails::Part& part : details.parts()) {
            const render::ShapeMesh& mesh = meshes[part.mesh];
            std::size_t walls = 0;
            for (std::uint32_t i = 0; i < mesh.next.size(); ++i) {
                walls += mesh.next[i] != i ? 1 : 0;
            }
            QVERIFY(!mesh.triangles.empty());
            QCOMPARE(walls, part.material == model::BodyMaterial::Print ? 0 : mesh.polygons.points.size());
        }
    }

    void designatorsAreReadFromTheSideTheyAreOn() {
        const auto d = board();
        const BodyDetails details(*d);
        for (const BodyDetails::Part& part : details.parts()) {
            if (part.material == model::BodyMaterial::Print) {
                const model::Body& body = *d->bodyOf(part.element);
                const bool isBottom = d->components[body.component.row()].side == LayerSide::Bottom;
                QCOMPARE(part.placement.isMirrored, isBottom);
                const Point at = part.placement.origin;
                QVERIFY(d->boxOf(part.element).holds(at));
                QCOMPARE(part.bottom, body.height);
            }
        }
    }

    void instancesOfBodiesHaveTheirMaterial() {
        const auto d = board();
        const BodyDetails details(*d);
        shader::AreaInstance instance{};
        details.paint(d->bodies[0].element, instance);
        QCOMPARE(instance.height, 1.0F);
        QCOMPARE(instance.material, static_cast<std::uint32_t>(model::BodyMaterial::Ceramic));
    }

    void aBoardWithoutComponentsHasNone() {
        DocumentBuilder builder;
        const auto d = builder.finish();
        BodyDetails details(*d);
        std::vector<render::ShapeMesh> meshes;
        details.takeMeshes(meshes);
        QVERIFY(details.parts().empty());
        QVERIFY(meshes.empty());
    }
};

QTEST_APPLESS_MAIN(BodyDetailsTest)
#include "body_details_test.moc"
