#include "model/solids/bodies.h"

#include <QtTest>

#include "model/board/stackup.h"

using model::ComponentId;
using model::Document;
using model::DocumentBuilder;
using model::ElementId;
using model::Layer;
using model::LayerSide;
using model::LayerType;
using model::Nm;
using model::Point;
using model::Source;

namespace {

constexpr Nm kMm = 1'000'000;

model::Box box(Nm x0, Nm y0, Nm x1, Nm y1) {
    return {{x0, y0}, {x1, y1}};
}

/// Copper from 0 to 1.6 mm, a mask of 25 µm on the top only.
struct Board {
    Board() {
        add(LayerType::SolderMask, LayerSide::Top, 1'600'000, 25'000);
        add(LayerType::Signal, LayerSide::Top, 1'565'000, 35'000);
        add(LayerType::Signal, LayerSide::Bottom, 0, 35'000);
    }

    void add(LayerType type, LayerSide side, Nm z, Nm thickness) {
        Layer layer;
        layer.type = type;
        layer.side = side;
        layer.z = z;
        layer.thickness = thickness;
        builder.addLayer(layer);
    }

    /// Drawn from (0, 0) to (2, 1) mm.
    model::PackageId drawnPackage() {
        model::ShapeSketch sketch;
        const Point corners[] = {{0, 0}, {2 * kMm, 0}, {2 * kMm, kMm}, {0, kMm}};
        sketch.addPolygon(corners, false);
        model::Package package;
        package.body = builder.addShape(sketch);
        return builder.addPackage(std::move(package), {});
    }

    ComponentId place(model::PackageId package, LayerSide side, Nm height, const model::Placement& placement = {}) {
        model::Component component;
        component.package = package;
        component.side = side;
        component.height = height;
        component.placement = placement;
        return builder.addComponent(std::move(component), {});
    }

    std::shared_ptr<const Document> finish(const model::TallestBodies& tallest) {
        model::addBodies(builder, tallest);
        return builder.finish();
    }

    DocumentBuilder builder;
};

std::uint64_t messages(const Document& document, std::string_view part) {
    std::uint64_t count = 0;
    for (const model::Diagnostic& entry : document.diagnostics.entries()) {
        count += entry.text.find(part) != std::string::npos ? entry.count : 0;
    }
    return count;
}

}  // namespace

class BodiesTest : public QObject {
    Q_OBJECT

private slots:
    void bodiesStandOnTheOutermostFaceOfTheirSide() {
        Board board;
        const model::PackageId package = board.drawnPackage();
        board.place(package, LayerSide::Top, 3 * kMm);
        board.place(package, LayerSide::Bottom, 2 * kMm);
        board.place(package, LayerSide::Top, kMm / 2);
        const auto d = board.finish({3 * kMm, 2 * kMm});
        QCOMPARE(d->bodies.size(), std::size_t{3});
        const auto heights = [&](std::size_t row) { return d->heightsOf(d->bodies[row].element); };
        QCOMPARE(heights(0).bottom, 1'625'000);
        QCOMPARE(heights(0).top, 4'625'000);
        QCOMPARE(heights(1).top, 2'125'000);
        QCOMPARE(heights(1).bottom, 1'625'000);
        QCOMPARE(d->bodies[1].component, ComponentId{2});
        // No mask on the bottom: they hang from the copper.
        QCOMPARE(heights(2).top, 0);
        QCOMPARE(heights(2).bottom, -2 * kMm);
        QCOMPARE(d->bodies[2].component, ComponentId{1});
        for (const model::Body& body : d->bodies) {
            const Layer& layer = d->layer(d->elements.layer[body.element.row()]);
            QVERIFY(layer.isSynthetic && layer.type == LayerType::ComponentBody);
            QCOMPARE(layer.side, d->components[body.component.row()].side);
            QCOMPARE(body.source, Source::Job);
            QCOMPARE(d->bodyOf(body.element), &body);
        }
        QVERIFY(d->diagnostics.entries().empty());
        QVERIFY(d->extent.isEmpty());
    }

    void outlinesAreTurnedAndMirroredAsTheComponentIs() {
        Board board;
        const model::PackageId package = board.drawnPackage();
        board.place(package, LayerSide::Bottom, kMm, {{10 * kMm, 20 * kMm}, 90.0, true});
        const auto d = board.finish({0, kMm});
        // Clockwise: (2, 1) -> (1, -2); then x is mirrored: (-1, -2).
        QCOMPARE(d->boxOf(d->bodies[0].element), box(9 * kMm, 18 * kMm, 10 * kMm, 20 * kMm));
        QVERIFY(!d->findLayer("component bodies top").isValid());
    }

    void whatIsNotStatedIsAssumedAndTold() {
        Board board;
        model::Package stated;
        stated.box = box(-kMm, -kMm, kMm, kMm);
        board.place(board.builder.addPackage(std::move(stated), {}), LayerSide::Top, 0);
        model::PackagePin pins[2];
        pins[1].position = {4 * kMm, 0};
        board.place(board.builder.addPackage({}, pins), LayerSide::Top, 0, {{kMm, 0}, 0.0, false});
        board.place(board.builder.addPackage({}, {}), LayerSide::Top, kMm);
        model::Pin pin;
        pin.position = {7 * kMm, 7 * kMm};
        board.builder.addComponent({}, std::span(&pin, 1));
        board.place({}, LayerSide::Top, 200 * kMm);
        const auto d = board.finish({model::kMostBody, 0});
        QCOMPARE(d->bodies.size(), std::size_t{3});
        QCOMPARE(d->boxOf(d->bodies[0].element), box(-kMm, -kMm, kMm, kMm));
        QCOMPARE(d->boxOf(d->bodies[1].element), box(750'000, -250'000, 5'250'000, 250'000));
        QCOMPARE(d->boxOf(d->bodies[2].element), box(6'750'000, 6'750'000, 7'250'000, 7'250'000));
        for (const model::Body& body : d->bodies) {
            QCOMPARE(body.height, model::kAssumedBody);
            QCOMPARE(body.source, Source::Assumed);
        }
        QCOMPARE(messages(*d, "no height"), std::uint64_t{3});
        QCOMPARE(messages(*d, "the box it states"), std::uint64_t{1});
        QCOMPARE(messages(*d, "the box of its pins"), std::uint64_t{2});
        QCOMPARE(messages(*d, "neither an outline nor pins"), std::uint64_t{2});
    }

    void aDotBetweenThePinsIsNoOutline() {
        Board board;
        model::Package package;
        model::ShapeSketch dot;
        const Point corners[] = {{0, 0}, {kMm, 0}, {kMm, kMm}, {0, kMm}};
        dot.addPolygon(corners, false);
        package.body = board.builder.addShape(dot);
        model::PackagePin pins[2];
        pins[0].position = {-2 * kMm, -2 * kMm};
        pins[1].position = {2 * kMm, 2 * kMm};
        board.place(board.builder.addPackage(package, pins), LayerSide::Top, kMm);
        // In one direction only it may well be smaller: a part with long leads.
        pins[0].position.y = pins[1].position.y = 0;
        board.place(board.builder.addPackage(package, pins), LayerSide::Top, kMm);
        const auto d = board.finish({kMm, 0});
        QCOMPARE(d->boxOf(d->bodies[0].element), box(-2'250'000, -2'250'000, 2'250'000, 2'250'000));
        QCOMPARE(d->boxOf(d->bodies[1].element), box(0, 0, kMm, kMm));
        QCOMPARE(messages(*d, "is a dot"), std::uint64_t{1});
    }

    void absurdHeightsAreCutAndUnpopulatedPartsHaveNoBody() {
        Board board;
        const model::PackageId package = board.drawnPackage();
        board.place(package, LayerSide::Top, 900 * kMm);
        model::Component absent;
        absent.package = package;
        absent.isPopulated = false;
        board.builder.addComponent(std::move(absent), {});
        board.place(package, LayerSide::Top, kMm, {{base::kMaxCoordinate, 0}, 0.0, false});
        const auto d = board.finish({model::bodyHeight(900 * kMm), 0});
        QCOMPARE(d->bodies.size(), std::size_t{1});
        QCOMPARE(d->bodies[0].height, model::kMostBody);
        QCOMPARE(messages(*d, "absurd"), std::uint64_t{1});
        QCOMPARE(messages(*d, "not populated"), std::uint64_t{1});
        QCOMPARE(messages(*d, "out of the coordinate range"), std::uint64_t{1});
    }

    void bodiesFollowTheFacesOfAChangedStack() {
        Board board;
        board.place(board.drawnPackage(), LayerSide::Top, kMm);
        board.place(board.drawnPackage(), LayerSide::Bottom, kMm);
        Document d = *board.finish({kMm, kMm});
        d.layers[0].z += 500'000;
        d.layers[2].z -= 100'000;
        model::placeBodies(d);
        QCOMPARE(d.heightsOf(d.bodies[0].element).bottom, 2'125'000);
        QCOMPARE(d.heightsOf(d.bodies[1].element).top, -100'000);
    }
};

QTEST_APPLESS_MAIN(BodiesTest)
#include "bodies_test.moc"
