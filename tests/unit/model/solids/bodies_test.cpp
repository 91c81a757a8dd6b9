#include "model/solids/bodies.h"

#include <QtTest>

#include "model/board/layers.h"
#include "model/board/stackup.h"
#include "model/geometry/outlines.h"
#include "model/solids/restack.h"
#include "model/solids/solids.h"
#include "tests/unit/model/hand_made.h"

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

/// Drawn from (0, 0) to (2, 1) mm, with a pin beside each of its short sides.
model::PackageId drawnPackage(DocumentBuilder& builder) {
    model::Package package;
    package.body = builder.addShape(hand_made::rectangle({0, 0}, {2 * kMm, kMm}));
    model::PackagePin pins[2];
    pins[0].position = {-kMm / 5, kMm / 2};
    pins[1].position = {2 * kMm + kMm / 5, kMm / 2};
    return builder.addPackage(std::move(package), pins);
}

/// Copper from 0 to 1.6 mm, a mask of 25 µm on the top only.
struct Board {
    Board() {
        hand_made::addLayer(builder, LayerType::SolderMask, LayerSide::Top, 1'600'000, 25'000);
        hand_made::addLayer(builder, LayerType::Signal, LayerSide::Top, 1'565'000, 35'000);
        hand_made::addLayer(builder, LayerType::Signal, LayerSide::Bottom, 0, 35'000);
    }

    /// A board of 40 by 40 mm.
    void addProfile() { builder.setProfile(builder.addShape(hand_made::rectangle({0, 0}, {40 * kMm, 40 * kMm}))); }

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

/// A board of 40 by 20 mm: four copper layers all along to x = 20 mm, beyond it only the inner ones and what is
/// between.
struct Zones {
    Zones() {
        builder.setProfile(outline(40 * kMm));
        const model::ShapeId rigid = outline(20 * kMm);
        model::StackupFacts facts;
        const auto add = [&](const char* name, LayerType type, double thickness, bool isRigid) {
            Layer layer;
            layer.name = name;
            layer.type = type;
            layer.outlineGroup = isRigid ? 1 : 0;
            layer.profile = isRigid ? rigid : model::ShapeId{};
            layers.push_back(layer);
            facts.layers.emplace_back().thicknessNm = thickness;
        };
        add("mask", LayerType::SolderMask, 20'000, true);
        add("l1", LayerType::Signal, 35'000, true);
        add("d1", LayerType::Dielectric, 200'000, true);
        add("l2", LayerType::Signal, 18'000, false);
        add("d2", LayerType::Dielectric, 100'000, false);
        add("l3", LayerType::Signal, 18'000, false);
        add("d3", LayerType::Dielectric, 200'000, true);
        add("l4", LayerType::Signal, 35'000, true);
        model::Stackup stackup = model::buildStackup(layers, std::move(facts), builder.diagnostics());
        builder.setBoardThickness(model::thicknessOf(stackup));
        builder.setStackup(std::move(stackup));
        for (const Layer& layer : layers) {
            builder.addLayer(layer);
        }
    }

    model::ShapeId outline(Nm right) { return builder.addShape(hand_made::rectangle({0, 0}, {right, 20 * kMm})); }

    void place(model::PackageId package, LayerSide side, Nm height, const model::Placement& placement) {
        model::Component component;
        component.package = package;
        component.side = side;
        component.height = height;
        component.placement = placement;
        builder.addComponent(std::move(component), {});
    }

    std::shared_ptr<const Document> finish(const model::TallestBodies& tallest) {
        const base::Progress progress;
        (void)model::addSolids(builder, progress);
        model::addBodies(builder, tallest);
        return builder.finish();
    }

    DocumentBuilder builder;
    std::vector<Layer> layers;
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
        const model::PackageId package = drawnPackage(board.builder);
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
        const model::PackageId package = drawnPackage(board.builder);
        board.place(package, LayerSide::Bottom, kMm, {{10 * kMm, 20 * kMm}, 90.0, true});
        const auto d = board.finish({0, kMm});
        // Clockwise: (2, 1) -> (1, -2); then x is mirrored: (-1, -2).
        QCOMPARE(d->boxOf(d->bodies[0].element), box(9 * kMm, 18 * kMm, 10 * kMm, 20 * kMm));
        QVERIFY(!d->findLayer("bodies top").isValid());
    }

    void whatIsNotStatedIsAssumedAndTold() {
        Board board;
        model::PackagePin pins[2];
        pins[1].position = {4 * kMm, 0};
        board.place(board.builder.addPackage({}, pins), LayerSide::Top, 0, {{kMm, 0}, 0.0, false});
        model::Pin placed[2];
        placed[0].position = {7 * kMm, 7 * kMm};
        placed[1].position = {7 * kMm, 9 * kMm};
        board.builder.addComponent({}, placed);
        const auto d = board.finish({model::kMostBody, 0});
        QCOMPARE(d->bodies.size(), std::size_t{2});
        QCOMPARE(d->boxOf(d->bodies[0].element).middle(), (Point{3 * kMm, 0}));
        QCOMPARE(d->boxOf(d->bodies[1].element).middle(), (Point{7 * kMm, 8 * kMm}));
        for (const model::Body& body : d->bodies) {
            QVERIFY(body.height > 0 && body.height < kMm);
            QCOMPARE(body.source, Source::Assumed);
        }
        QCOMPARE(messages(*d, "gives no height"), std::uint64_t{2});
        QCOMPARE(messages(*d, "package has no outline"), std::uint64_t{2});
    }

    void whatIsNotTheBodyAsDrawnIsTold_data() {
        QTest::addColumn<Nm>("beyond");
        QTest::addColumn<bool>("isDrawn");
        QTest::addColumn<QString>("message");
        QTest::addRow("the body") << -kMm << true << QString();
        QTest::addRow("a courtyard") << kMm << true << QString("holds more than its body");
        QTest::addRow("a box that is stated") << -kMm << false << QString("draws no outline");
    }
    void whatIsNotTheBodyAsDrawnIsTold() {
        QFETCH(Nm, beyond);
        QFETCH(bool, isDrawn);
        QFETCH(QString, message);
        Board board;
        model::PackagePin pins[2];
        pins[0].position = {-2 * kMm, 0};
        pins[1].position = {2 * kMm, 0};
        const model::Box outline = box(-2 * kMm - beyond, -kMm, 2 * kMm + beyond, kMm);
        model::Package package;
        if (isDrawn) {
            model::ShapeSketch sketch;
            model::addBox(sketch, outline);
            package.body = board.builder.addShape(sketch);
        } else {
            package.box = outline;
        }
        board.place(board.builder.addPackage(std::move(package), pins), LayerSide::Top, kMm);
        const auto d = board.finish({kMm, 0});
        QCOMPARE(d->bodies.size(), std::size_t{1});
        QCOMPARE(d->diagnostics.entries().size(), message.isEmpty() ? std::size_t{0} : std::size_t{1});
        if (!message.isEmpty()) {
            const model::Diagnostic& told = d->diagnostics.entries().front();
            QVERIFY2(told.text.find(message.toStdString()) != std::string::npos, told.text.c_str());
            QCOMPARE(told.severity, model::Severity::Info);
        }
    }

    void whatOnlyIsCopperHasNoBody() {
        Board board;
        model::Package stated;
        stated.box = box(-kMm, -kMm, kMm, kMm);
        board.place(board.builder.addPackage(std::move(stated), {}), LayerSide::Top, kMm);
        board.place({}, LayerSide::Top, kMm);
        model::PackagePin pin;
        board.place(board.builder.addPackage({}, {&pin, 1}), LayerSide::Top, 0);
        const auto d = board.finish({kMm, 0});
        QVERIFY(d->bodies.empty());
        QCOMPARE(messages(*d, "without pins"), std::uint64_t{2});
        QCOMPARE(messages(*d, "bare copper or a hole"), std::uint64_t{1});
    }

    void aBoardWithoutComponentsHasNoLayersOfBodies() {
        Board board;
        const auto d = board.finish({});
        QVERIFY(d->bodies.empty());
        QCOMPARE(d->layers.size(), std::size_t{3});
        QVERIFY(d->diagnostics.entries().empty());
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
        const auto d = board.finish({kMm, 0});
        QVERIFY(d->boxOf(d->bodies[0].element).width() > 3 * kMm);
        QCOMPARE(messages(*d, "is a dot between its pins"), std::uint64_t{1});
    }

    void whatCoversTheBoardIsNoBody() {
        Board board;
        board.addProfile();
        model::ShapeSketch sketch;
        const Point corners[] = {{0, 0}, {39 * kMm, 0}, {39 * kMm, 20 * kMm}, {0, 20 * kMm}};
        sketch.addPolygon(corners, false);
        model::Package package;
        package.body = board.builder.addShape(sketch);
        model::PackagePin pins[3];
        pins[0].position = {kMm, kMm};
        pins[1].position = {38 * kMm, kMm};
        pins[2].position = {20 * kMm, 19 * kMm};
        const model::PackageId card = board.builder.addPackage(std::move(package), pins);
        model::Component component;
        component.refdes = "J1";
        component.package = card;
        board.builder.addComponent(component, {});
        // A module may be as large: then its height is known.
        component.height = 11 * kMm;
        board.builder.addComponent(component, {});
        const auto d = board.finish({11 * kMm, 0});
        QCOMPARE(d->bodies.size(), std::size_t{1});
        QCOMPARE(d->bodies[0].component, ComponentId{1});
        QCOMPARE(messages(*d, "more than 40 %"), std::uint64_t{1});
    }

    void cardsOverOtherComponentsDoNotHideThem_data() {
        QTest::addColumn<int>("below");
        QTest::addColumn<Nm>("height");
        QTest::addColumn<bool>("isThere");
        QTest::addRow("two") << 2 << Nm{0} << true;
        QTest::addRow("three") << 3 << Nm{0} << false;
        QTest::addRow("three, and a height") << 3 << Nm{4 * kMm} << true;
    }
    void cardsOverOtherComponentsDoNotHideThem() {
        QFETCH(int, below);
        QFETCH(Nm, height);
        QFETCH(bool, isThere);
        Board board;
        model::PackagePin corners[3];
        corners[0].position = {0, 0};
        corners[1].position = {30 * kMm, 0};
        corners[2].position = {15 * kMm, 20 * kMm};
        board.place(board.builder.addPackage({}, corners), LayerSide::Top, height);
        for (int i = 0; i < below; ++i) {
            model::Pin pins[2];
            pins[0].position = {(10 + 3 * i) * kMm, 5 * kMm};
            pins[1].position = {(11 + 3 * i) * kMm, 5 * kMm};
            board.builder.addComponent({}, pins);
        }
        const auto d = board.finish({12 * kMm, 0});
        QCOMPARE(d->bodies.size(), static_cast<std::size_t>(below) + (isThere ? 1 : 0));
        QCOMPARE(messages(*d, "lies over other components"), std::uint64_t{isThere ? 0U : 1U});
    }

    void partsStandOnTheOutermostLayerOfTheirZone() {
        Zones board;
        const model::PackageId package = drawnPackage(board.builder);
        board.place(package, LayerSide::Top, kMm, {{10 * kMm, 10 * kMm}});
        board.place(package, LayerSide::Top, 2 * kMm, {{24 * kMm, 10 * kMm}});
        board.place(package, LayerSide::Bottom, kMm, {{24 * kMm, 10 * kMm}});
        const auto d = board.finish({2 * kMm, kMm});
        QStringList names;
        for (const Layer& layer : d->layers) {
            if (layer.type == LayerType::ComponentBody) {
                names << QString::fromStdString(layer.name);
            }
        }
        QCOMPARE(names, QStringList({"bodies top", "bodies top on l2", "bodies bottom on l3"}));
        const auto heights = [&](std::size_t component) {
            const auto body = std::ranges::find(d->bodies, ComponentId{component}, &model::Body::component);
            return d->heightsOf(body->element);
        };
        const auto mountingLayer = [&](std::size_t component) {
            const auto body = std::ranges::find(d->bodies, ComponentId{component}, &model::Body::component);
            const model::LayerId layer = mountingLayerOf(*d, *body);
            return layer.isValid() ? d->layer(layer).name : std::string();
        };
        QCOMPARE(mountingLayer(0), std::string());
        QCOMPARE(mountingLayer(1), std::string("l2"));
        QCOMPARE(mountingLayer(2), std::string("l3"));
        const Layer& l2 = d->layer(d->findLayer("l2"));
        const Layer& l3 = d->layer(d->findLayer("l3"));
        QCOMPARE(heights(0).bottom, d->boardThickness + 20'000);
        QCOMPARE(heights(1).bottom, l2.z + l2.thickness);
        QCOMPARE(heights(1).top, l2.z + l2.thickness + 2 * kMm);
        QCOMPARE(heights(2).top, l3.z);
        // After thicknesses were changed too.
        const auto changed = model::restack(*d, {{"l2", 70'000}, {"d3", 400'000}});
        const Layer& thicker = changed->layer(changed->findLayer("l2"));
        QCOMPARE(thicker.thickness, 70'000);
        QCOMPARE(changed->heightsOf(d->bodies[1].element).bottom, thicker.z + thicker.thickness);
    }

    void stepsOfOnePanelHaveTheSameLayersOfBodies() {
        Zones board;
        const auto d = board.finish({2 * kMm, kMm, false});
        QCOMPARE(d->layers.back().name, std::string("bodies bottom on l3"));
        const Layer& top = d->layer(d->findLayer("bodies top"));
        QCOMPARE(top.opposite, d->findLayer("bodies bottom"));
        QCOMPARE(d->layer(top.opposite).opposite, d->findLayer("bodies top"));
        QCOMPARE(std::ranges::count(d->layers, LayerType::ComponentBody, &Layer::type), std::ptrdiff_t{4});
    }

    void absurdHeightsAreNotBelievedAndUnpopulatedPartsHaveNoBody() {
        Board board;
        const model::PackageId package = drawnPackage(board.builder);
        board.place(package, LayerSide::Top, 900 * kMm);
        model::Component absent;
        absent.package = package;
        absent.isPopulated = false;
        board.builder.addComponent(std::move(absent), {});
        board.place(package, LayerSide::Top, kMm, {{base::kMaxCoordinate, 0}, 0.0, false});
        const auto d = board.finish({kMm, 0});
        QCOMPARE(d->bodies.size(), std::size_t{1});
        QVERIFY(d->bodies[0].height < 3 * kMm);
        QCOMPARE(d->bodies[0].source, Source::Assumed);
        QCOMPARE(messages(*d, "below 0.1 or above 150 mm"), std::uint64_t{1});
        QCOMPARE(messages(*d, "not populated"), std::uint64_t{1});
        QCOMPARE(messages(*d, "out of the coordinate range"), std::uint64_t{1});
    }

    void bodiesFollowTheFacesOfAChangedStack() {
        Board board;
        board.place(drawnPackage(board.builder), LayerSide::Top, kMm);
        board.place(drawnPackage(board.builder), LayerSide::Bottom, kMm);
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
